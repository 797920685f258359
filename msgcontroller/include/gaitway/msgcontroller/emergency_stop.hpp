// The emergency stop: sent until every joint has confirmed it, and held until somebody deliberately releases
// it.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/can/messages.hpp"
#include "gaitway/msgclient/mails.hpp"
#include "gaitway/msgcontroller/bus_link.hpp"

namespace gaitway::msgcontroller {

//            stop()                     release()                  every joint confirms
//   free ──────────────▶ stopped ──────────────────▶ releasing ─────────────────────────▶ free
//                           ◀──────────────────────────┘
//                             stop(), or a joint that does not confirm in time
// While it is not free, the mode is emergency_stop and nothing is played.
class EmergencyStop {
 public:
  explicit EmergencyStop(BusLink& link) noexcept : link_(link) {}

  // A stop that holds already is repeated by supervise(), until each joint has confirmed it: many requests
  // load the bus no more than one. What has gone soft stays so.
  void stop(bool soft) noexcept;
  // Neither free nor being released.
  [[nodiscard]] bool holds() const noexcept { return phase_ == Phase::stopped; }
  // Sends the stop, or its release, once more, as when somebody else has sent one, or after a time off the
  // bus.
  void repeat() noexcept;
  // Takes back the stop: the joints hold where they are measured. Refused while nothing is stopped, and while
  // a joint is missing, which would stay stopped alone. What becomes of it: take_outcome().
  msgclient::Reason release() noexcept;
  // A joint's feedback while it is not free, and where it is measured.
  void supervise(int joint, const can::Feedback& feedback, double measured_rad) noexcept;

  enum class Outcome : std::uint8_t { none, released, failed };
  // At the edge of a slot: what has become of a release, once. After `failed` the robot is stopped as before.
  [[nodiscard]] Outcome take_outcome() noexcept;
  // The reference count of a released joint.
  [[nodiscard]] std::int32_t released_count(int joint) const noexcept {
    return released_count_[static_cast<std::size_t>(joint)];
  }

 private:
  enum class Phase : std::uint8_t { free, stopped, releasing };
  void send(can::StopMode mode) noexcept;
  void confirm(std::size_t joint, std::uint8_t reference_low, double measured_rad) noexcept;
  [[nodiscard]] bool all_confirmed() const noexcept;

  BusLink& link_;
  Phase phase_ = Phase::free;
  bool soft_ = false;                         // the stop that holds
  bool failed_ = false;                       // the release
  std::uint32_t sent_in_slot_ = 0;            // slot since start in which a stop or a release was last sent
  std::uint32_t release_until_ = 0;           // slot since start
  std::array<bool, kMaxJoints> confirmed_{};  // the release
  std::array<std::int32_t, kMaxJoints> released_count_{};
};

}  // namespace gaitway::msgcontroller

// The trim frame of every time slot: the main controller's, or the message controller's own when that is
// silent.
#pragma once

#include <cstdint>
#include <span>

#include "gaitway/msgclient/mails.hpp"
#include "gaitway/msgclient/trim_law.hpp"
#include "gaitway/msgcontroller/bus_link.hpp"
#include "gaitway/msgcontroller/feedback_collector.hpp"

namespace gaitway::msgcontroller {

class TrimSender {
 public:
  TrimSender(const urdf::RobotModel& robot, BusLink& link) : link_(link), settings_(robot.trim) {}

  void begin_slot() noexcept { sent_in_this_slot_ = false; }
  // The main controller's trims; what is not finite counts as not come.
  void take(const msgclient::TrimUpdate& update) noexcept;
  // Once a millisecond: makes its own, by the gains of the batch that was accepted last, when the main
  // controller has sent none for too long. `heard`: this slot's feedback is in `imu`.
  void stand_in(std::int64_t in_slot_ns, bool heard, const FeedbackCollector& feedback,
                std::uint8_t support) noexcept;
  void set_gains(const msgclient::TrimGains& gains) noexcept { gains_ = gains; }
  // Gains and softness of before: as at the start.
  void forget() noexcept {
    gains_ = {};
    softness_ = 0;
  }
  // Of all joints, as heard last: a main controller that falls silent leaves it.
  [[nodiscard]] std::uint8_t softness() const noexcept { return softness_; }

 private:
  void send(std::span<const double> angle_rad) noexcept;

  BusLink& link_;
  urdf::TrimSettings settings_;
  msgclient::TrimGains gains_{};
  std::uint8_t softness_ = 0;
  bool sent_in_this_slot_ = false;
  std::uint32_t last_taken_slot_ = 0;  // since start
};

}  // namespace gaitway::msgcontroller

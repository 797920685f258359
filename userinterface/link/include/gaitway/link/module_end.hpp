// The user interface module's end of the link: gives orders and stops, and mirrors the robot's state.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/link/link_end.hpp"
#include "gaitway/link/order.hpp"
#include "gaitway/link/state_receiver.hpp"
#include "gaitway/link/stop_slot.hpp"

namespace gaitway::link {

struct Submission {
  Refusal refusal = Refusal::none;
  OrderId id;  // if it was taken: it has exactly one outcome, sooner or later
};

struct Outcome {
  OrderId id;
  Verdict verdict = Verdict::unanswered;
  std::uint16_t result = 0;  // of an answered one
  Bytes payload;             // of an answered one; valid until anything else is called
};

class ModuleEnd final : public LinkEnd {
 public:
  // The identity's role is that of the module. Allocates; throws std::invalid_argument as LinkEnd and
  // StateSender do.
  ModuleEnd(LinkIdentity identity, std::span<const Channel> channels, const LinkSettings& settings);

  // An order that may be carried out until `expiry_ns` of the robot's time, and not later.
  Submission submit(std::uint16_t kind, Bytes payload, std::int64_t expiry_ns, std::int64_t now_ns) noexcept;
  // What became of orders; nothing when there is no news. An order's place is free once its outcome was
  // fetched.
  std::optional<Outcome> next_outcome(std::int64_t now_ns) noexcept;

  // At most what the robot's clock shows, so that an order counted from it never lives longer than meant.
  // Nothing without a session.
  [[nodiscard]] std::optional<std::int64_t> robot_time_ns(std::int64_t now_ns) const noexcept {
    return peer_time_ns(now_ns);
  }

  // The robot's clock as it was told last: it does not go on by itself. Nothing without a session.
  [[nodiscard]] std::optional<std::int64_t> robot_clock_ns() const noexcept { return peer_clock_ns(); }

  // Always taken: see StopAsker.
  void stop(StopKind kind) noexcept { stops_.ask(kind); }
  [[nodiscard]] const StopAsker& stops() const noexcept { return stops_; }

  [[nodiscard]] StateReceiver& state() noexcept { return state_; }
  [[nodiscard]] const StateReceiver& state() const noexcept { return state_; }

 private:
  struct OpenOrder {
    enum class Stage : std::uint8_t { free, waiting, settled };
    Stage stage = Stage::free;
    OrderId id;
    std::int64_t give_up_ns = 0;  // the module's time
    Verdict verdict = Verdict::unanswered;
    std::uint16_t result = 0;
    std::array<std::uint8_t, kMostAnswerBytes> payload{};
    std::size_t payload_bytes = 0;
  };

  std::size_t make_urgent(Room room, std::int64_t now_ns) noexcept override;
  void fill(Status& status) noexcept override;
  bool confirmation_due(std::int64_t since_status_ns) const noexcept override;
  bool on_frame(FrameKind kind, Bytes content, std::int64_t now_ns) noexcept override;
  void on_message(Bytes message, std::int64_t now_ns) noexcept override;
  void on_session_begin() noexcept override;
  void on_session_end() noexcept override;
  std::uint32_t message_limit() const noexcept override;

  std::int64_t answer_limit_ns_, confirm_after_ns_;
  std::size_t confirm_at_;
  std::array<OpenOrder, kMostOpenOrders> open_{};
  StopAsker stops_;
  StateReceiver state_;
};

}  // namespace gaitway::link

// The main controller's end of the link: gets orders and stops, answers them, and publishes the robot's
// state.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/link/link_end.hpp"
#include "gaitway/link/order.hpp"
#include "gaitway/link/state_sender.hpp"
#include "gaitway/link/stop_slot.hpp"

namespace gaitway::link {

struct Order {
  OrderId id;  // `session` is this end's own count
  std::uint16_t kind = 0;
  std::int64_t expiry_ns = 0;  // not yet reached
  Bytes payload;               // valid until anything else is called
};

class ControllerEnd final : public LinkEnd {
 public:
  // The identity's role is that of the controller. Allocates; throws std::invalid_argument as LinkEnd and
  // StateSender do.
  ControllerEnd(LinkIdentity identity, std::span<const Channel> channels, const LinkSettings& settings);

  // What the robot's clock shows at `now_ns` of the own one, by which expiries are judged. Until this is
  // told, the own clock is the robot's.
  void set_robot_time(std::int64_t robot_ns, std::int64_t now_ns) noexcept {
    set_shown_clock(robot_ns, now_ns);
  }

  // The next order to be carried out now; each comes once, in the order in which they were given. Those that
  // are late are answered so, and left out. After the end of a session nothing of it comes any more.
  std::optional<Order> next_order(std::int64_t now_ns) noexcept;
  // What became of it. Every order wants one, at any time and in any sequence: until then it takes up one of
  // kMostOpenOrders places. False: its session is over, so the module has been told that it is unanswered; or
  // it was answered already; or the payload is longer than kMostAnswerBytes.
  bool answer(OrderId id, std::uint16_t result, Bytes payload) noexcept;

  // How many stops were asked for since this was made, and which of them are obeyed: see StopListener.
  [[nodiscard]] const StopCounts& stops_asked() const noexcept { return stops_.asked(); }
  [[nodiscard]] const StopCounts& stops_heard() const noexcept { return stops_.heard(); }
  void stops_obeyed(const StopCounts& obeyed) noexcept { stops_.obeyed(obeyed); }

  // The newest value of a channel: see StateSender::publish.
  bool publish(std::size_t channel, Bytes value, std::int64_t stamp_ns) noexcept {
    return state_.publish(channel, value, stamp_ns);
  }
  [[nodiscard]] const StateSender& state() const noexcept { return state_; }
  [[nodiscard]] std::uint64_t late_orders() const noexcept { return late_orders_; }
  [[nodiscard]] std::uint32_t fetched_orders() const noexcept { return fetched_; }  // of this session

 private:
  struct Waiting {
    std::array<std::uint8_t, kMostMessageBytes> message{};
    std::size_t size = 0;
  };

  std::size_t make_urgent(Room room, std::int64_t now_ns) noexcept override;
  std::size_t make_state(Room room, std::int64_t now_ns) noexcept override;
  bool on_frame(FrameKind kind, Bytes content, std::int64_t now_ns) noexcept override;
  void on_message(Bytes message, std::int64_t now_ns) noexcept override;
  void on_status(const Status& status, std::int64_t now_ns) noexcept override;
  void on_session_begin() noexcept override;
  void on_session_end() noexcept override;
  std::uint32_t message_limit() const noexcept override;
  void push_answer(std::uint32_t number, Verdict verdict, std::uint16_t result, Bytes payload) noexcept;

  // Orders that arrived and were not fetched: numbers fetched_ + 1 .. arrived_.
  std::array<Waiting, kMostOpenOrders> waiting_{};
  std::uint32_t arrived_ = 0, fetched_ = 0;
  // Numbers of those that were fetched and not answered; 0: a free place.
  std::array<std::uint32_t, kMostOpenOrders> unanswered_{};
  StopListener stops_;
  StateSender state_;
  std::uint64_t late_orders_ = 0;
};

}  // namespace gaitway::link

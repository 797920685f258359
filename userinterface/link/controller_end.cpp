// Orders wait here until they are fetched; late ones end here.
#include "gaitway/link/controller_end.hpp"

#include <algorithm>
#include <limits>

#include "gaitway/link/byte_order.hpp"

namespace gaitway::link {
namespace {

LinkIdentity as_controller(LinkIdentity identity) noexcept {
  identity.role = Role::controller;
  return identity;
}

}  // namespace

ControllerEnd::ControllerEnd(LinkIdentity identity, std::span<const Channel> channels,
                             const LinkSettings& settings)
    : LinkEnd(as_controller(identity), settings), state_(channels, settings) {}

std::optional<Order> ControllerEnd::next_order(std::int64_t now_ns) noexcept {
  step(now_ns);
  while (fetched_ != arrived_) {
    const std::uint32_t number = ++fetched_;
    const Waiting& waiting = waiting_[number % kMostOpenOrders];
    ByteReader in(Bytes(waiting.message).first(waiting.size));
    const auto expiry_ns = in.get<std::int64_t>();
    const auto kind = in.get<std::uint16_t>();
    const Bytes payload = in.get_rest();
    if (!in.ok() || shown_ns(now_ns) > expiry_ns) {
      ++late_orders_;
      push_answer(number, Verdict::late, 0, {});
      continue;
    }
    *std::ranges::find(unanswered_, 0U) = number;
    return Order{{session().count(), number}, kind, expiry_ns, payload};
  }
  return std::nullopt;
}

bool ControllerEnd::answer(OrderId id, std::uint16_t result, Bytes payload) noexcept {
  const auto place = std::ranges::find(unanswered_, id.number);
  if (!session().open() || id.session != session().count() || id.number == 0 || place == unanswered_.end() ||
      payload.size() > kMostAnswerBytes) {
    return false;
  }
  *place = 0;
  push_answer(id.number, Verdict::answered, result, payload);
  return true;
}

void ControllerEnd::push_answer(std::uint32_t number, Verdict verdict, std::uint16_t result,
                                Bytes payload) noexcept {
  std::array<std::uint8_t, kAnswerHeadBytes> head{};
  ByteWriter(head).put(number).put(static_cast<std::uint8_t>(verdict)).put(result);
  outgoing().push(head,
                  payload);  // never full: message_limit() admits as many orders as there is room for answers
}

std::size_t ControllerEnd::make_urgent(Room room, std::int64_t /*now_ns*/) noexcept {
  const std::optional<StopAnswer> answer = stops_.next();
  return answer ? encode(*answer, session().tag(), room) : 0;
}

std::size_t ControllerEnd::make_state(Room room, std::int64_t now_ns) noexcept {
  const std::optional<StateFragment> fragment = state_.next(now_ns);
  return fragment ? encode(*fragment, session().tag(), room) : 0;
}

bool ControllerEnd::on_frame(FrameKind kind, Bytes content, std::int64_t /*now_ns*/) noexcept {
  StopMessage stop;
  if (kind != FrameKind::stop || !decode(content, stop)) {
    return false;
  }
  stops_.on_stop(stop, session().peer_boot());
  return true;
}

void ControllerEnd::on_message(Bytes message, std::int64_t /*now_ns*/) noexcept {
  Waiting& place = waiting_[++arrived_ % kMostOpenOrders];
  std::ranges::copy(message, place.message.begin());
  place.size = message.size();
}

void ControllerEnd::on_status(const Status& status, std::int64_t now_ns) noexcept {
  state_.confirm(status, now_ns);
}

void ControllerEnd::on_session_begin() noexcept {
  stops_.meet(session().peer_boot());
  state_.reset();
}

void ControllerEnd::on_session_end() noexcept {
  arrived_ = fetched_ = 0;
  unanswered_.fill(0);
}

std::uint32_t ControllerEnd::message_limit() const noexcept {
  return outgoing().confirmed() + kLaneMessages;
}

}  // namespace gaitway::link

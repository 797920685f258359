// Each order's place, from its submission to its outcome.
#include "gaitway/link/module_end.hpp"

#include <algorithm>
#include <limits>

#include "gaitway/link/byte_order.hpp"

namespace gaitway::link {
namespace {

constexpr std::int64_t kMostWait_ns = 3600 * facts::kSecond_ns;  // also for orders that never expire

LinkIdentity as_module(LinkIdentity identity) noexcept {
  identity.role = Role::module;
  return identity;
}

}  // namespace

ModuleEnd::ModuleEnd(LinkIdentity identity, std::span<const Channel> channels, const LinkSettings& settings)
    : LinkEnd(as_module(identity), settings),
      answer_limit_ns_(settings.answer_limit_ns),
      confirm_after_ns_(settings.status_period_ns / 2),
      confirm_at_((settings.state_window + 1) / 2),
      stops_(settings.stop_repeat_ns),
      state_(channels) {}

Submission ModuleEnd::submit(std::uint16_t kind, Bytes payload, std::int64_t expiry_ns,
                             std::int64_t now_ns) noexcept {
  step(now_ns);
  const std::optional<std::int64_t> robot_ns = robot_time_ns(now_ns);
  if (!robot_ns) {
    return {Refusal::no_session, {}};
  }
  if (payload.size() > kMostOrderBytes) {
    return {Refusal::too_long, {}};
  }
  if (*robot_ns > expiry_ns) {
    return {Refusal::expired, {}};
  }
  const auto place = std::ranges::find(open_, OpenOrder::Stage::free, &OpenOrder::stage);
  if (place == open_.end()) {
    return {Refusal::full, {}};
  }
  std::array<std::uint8_t, kOrderHeadBytes> head{};
  ByteWriter(head).put(expiry_ns).put(kind);
  const std::uint32_t number = outgoing().push(head, payload);
  if (number == 0) {
    return {Refusal::full, {}};
  }
  place->stage = OpenOrder::Stage::waiting;
  place->id = {session().count(), number};
  // By this end's clock, since its notion of the robot's may jump back when the link was slow.
  place->give_up_ns = now_ns + std::min(expiry_ns - *robot_ns, kMostWait_ns) + answer_limit_ns_;
  return {Refusal::none, place->id};
}

std::optional<Outcome> ModuleEnd::next_outcome(std::int64_t now_ns) noexcept {
  step(now_ns);
  for (OpenOrder& order : open_) {
    if (order.stage == OpenOrder::Stage::waiting && now_ns > order.give_up_ns) {
      order.stage = OpenOrder::Stage::settled;
      order.verdict = Verdict::unanswered;
    }
    if (order.stage == OpenOrder::Stage::settled) {
      order.stage = OpenOrder::Stage::free;
      const bool answered = order.verdict == Verdict::answered;
      return Outcome{.id = order.id,
                     .verdict = order.verdict,
                     .result = answered ? order.result : std::uint16_t{0},
                     .payload = Bytes(order.payload).first(answered ? order.payload_bytes : 0)};
    }
  }
  return std::nullopt;
}

std::size_t ModuleEnd::make_urgent(Room room, std::int64_t now_ns) noexcept {
  const std::optional<StopMessage> stop = stops_.next(now_ns);
  return stop ? encode(*stop, session().tag(), room) : 0;
}

void ModuleEnd::fill(Status& status) noexcept {
  state_.confirm_in(status);
}

bool ModuleEnd::confirmation_due(std::int64_t since_status_ns) const noexcept {
  return state_.unconfirmed() >= confirm_at_ ||
         (state_.unconfirmed() > 0 && since_status_ns >= confirm_after_ns_);
}

bool ModuleEnd::on_frame(FrameKind kind, Bytes content, std::int64_t now_ns) noexcept {
  if (StopAnswer answer; kind == FrameKind::stop_answer && decode(content, answer)) {
    stops_.on_answer(answer);
    return true;
  }
  StateFragment fragment;
  return kind == FrameKind::state && decode(content, fragment) && state_.take(fragment, now_ns);
}

void ModuleEnd::on_message(Bytes message, std::int64_t /*now_ns*/) noexcept {
  ByteReader in(message);
  const auto number = in.get<std::uint32_t>();
  const auto verdict = in.get<std::uint8_t>();
  const auto result = in.get<std::uint16_t>();
  const Bytes payload = in.get_rest();
  for (OpenOrder& order : open_) {
    if (order.stage == OpenOrder::Stage::waiting && order.id == OrderId{session().count(), number}) {
      order.stage = OpenOrder::Stage::settled;
      order.verdict = verdict == static_cast<std::uint8_t>(Verdict::late) ? Verdict::late : Verdict::answered;
      order.result = result;
      order.payload_bytes = payload.size();
      std::ranges::copy(payload, order.payload.begin());
      return;
    }
  }
}

void ModuleEnd::on_session_begin() noexcept {
  stops_.reset();
  state_.reset();
}

void ModuleEnd::on_session_end() noexcept {
  for (OpenOrder& order : open_) {
    if (order.stage == OpenOrder::Stage::waiting) {
      order.stage = OpenOrder::Stage::settled;
      order.verdict = Verdict::unanswered;
    }
  }
}

std::uint32_t ModuleEnd::message_limit() const noexcept {
  return std::numeric_limits<std::uint32_t>::max();  // each order has its place for the answer
}

}  // namespace gaitway::link

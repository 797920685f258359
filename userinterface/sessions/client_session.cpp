#include "client_session.hpp"

#include <array>
#include <exception>
#include <utility>

#include "client_message.hpp"
#include "message_head.hpp"
#include "stop_call.hpp"

namespace gaitway::api {
namespace {

// Codes of the WebSocket protocol (RFC 6455, 7.4.1).
constexpr std::uint16_t kPolicyViolation = 1008;
constexpr std::int64_t kBetweenWarnings_ns = 1'000'000'000;

bool is_time(std::optional<std::int64_t>& last_ns, std::int64_t now_ns) {
  const bool so = !last_ns || now_ns - *last_ns >= kBetweenWarnings_ns;
  if (so) {
    last_ns = now_ns;
  }
  return so;
}

}  // namespace

ClientSession::ClientSession(HubState& hub, Connection& connection, Claimant claimant, bool authorised)
    : hub_(hub),
      connection_(connection),
      claimant_(std::move(claimant)),
      authorised_(authorised),
      opened_ns_(hub.now_ns),
      rate_(hub.options.limits.messages_per_s, hub.now_ns),
      outbox_(hub.options.limits.waiting_bytes, hub.waiting_bytes),
      topics_(hub.topics, outbox_, claimant_.number, [this] { wake(); }) {
  hub_.sessions.emplace(claimant_.number, this);
}

ClientSession::~ClientSession() {
  leave();
  hub_.sessions.erase(claimant_.number);
}

void ClientSession::take(std::string_view message, bool binary, std::int64_t wall_ns) {
  hub_.now_ns = wall_ns;
  claimant_.age_ns = connection_.message_age_ns(wall_ns);
  if (closing_) {
    return;
  }
  ++hub_.counts.messages;
  if (!within_rate(message)) {
    return;
  }
  if (binary) {
    tell_error("the message is binary, but must be JSON in a text frame", nullptr);
    return;
  }
  if (message.size() > hub_.options.limits.message_bytes) {
    tell_error("the message has " + std::to_string(message.size()) + " bytes, but must have at most " +
                   std::to_string(hub_.options.limits.message_bytes),
               nullptr);
    return;
  }
  carry_out(message);
}

// What was sent before a stop moves the robot no more, though it is looked at after it.
void ClientSession::take_overtaken(std::string_view message, bool binary, std::int64_t wall_ns) {
  claimant_.overtaken = true;
  take(message, binary, wall_ns);
  claimant_.overtaken = false;
}

bool ClientSession::gives_orders() const noexcept {
  return hub_.commands.authority().held_by(claimant_) || claimant_.tried_ns.has_value();
}

Urgency ClientSession::urgency(std::string_view message, bool binary) const noexcept {
  return !binary && authorised_ && !closing_ ? urgency_of_stop_call(message) : Urgency::none;
}

bool ClientSession::within_rate(std::string_view message) {
  const MessageRate::Verdict verdict = rate_.count(hub_.now_ns);
  if (verdict == MessageRate::Verdict::fine) {
    return true;
  }
  const bool stop = urgency(message, false) != Urgency::none;
  if (stop) {
    carry_out(message);
  }
  if (verdict == MessageRate::Verdict::goes_on) {
    close(kPolicyViolation, "too many messages");
  } else if (!stop) {
    ++hub_.counts.refused;
    tell_rate(message);
  }
  return false;
}

// Who called a service waits for its answer; the others are told once a second.
void ClientSession::tell_rate(std::string_view message) {
  const std::string why =
      "too many messages: at most " + shown_json(Json(hub_.options.limits.messages_per_s)) +
      " a second are taken, the others are dropped; if that goes on, the connection is closed";
  const auto head = authorised_ ? head_of(message) : std::nullopt;
  if (head && head->op == "call_service" && head->service.size() <= kMostNameBytes &&
      head->id.dump().size() <= kMostNameBytes) {
    ServiceCall call;
    call.id = head->id;
    call.service = head->service;
    call.encoding = head->compression == "cbor" ? Encoding::cbor : Encoding::json;
    push(service_failure(call, why));
  } else if (is_time(told_rate_ns_, hub_.now_ns)) {
    tell(Level::error, why, nullptr);
  }
}

void ClientSession::carry_out(std::string_view text) {
  Json id;
  try {
    Json message = parse_message(text, hub_.options.limits.depth);
    const std::string wrong_in_stop = leave_out_what_is_wrong_in_stop(message);
    id = id_in(message);
    const std::string name = name_in(message, "op");
    const Operation* const operation = find_operation(name);
    if (operation == nullptr) {
      throw Refused("op is " + shown(name) + ", which is no operation of rosbridge that this robot knows");
    }
    if (!authorised_ && operation->carry_out != &ClientSession::authenticate) {
      throw Refused(R"(not authorised: send {"op": "auth", "token": "..."} first)");
    }
    (this->*operation->carry_out)(message, id);
    if (!wrong_in_stop.empty()) {
      tell(Level::warning, wrong_in_stop + "left out of account, since this is a stop", id);
    }
  } catch (const std::exception& error) {
    tell_error(error.what(), id);
  }
  hub_.keep_within_budget();
}

std::optional<Frame> ClientSession::next_frame(std::int64_t wall_ns) {
  hub_.now_ns = wall_ns;
  auto frame = outbox_.next(wall_ns);
  awake_ = frame.has_value();
  return frame;
}

void ClientSession::step(std::int64_t now_ns) {
  if (closing_) {
    return;
  }
  if (!authorised_ && now_ns - opened_ns_ >= hub_.options.limits.authentication_ns) {
    close(kPolicyViolation, "not authorised in time");
  } else {
    if (outbox_.has_drops() && is_time(told_drops_ns_, now_ns)) {
      tell_drops();
    }
    wake();
  }
}

void ClientSession::answer(const ServiceCall& call, Frame frame) {
  push(std::move(frame), call.fragment_bytes);
}

// Half of what may wait is left for its own answers, so that calls of others do not end its connection.
bool ClientSession::take_call(Frame frame) {
  const bool room =
      !closing_ && outbox_.waiting_bytes() + frame.bytes->size() <= hub_.options.limits.waiting_bytes / 2;
  if (room) {
    push(std::move(frame));
  }
  return room;
}

Encoding ClientSession::encoding(Topic topic) const noexcept {
  return outbox_.terms(topic)->encoding;
}

void ClientSession::offer(Topic topic, const Frame& frame) {
  outbox_.offer(topic, frame, hub_.now_ns);
  wake();
}

void ClientSession::tell(Level level, std::string_view text, const Json& id) {
  constexpr std::array<std::string_view, 4> kNames{"none", "error", "warning", "info"};
  if (level <= level_ && !closing_) {
    push(status_frame(kNames[static_cast<std::size_t>(level)], text, id));
  }
}

void ClientSession::tell_error(std::string_view text, const Json& id) {
  ++hub_.counts.refused;
  tell(Level::error, text, id);
}

void ClientSession::tell_drops() {
  std::string text;
  const auto add = [&](std::string_view topic, std::uint64_t drops) {
    hub_.counts.dropped += drops;
    text += (text.empty() ? "" : ", ") + std::to_string(drops) + " of " + std::string(topic);
  };
  for (const TopicRow& row : kTopics) {
    if (const std::uint64_t drops = outbox_.take_drops(row.topic); drops > 0) {
      add(row.name, drops);
    }
  }
  topics_.take_drops(add);
  tell(Level::warning, "messages dropped, since this connection takes them too slowly: " + text, nullptr);
}

void ClientSession::push(Frame frame, std::size_t fragment_bytes) {
  if (closing_) {
    return;
  }
  if (outbox_.answer(std::move(frame), fragment_bytes)) {
    wake();
  } else {
    close(kPolicyViolation, "answers are not read");
  }
}

void ClientSession::wake() {
  if (!awake_ && outbox_.ready(hub_.now_ns)) {
    awake_ = true;
    connection_.wake();
  }
}

void ClientSession::close(std::uint16_t code, std::string_view reason) {
  if (!closing_) {
    leave();
    ++hub_.counts.closed_by_us;
    connection_.close(code, reason);
  }
}

void ClientSession::cut() {
  close(kPolicyViolation, "too much waits for all clients together, and most of it for this one");
  outbox_.clear();
}

void ClientSession::leave() {
  closing_ = true;
  for (const TopicRow& row : kTopics) {
    hub_.publications.remove(row.topic, *this);
    subscriptions_.remove_all(row.topic);
  }
  topics_.leave();
  outbox_.close_all();
  hub_.services.leave(claimant_.number);
  hub_.desk.leave(claimant_);
  hub_.commands.leave(claimant_);
}

}  // namespace gaitway::api

// rosbridge's operations, as a client sends them.
#include <algorithm>
#include <array>

#include "client_message.hpp"
#include "client_session.hpp"
#include "gaitway/api/json_reader.hpp"
#include "gaitway/api/message_definition.hpp"
#include "gaitway/api/service_table.hpp"
#include "gaitway/facts/facts.hpp"
#include "stop_call.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

using facts::kMillisecond_ns;

bool is_velocity(std::string_view topic) {
  return topic == kVelocityTopic || topic == kVelocityTopic.substr(1);
}

// The row of a topic that the robot publishes; null: it is another.
const TopicRow* find_row(std::string_view topic) {
  const auto found = std::ranges::find(kTopics, topic, &TopicRow::name);
  return found == kTopics.end() ? nullptr : &*found;
}

void require_type(const json& message, std::string_view topic, std::string_view type) {
  const auto given = optional_text(message, "type");
  if (given && !given->empty() && canonical_type(*given) != type) {
    throw Refused("type is " + shown(*given) + ", but " + std::string(topic) + " is of " + std::string(type));
  }
}

// `raw`: whether "cbor-raw" may be asked for.
Encoding encoding_of(const json& message, bool raw) {
  const std::string compression = optional_text(message, "compression").value_or("none");
  if (compression == "cbor") {
    return Encoding::cbor;
  }
  if (raw && compression == "cbor-raw") {
    return Encoding::cbor_raw;
  }
  if (compression != "none" && !compression.empty()) {
    throw Refused("compression is " + shown(compression) + ", but must be \"none\"" +
                  (raw ? ", \"cbor\" or \"cbor-raw\"" : " or \"cbor\""));
  }
  return Encoding::json;
}

// Topics without a rate of their own bring messages that each mean something.
std::size_t usual_queue(const TopicRow& row, const Limits& limits) {
  return row.rate_hz == 0.0 && !row.latched ? limits.queue_length : 1;
}

std::int64_t timeout_of(const json& message, const Limits& limits) {
  const auto timeout = message.find("timeout");
  if (timeout == message.end() || timeout->is_null()) {
    return limits.answer_ns;
  }
  const double most_s = static_cast<double>(limits.answer_ns) * 1e-9;
  if (!timeout->is_number() || timeout->get<double>() < 0.0) {
    throw Refused("timeout is " + shown_json(*timeout) + ", but must be a number of seconds from 0 on");
  }
  const double asked_s = timeout->get<double>();
  return asked_s == 0.0 ? limits.answer_ns : static_cast<std::int64_t>(std::min(asked_s, most_s) * 1e9);
}

bool asks_for_stop(const json& message) {
  const auto op = message.find("op"), service = message.find("service");
  if (op == message.end() || *op != "call_service" || service == message.end() || !service->is_string()) {
    return false;
  }
  return urgency_of_service(service->get_ref<const std::string&>()) != Urgency::none;
}

}  // namespace

const ClientSession::Operation* ClientSession::find_operation(std::string_view name) noexcept {
  using S = ClientSession;
  static constexpr std::array kOperations{
      Operation{"auth", &S::authenticate},
      Operation{"publish", &S::publish},
      Operation{"subscribe", &S::subscribe},
      Operation{"unsubscribe", &S::unsubscribe},
      Operation{"call_service", &S::call_service},
      Operation{"advertise", &S::advertise},
      Operation{"unadvertise", &S::unadvertise},
      Operation{"set_level", &S::set_level},
      Operation{"status", &S::ignore},
      Operation{"advertise_service", &S::advertise_service},
      Operation{"unadvertise_service", &S::unadvertise_service},
      Operation{"service_response", &S::respond_to_call},
      Operation{"advertise_action", &S::refuse_actions},
      Operation{"unadvertise_action", &S::refuse_actions},
      Operation{"send_action_goal", &S::refuse_actions},
      Operation{"cancel_action_goal", &S::refuse_actions},
      Operation{"action_feedback", &S::refuse_actions},
      Operation{"action_result", &S::refuse_actions},
      Operation{"fragment", &S::refuse_transformation},
      Operation{"png", &S::refuse_transformation},
  };
  const auto found = std::ranges::find(kOperations, name, &Operation::name);
  return found == kOperations.end() ? nullptr : &*found;
}

// rosauth's clients put what they show into `mac`.
void ClientSession::authenticate(const Json& message, const Json& id) {
  auto token = optional_text(message, "token");
  if (!token) {
    token = optional_text(message, "mac");
  }
  if (!token) {
    throw Refused("token is missing");
  }
  const bool right = hub_.options.is_token && hub_.options.is_token(*token);
  if (!right && !authorised_) {
    connection_.shown_wrong_token();
    tell_error("the token is wrong", id);
    close(1008, "wrong token");
    return;
  }
  authorised_ = true;
  tell(Level::info, "authorised", id);
}

void ClientSession::advertise(const Json& message, const Json& id) {
  const std::string topic = name_in(message, "topic");
  if (!is_velocity(topic)) {
    return advertise_own(message, id);
  }
  require_type(message, topic, ros::Twist::kName);
  if (!advertisements_.contains(id.dump())) {
    require_room_to_advertise();
  }
  advertisements_.insert(id.dump());
}

void ClientSession::unadvertise(const Json& message, const Json& id) {
  const std::string topic = name_in(message, "topic");
  const auto of_id = id.is_null() ? std::nullopt : std::optional(id.dump());
  const bool known = is_velocity(topic)
                         ? (of_id ? advertisements_.contains(*of_id) : !advertisements_.empty())
                         : topics_.unadvertise(topic, of_id);
  if (!known) {
    tell(Level::warning, "topic is " + shown(topic) + ", which this connection does not advertise", id);
  } else if (is_velocity(topic) && of_id) {
    advertisements_.erase(*of_id);
  } else if (is_velocity(topic)) {
    advertisements_.clear();
  }
}

void ClientSession::publish(const Json& message, const Json& id) {
  if (!is_velocity(name_in(message, "topic"))) {
    return publish_own(message);
  }
  const auto content = message.find("msg");
  if (content == message.end()) {
    throw Refused("msg is missing");
  }
  ros::Twist twist;
  api::from_json(*content, twist);
  const auto order = hub_.commands.walk(claimant_, twist, hub_.now_ns);
  if (order) {
    hub_.desk.watch(*order, claimant_, hub_.now_ns,
                    [this, id](const std::string& why) { tell_error(why, id); });
  }
}

void ClientSession::subscribe(const Json& message, const Json& id) {
  const TopicRow* const found = find_row(name_in(message, "topic"));
  if (found == nullptr) {
    return subscribe_own(message, id);
  }
  const TopicRow& row = *found;
  require_type(message, row.name, row.type);
  const std::string key = id.dump();
  if (!subscriptions_.has(row.topic, key)) {
    require_room_to_subscribe();
  }
  subscriptions_.set(row.topic, key, terms_of(message, usual_queue(row, hub_.options.limits), true, id));
  serve(row.topic);
  if (const auto last = hub_.publications.latched(row.topic, encoding(row.topic))) {
    offer(row.topic, *last);
  }
}

Terms ClientSession::terms_of(const Json& message, std::size_t usual_queue, bool raw, const Json& id) {
  constexpr std::uint64_t kMostThrottle_ms = 3'600'000;
  constexpr std::uint64_t kMostQueueAsked = 1'000'000'000;
  const Limits& limits = hub_.options.limits;
  Terms terms;
  terms.encoding = encoding_of(message, raw);
  terms.fragment_bytes = fragment_bytes_of(message);
  terms.throttle_ns = static_cast<std::int64_t>(whole_number(message, "throttle_rate", 0, kMostThrottle_ms)) *
                      kMillisecond_ns;
  const std::uint64_t asked = whole_number(message, "queue_length", 0, kMostQueueAsked);
  terms.queue_length = asked == 0 ? usual_queue : std::min<std::size_t>(asked, limits.queue_length);
  if (asked > limits.queue_length) {
    tell(Level::warning,
         "queue_length is " + std::to_string(asked) + ", but at most " + std::to_string(limits.queue_length) +
             " messages are kept",
         id);
  }
  if (is_binary(terms.encoding) && terms.fragment_bytes > 0) {
    tell(Level::warning, "fragment_size is left out of account: CBOR is sent whole", id);
  }
  return terms;
}

std::size_t ClientSession::fragment_bytes_of(const Json& message) const {
  constexpr std::uint64_t kMost = 1ULL << 40U;
  const std::uint64_t bytes = whole_number(message, "fragment_size", 0, kMost);
  if (bytes > 0 && bytes < Fragments::kLeast_bytes) {
    throw Refused("fragment_size is " + std::to_string(bytes) + ", but must be 0 or at least " +
                  std::to_string(Fragments::kLeast_bytes));
  }
  return bytes;
}

void ClientSession::serve(Topic topic) {
  if (const auto terms = subscriptions_.together(topic)) {
    outbox_.open(topic, *terms);
    hub_.publications.add(topic, *this);
  } else {
    hub_.publications.remove(topic, *this);
    outbox_.close(topic);
  }
}

void ClientSession::unsubscribe(const Json& message, const Json& id) {
  const std::string topic = name_in(message, "topic");
  const auto of_id = id.is_null() ? std::nullopt : std::optional(id.dump());
  const TopicRow* const row = find_row(topic);
  const bool removed = row == nullptr ? topics_.unsubscribe(topic, of_id)
                       : of_id        ? subscriptions_.remove(row->topic, *of_id)
                                      : subscriptions_.remove_all(row->topic);
  if (!removed) {
    tell(Level::warning, "topic is " + shown(topic) + ", of which there is no such subscription", id);
  } else if (row != nullptr) {
    serve(row->topic);
  }
}

void ClientSession::call_service(const Json& message, const Json& id) {
  ServiceCall call;
  call.client = claimant_.number;
  call.id = id;
  call.service = name_in(message, "service");
  call.timeout_ns = timeout_of(message, hub_.options.limits);
  call.encoding = encoding_of(message, false);
  call.fragment_bytes = fragment_bytes_of(message);
  const Json arguments = message.value("args", Json());
  if (find_service(call.service) == nullptr && hub_.services.find(call.service) != nullptr) {
    hub_.services.call(call, arguments, hub_.now_ns);
  } else {
    hub_.desk.call(call, arguments, claimant_, hub_.now_ns);
  }
}

std::string ClientSession::leave_out_what_is_wrong_in_stop(Json& message) const {
  std::string complaints;
  const auto check = [&](const char* field, const auto& read) {
    try {
      static_cast<void>(read());
    } catch (const Refused& refused) {
      message.erase(field);
      complaints += std::string(refused.what()) + "; ";
    }
  };
  if (asks_for_stop(message)) {
    check("id", [&] { return id_in(message); });
    check("timeout", [&] { return timeout_of(message, hub_.options.limits); });
    check("compression", [&] { return encoding_of(message, false); });
    check("fragment_size", [&] { return fragment_bytes_of(message); });
  }
  return complaints;
}

void ClientSession::set_level(const Json& message, const Json&) {
  const std::string name = name_in(message, "level");
  constexpr std::array<std::string_view, 4> kNames{"none", "error", "warning", "info"};
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) {
    throw Refused("level is " + shown(name) + R"(, but must be "none", "error", "warning" or "info")");
  }
  level_ = static_cast<Level>(found - kNames.begin());
}

// What a client tells about itself changes nothing.
void ClientSession::ignore(const Json&, const Json&) {}

void ClientSession::refuse_actions(const Json& message, const Json&) {
  throw Refused("op is " + shown(name_in(message, "op")) + ": this robot has no actions");
}

void ClientSession::refuse_transformation(const Json& message, const Json&) {
  throw Refused("op is " + shown(name_in(message, "op")) + ": send messages whole, in at most " +
                std::to_string(hub_.options.limits.message_bytes) + " bytes of JSON");
}

}  // namespace gaitway::api

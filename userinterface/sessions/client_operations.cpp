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

// The topic of a message that the robot is to take. Throws Refused.
std::string velocity_topic_in(const json& message) {
  std::string topic = name_in(message, "topic");
  if (!is_velocity(topic)) {
    throw Refused("topic is " + shown(topic) + ", but the robot takes messages on " +
                  std::string(kVelocityTopic) + " only");
  }
  return topic;
}

// The row of a topic that a client wants to hear. Throws Refused.
const TopicRow& row_of(const std::string& topic) {
  for (const TopicRow& row : kTopics) {
    if (row.name == topic) {
      return row;
    }
  }
  throw Refused("topic is " + shown(topic) +
                ", but must be one that the robot publishes: see /rosapi/topics");
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
  return is_stop_service(service->get_ref<const std::string&>());
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
      Operation{"advertise_service", &S::refuse_serving},
      Operation{"unadvertise_service", &S::refuse_serving},
      Operation{"service_response", &S::refuse_serving},
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
  const std::string topic = velocity_topic_in(message);
  require_type(message, topic, ros::Twist::kName);
  if (advertisements_.size() >= hub_.options.limits.advertisements && !advertisements_.contains(id.dump())) {
    throw Refused("this connection advertises " + std::to_string(advertisements_.size()) +
                  " times already: unadvertise first");
  }
  advertisements_.insert(id.dump());
}

void ClientSession::unadvertise(const Json& message, const Json& id) {
  const std::string topic = name_in(message, "topic");
  const bool known =
      is_velocity(topic) && (id.is_null() ? !advertisements_.empty() : advertisements_.contains(id.dump()));
  if (!known) {
    tell(Level::warning, "topic is " + shown(topic) + ", which this connection does not advertise", id);
    return;
  }
  if (id.is_null()) {
    advertisements_.clear();
  } else {
    advertisements_.erase(id.dump());
  }
}

void ClientSession::publish(const Json& message, const Json& id) {
  static_cast<void>(velocity_topic_in(message));
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
  const TopicRow& row = row_of(name_in(message, "topic"));
  require_type(message, row.name, row.type);
  const std::string key = id.dump();
  if (subscriptions_.count() >= hub_.options.limits.subscriptions && !subscriptions_.has(row.topic, key)) {
    throw Refused("this connection has " + std::to_string(subscriptions_.count()) +
                  " subscriptions already: unsubscribe first");
  }
  subscriptions_.set(row.topic, key, terms_of(message, row, id));
  serve(row.topic);
  if (const auto last = hub_.publications.latched(row.topic, encoding(row.topic))) {
    offer(row.topic, *last);
  }
}

Terms ClientSession::terms_of(const Json& message, const TopicRow& row, const Json& id) {
  constexpr std::uint64_t kMostThrottle_ms = 3'600'000;
  constexpr std::uint64_t kMostQueueAsked = 1'000'000'000;
  const Limits& limits = hub_.options.limits;
  Terms terms;
  terms.encoding = encoding_of(message, true);
  terms.fragment_bytes = fragment_bytes_of(message);
  terms.throttle_ns = static_cast<std::int64_t>(whole_number(message, "throttle_rate", 0, kMostThrottle_ms)) *
                      kMillisecond_ns;
  const std::uint64_t asked = whole_number(message, "queue_length", 0, kMostQueueAsked);
  terms.queue_length =
      asked == 0 ? usual_queue(row, limits) : std::min<std::size_t>(asked, limits.queue_length);
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
  const TopicRow& row = row_of(name_in(message, "topic"));
  const bool removed =
      id.is_null() ? subscriptions_.remove_all(row.topic) : subscriptions_.remove(row.topic, id.dump());
  if (removed) {
    serve(row.topic);
  } else {
    tell(Level::warning, "there is no such subscription of " + std::string(row.name), id);
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
  hub_.desk.call(call, message.value("args", Json()), claimant_, hub_.now_ns);
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

void ClientSession::refuse_serving(const Json& message, const Json&) {
  throw Refused("op is " + shown(name_in(message, "op")) + ": services are offered by the robot alone");
}

void ClientSession::refuse_actions(const Json& message, const Json&) {
  throw Refused("op is " + shown(name_in(message, "op")) + ": this robot has no actions");
}

void ClientSession::refuse_transformation(const Json& message, const Json&) {
  throw Refused("op is " + shown(name_in(message, "op")) + ": send messages whole, in at most " +
                std::to_string(hub_.options.limits.message_bytes) + " bytes of JSON");
}

}  // namespace gaitway::api

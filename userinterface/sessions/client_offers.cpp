// Operations on what clients have among themselves: topics and services that are not the robot's.
#include <algorithm>

#include "client_message.hpp"
#include "client_session.hpp"
#include "gaitway/api/service_table.hpp"
#include "resource_name.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

// A topic that the robot has no part in. Throws Refused.
std::string own_topic_in(const json& message, std::string_view otherwise) {
  std::string topic = resource_name_in(message, "topic");
  const std::string name = absolute_name(topic);
  if (name == kVelocityTopic) {
    throw Refused("topic is " + shown(topic) +
                  ", which the robot takes and does not publish: " + std::string(otherwise));
  }
  if (std::ranges::find(kTopics, name, &TopicRow::name) != kTopics.end()) {
    throw Refused("topic is " + shown(topic) + ", which is the robot's own: " + std::string(otherwise));
  }
  return topic;
}

std::string topic_to_publish(const json& message) {
  return own_topic_in(message, "it takes messages on " + std::string(kVelocityTopic) + " only");
}

// A service that the robot does not offer. Throws Refused.
std::string own_service_in(const json& message) {
  std::string service = resource_name_in(message, "service");
  const std::string name = absolute_name(service);
  if (find_service(name) != nullptr || name.starts_with("/rosapi/")) {
    throw Refused("service is " + shown(service) + ", which is the robot's own");
  }
  return service;
}

bool flag_in(const json& message, const char* field) {
  const auto flag = message.find(field);
  if (flag == message.end() || flag->is_null()) {
    return false;
  }
  if (!flag->is_boolean()) {
    throw Refused(std::string(field) + " is " + shown_json(*flag) + ", but must be true or false");
  }
  return flag->get<bool>();
}

}  // namespace

void ClientSession::require_room_to_advertise() const {
  const std::size_t count = advertisements_.size() + topics_.advertisements();
  if (count >= hub_.options.limits.advertisements) {
    throw Refused("this connection advertises " + std::to_string(count) +
                  " times already: unadvertise first");
  }
}

void ClientSession::require_room_to_subscribe() const {
  if (subscriptions() >= hub_.options.limits.subscriptions) {
    throw Refused("this connection has " + std::to_string(subscriptions()) +
                  " subscriptions already: unsubscribe first");
  }
}

void ClientSession::advertise_own(const Json& message, const Json& id) {
  const std::string topic = topic_to_publish(message);
  const std::string type = type_in(message, "msg");
  const bool latch = flag_in(message, "latch");
  if (!topics_.advertises(topic, id.dump())) {
    require_room_to_advertise();
  }
  topics_.advertise(topic, type, id.dump(), latch);
}

// Who publishes without having advertised the topic does so by this, as with rosbridge.
void ClientSession::publish_own(const Json& message) {
  const std::string topic = topic_to_publish(message);
  const auto content = message.find("msg");
  if (content == message.end()) {
    throw Refused("msg is missing");
  }
  if (!content->is_object()) {
    throw Refused("msg is " + shown_json(*content) + ", but must be an object");
  }
  const std::string type = type_in(message, "msg");
  const bool latch = flag_in(message, "latch");
  hub_.topics.require_type(absolute_name(topic), type);
  if (!topics_.advertises(topic)) {
    require_room_to_advertise();
    topics_.advertise(topic, type, Json().dump(), latch);
  }
  topics_.publish(topic, *content, latch, hub_.now_ns);
}

void ClientSession::subscribe_own(const Json& message, const Json& id) {
  const std::string topic = own_topic_in(message, "see /rosapi/topics");
  const std::string type = type_in(message, "msg");
  hub_.topics.require_type(absolute_name(topic), type);
  if (!topics_.subscribes(topic, id.dump())) {
    require_room_to_subscribe();
  }
  topics_.subscribe(topic, type, id.dump(), terms_of(message, hub_.options.limits.queue_length, false, id),
                    hub_.now_ns);
}

void ClientSession::advertise_service(const Json& message, const Json&) {
  const std::string service = own_service_in(message);
  const std::string type = type_in(message, "srv");
  if (type.empty()) {
    throw Refused("type is missing");
  }
  hub_.services.advertise(claimant_.number, service, type);
}

void ClientSession::unadvertise_service(const Json& message, const Json& id) {
  const std::string service = name_in(message, "service");
  if (!hub_.services.unadvertise(claimant_.number, service)) {
    tell(Level::warning, "service is " + shown(service) + ", which this connection does not offer", id);
  }
}

void ClientSession::respond_to_call(const Json& message, const Json& id) {
  if (!hub_.services.respond(claimant_.number, message)) {
    tell(Level::warning,
         "id is " + shown_json(id) + ", but no call with this id waits for an answer of this connection", id);
  }
}

}  // namespace gaitway::api

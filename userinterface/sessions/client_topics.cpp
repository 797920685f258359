// A message is kept as the text that a subscriber would get, and encoded once for each form that is wanted.
#include "client_topics.hpp"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "client_message.hpp"
#include "gaitway/api/cbor_codec.hpp"
#include "gaitway/api/json_codec.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

Frame topic_frame(const std::string& spelling, const json& message, Encoding encoding) {
  auto out = std::make_shared<std::string>();
  if (is_binary(encoding)) {
    append_cbor_publish_head(*out, spelling);
    json::to_cbor(message, *out);
  } else {
    *out += R"({"op":"publish","topic":)";
    append_json_string(*out, spelling);
    *out += R"(,"msg":)" + message.dump() + "}";
  }
  return {std::move(out), is_binary(encoding)};
}

}  // namespace

bool TopicPublisher::latched() const noexcept {
  return std::ranges::any_of(advertisements, [](const auto& one) { return one.second; });
}

void ClientTopics::require_type(const std::string& name, const std::string& type) const {
  const ClientTopic* const topic = find(name);
  if (topic == nullptr && type.empty()) {
    throw Refused("type is missing, and topic is " + shown(name) +
                  ", which nobody has told the type of: see /rosapi/topics");
  }
  if (topic == nullptr && topics_.size() >= limits_.client_topics) {
    throw Refused("clients have " + std::to_string(topics_.size()) + " topics already, and at most " +
                  std::to_string(limits_.client_topics) + " are kept");
  }
  if (topic != nullptr && !type.empty() && type != topic->type) {
    throw Refused("type is " + shown(type) + ", but " + name + " is of " + topic->type +
                  " while somebody advertises it or subscribes to it");
  }
}

ClientTopic& ClientTopics::establish(const std::string& name, const std::string& type) {
  require_type(name, type);
  ClientTopic& topic = topics_[name];
  if (topic.type.empty()) {
    topic.type = type;
  }
  return topic;
}

void ClientTopics::forget_if_unused(const std::string& name) {
  const auto topic = topics_.find(name);
  if (topic != topics_.end() && topic->second.publishers.empty() && topic->second.listeners.empty()) {
    topics_.erase(topic);
  }
}

void ClientTopics::advertise(TopicClient& client, const std::string& name, const std::string& type,
                             const std::string& id, bool latch) {
  TopicPublisher& publisher = establish(name, type).publishers[client.number()];
  publisher.client = &client;
  publisher.advertisements[id] = latch;
}

bool ClientTopics::unadvertise(const TopicClient& client, const std::string& name,
                               const std::optional<std::string>& id) {
  const auto topic = topics_.find(name);
  if (topic == topics_.end()) {
    return false;
  }
  auto& publishers = topic->second.publishers;
  const auto found = publishers.find(client.number());
  if (found == publishers.end()) {
    return false;
  }
  TopicPublisher& publisher = found->second;
  if (id && publisher.advertisements.erase(*id) == 0) {
    return false;
  }
  if (!id || publisher.advertisements.empty()) {
    if (!publisher.kept.empty()) {
      publisher.client->let_go(publisher.kept.size() + Outbox::kMessage_bytes);
    }
    publishers.erase(found);
    forget_if_unused(name);
  }
  return true;
}

void ClientTopics::publish(TopicClient& client, const std::string& name, const json& message, bool keep,
                           std::int64_t now_ns) {
  ClientTopic& topic = topics_.at(name);
  TopicPublisher& publisher = topic.publishers.at(client.number());
  if (keep || publisher.latched()) {
    std::string text = message.dump();
    if (text.size() > limits_.kept_bytes) {
      throw Refused("msg has " + std::to_string(text.size()) +
                    " bytes as JSON, but of a latched topic at most " + std::to_string(limits_.kept_bytes) +
                    " are kept");
    }
    if (!publisher.kept.empty()) {
      client.let_go(publisher.kept.size() + Outbox::kMessage_bytes);
      publisher.kept.clear();
    }
    if (!client.hold(text.size() + Outbox::kMessage_bytes)) {
      throw Refused("msg cannot be kept: too much waits for this connection already");
    }
    publisher.kept = std::move(text);
  }
  std::map<std::tuple<std::string_view, Encoding>, Frame> forms;
  for (const TopicListener& listener : topic.listeners) {
    Frame& form = forms[{listener.spelling, listener.encoding}];
    if (!form.bytes) {
      form = topic_frame(listener.spelling, message, listener.encoding);
    }
    listener.client->offer(listener.lane, form, now_ns);
  }
}

void ClientTopics::listen(const std::string& name, const std::string& type, TopicListener listener,
                          std::int64_t now_ns) {
  ClientTopic& topic = establish(name, type);
  if (TopicListener* const same = find_listener(*listener.client, name, listener.lane)) {
    *same = listener;
  } else {
    topic.listeners.push_back(listener);
  }
  for (const auto& [number, publisher] : topic.publishers) {
    if (!publisher.kept.empty()) {
      listener.client->offer(listener.lane,
                             topic_frame(listener.spelling, json::parse(publisher.kept), listener.encoding),
                             now_ns);
    }
  }
}

void ClientTopics::change_encoding(const TopicClient& client, const std::string& name, LaneKey lane,
                                   Encoding encoding) {
  if (TopicListener* const listener = find_listener(client, name, lane)) {
    listener->encoding = encoding;
  }
}

TopicListener* ClientTopics::find_listener(const TopicClient& client, const std::string& name, LaneKey lane) {
  const auto topic = topics_.find(name);
  if (topic == topics_.end()) {
    return nullptr;
  }
  const auto found = std::ranges::find_if(topic->second.listeners, [&](const TopicListener& listener) {
    return listener.client == &client && listener.lane == lane;
  });
  return found == topic->second.listeners.end() ? nullptr : &*found;
}

void ClientTopics::stop_listening(const TopicClient& client, const std::string& name, LaneKey lane) {
  if (const auto topic = topics_.find(name); topic != topics_.end()) {
    std::erase_if(topic->second.listeners, [&](const TopicListener& listener) {
      return listener.client == &client && listener.lane == lane;
    });
    forget_if_unused(name);
  }
}

const ClientTopic* ClientTopics::find(std::string_view name) const {
  const auto topic = topics_.find(name);
  return topic == topics_.end() ? nullptr : &topic->second;
}

}  // namespace gaitway::api

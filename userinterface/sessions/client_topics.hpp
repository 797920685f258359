// Topics that clients have among themselves: one type each, and every message to all who subscribe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/limits.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/session.hpp"
#include "outbox.hpp"

namespace gaitway::api {

// One client, as topics know it.
class TopicClient {
 public:
  virtual ~TopicClient() = default;
  [[nodiscard]] virtual std::uint64_t number() const noexcept = 0;  // Claimant::number
  virtual void offer(LaneKey lane, const Frame& frame, std::int64_t now_ns) = 0;
  // A message is kept on its behalf and counts with what waits for it. False: no room.
  [[nodiscard]] virtual bool hold(std::size_t bytes) = 0;
  virtual void let_go(std::size_t bytes) noexcept = 0;
};

// A subscription, as publishing sees it.
struct TopicListener {
  TopicClient* client = nullptr;
  LaneKey lane;
  std::string spelling;  // of the name, which the client gets back
  Encoding encoding = Encoding::json;
};

struct TopicPublisher {
  TopicClient* client = nullptr;
  std::map<std::string, bool> advertisements;  // id -> whether it is latched
  std::string kept;                            // the last message, as JSON; empty: none

  [[nodiscard]] bool latched() const noexcept;
};

struct ClientTopic {
  std::string type;
  std::map<std::uint64_t, TopicPublisher> publishers;  // by client
  std::vector<TopicListener> listeners;
};

// A topic exists, and has its type, while somebody advertises it or subscribes to it. Refusals are Refused.
class ClientTopics {
 public:
  explicit ClientTopics(const Limits& limits) : limits_(limits) {}
  ClientTopics(const ClientTopics&) = delete;
  ClientTopics& operator=(const ClientTopics&) = delete;

  // Names are absolute. An empty type: the one that the topic has.
  void advertise(TopicClient& client, const std::string& name, const std::string& type, const std::string& id,
                 bool latch);
  // Of all ids, without one. False: there is no such advertisement.
  bool unadvertise(const TopicClient& client, const std::string& name, const std::optional<std::string>& id);
  // The client advertises the topic. `keep`: for who subscribes later, as long as the client advertises it.
  void publish(TopicClient& client, const std::string& name, const nlohmann::json& message, bool keep,
               std::int64_t now_ns);

  // A listener with this lane is replaced. It gets what is kept.
  void listen(const std::string& name, const std::string& type, TopicListener listener, std::int64_t now_ns);
  void change_encoding(const TopicClient& client, const std::string& name, LaneKey lane, Encoding encoding);
  void stop_listening(const TopicClient& client, const std::string& name, LaneKey lane);

  // Nothing: nobody advertises it or subscribes to it.
  [[nodiscard]] const ClientTopic* find(std::string_view name) const;
  [[nodiscard]] const std::map<std::string, ClientTopic, std::less<>>& all() const noexcept {
    return topics_;
  }
  // Throws what advertise() and listen() would throw.
  void require_type(const std::string& name, const std::string& type) const;

 private:
  ClientTopic& establish(const std::string& name, const std::string& type);
  TopicListener* find_listener(const TopicClient& client, const std::string& name, LaneKey lane);
  void forget_if_unused(const std::string& name);

  const Limits& limits_;
  std::map<std::string, ClientTopic, std::less<>> topics_;
};

}  // namespace gaitway::api

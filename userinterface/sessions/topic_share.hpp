// What one client has of the clients' topics: what it advertises, and what it subscribes to on which terms.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "client_topics.hpp"
#include "outbox.hpp"
#include "subscriptions.hpp"

namespace gaitway::api {

// Names are as the client wrote them. The client's messages wait in `outbox`. Refusals are Refused.
class TopicShare final : private TopicClient {
 public:
  // `wake`: something may be ready to be sent.
  TopicShare(ClientTopics& topics, Outbox& outbox, std::uint64_t client, std::function<void()> wake)
      : topics_(topics), outbox_(outbox), client_(client), wake_(std::move(wake)) {}
  ~TopicShare() override { leave(); }
  TopicShare(const TopicShare&) = delete;
  TopicShare& operator=(const TopicShare&) = delete;

  [[nodiscard]] bool advertises(const std::string& name, const std::string& id) const;
  [[nodiscard]] bool advertises(const std::string& name) const;
  void advertise(const std::string& name, const std::string& type, const std::string& id, bool latch);
  // Of all ids, without one. False: there is no such advertisement.
  bool unadvertise(const std::string& name, const std::optional<std::string>& id);
  void publish(const std::string& name, const nlohmann::json& message, bool keep, std::int64_t now_ns);

  [[nodiscard]] bool subscribes(const std::string& name, const std::string& id) const;
  void subscribe(const std::string& name, const std::string& type, const std::string& id, const Terms& terms,
                 std::int64_t now_ns);
  // As unadvertise().
  bool unsubscribe(const std::string& name, const std::optional<std::string>& id);

  [[nodiscard]] std::size_t advertisements() const noexcept { return advertisements_.size(); }
  [[nodiscard]] std::size_t subscriptions() const noexcept;
  // Calls tell(name, count) for each topic of which messages were dropped since this was called last.
  void take_drops(const std::function<void(const std::string& name, std::uint64_t count)>& tell);
  // Ends all.
  void leave();

 private:
  struct Subscription {
    LaneKey lane;
    std::map<std::string, Terms> terms;  // by id
  };
  // TopicClient.
  [[nodiscard]] std::uint64_t number() const noexcept override { return client_; }
  void offer(LaneKey lane, const Frame& frame, std::int64_t now_ns) override;
  [[nodiscard]] bool hold(std::size_t bytes) override { return outbox_.hold(bytes); }
  void let_go(std::size_t bytes) noexcept override { outbox_.let_go(bytes); }

  ClientTopics& topics_;
  Outbox& outbox_;
  std::uint64_t client_;
  std::function<void()> wake_;
  std::set<std::pair<std::string, std::string>> advertisements_;  // absolute name, id
  std::map<std::string, Subscription> subscriptions_;             // by the name as it was written
};

}  // namespace gaitway::api

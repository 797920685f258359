// Who subscribes to what: of one client on which terms, of all for whom a message is encoded.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/api/publication.hpp"
#include "gaitway/api/session.hpp"
#include "outbox.hpp"

namespace gaitway::api {

// Terms that suit all of these: the shortest interval, the longest queue, the smallest pieces, and CBOR if
// one of them wants it. Nothing: there are none.
[[nodiscard]] std::optional<Terms> terms_together(const std::map<std::string, Terms>& by_id);

// What one client subscribes to: for each topic one or more subscriptions, told apart by their ids, that are
// served together.
class Subscriptions {
 public:
  [[nodiscard]] bool has(Topic topic, const std::string& id) const;
  void set(Topic topic, const std::string& id, const Terms& terms);
  // False: there was none.
  bool remove(Topic topic, const std::string& id);
  bool remove_all(Topic topic);

  // Terms that suit all subscriptions of the topic. Nothing: there is none.
  [[nodiscard]] std::optional<Terms> together(Topic topic) const {
    return terms_together(topics_[static_cast<std::size_t>(topic)]);
  }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }

 private:
  std::array<std::map<std::string, Terms>, kTopicCount> topics_;
  std::size_t count_ = 0;
};

class Subscriber {
 public:
  virtual ~Subscriber() = default;
  // In which it wants a topic that it subscribes to.
  [[nodiscard]] virtual Encoding encoding(Topic topic) const noexcept = 0;
  virtual void offer(Topic topic, const Frame& frame) = 0;
};

// Who subscribes to what, and the last messages of latched topics.
class Publications {
 public:
  using Encode = std::function<void(Encoding encoding, std::string& out)>;

  void add(Topic topic, Subscriber& subscriber);
  void remove(Topic topic, const Subscriber& subscriber);
  void publish(Topic topic, const Encode& encode);
  [[nodiscard]] bool wanted(Topic topic) const noexcept;
  // The last message of a latched topic; nothing before there was one.
  [[nodiscard]] std::optional<Frame> latched(Topic topic, Encoding encoding) const;

 private:
  using Forms = std::array<Frame, kEncodings>;
  std::array<std::vector<Subscriber*>, kTopicCount> subscribers_;
  std::array<Forms, kTopicCount> latched_;
};

}  // namespace gaitway::api

// What one client subscribes to: for each topic one or more subscriptions, told apart by their ids, that are
// served together.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "gaitway/api/publication.hpp"
#include "outbox.hpp"

namespace gaitway::api {

class Subscriptions {
 public:
  [[nodiscard]] bool has(Topic topic, const std::string& id) const;
  void set(Topic topic, const std::string& id, const Terms& terms);
  // False: there was none.
  bool remove(Topic topic, const std::string& id);
  bool remove_all(Topic topic);

  // Terms that suit all subscriptions of the topic: the shortest interval, the longest queue, the smallest
  // pieces, and CBOR if one of them wants it. Nothing: there is none.
  [[nodiscard]] std::optional<Terms> together(Topic topic) const;
  [[nodiscard]] std::size_t count() const noexcept { return count_; }

 private:
  std::array<std::map<std::string, Terms>, kTopicCount> topics_;
  std::size_t count_ = 0;
};

}  // namespace gaitway::api

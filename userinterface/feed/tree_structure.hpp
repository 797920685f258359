// A behaviour tree's structure, put together of its parts, which come in turn.
#pragma once

#include <cstddef>
#include <vector>

#include "gaitway/api/command_messages.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::api {

class TreeStructure {
 public:
  // Whether the tree is complete with this part, and was not before.
  bool take(const gaitway::BehaviourNodes& part);
  // Of the tree that was complete last.
  [[nodiscard]] const ros::BehaviourNodes& message() const noexcept { return message_; }
  // The robot was started anew, and counts its trees anew.
  void forget() noexcept { begun_ = false; }

 private:
  void begin(const gaitway::BehaviourNodes& part);

  bool begun_ = false;
  std::size_t missing_ = 0;  // nodes that have not come
  std::vector<bool> known_;
  ros::BehaviourNodes message_;
};

}  // namespace gaitway::api

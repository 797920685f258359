// Parts of another tree than the last one begin anew.
#include "tree_structure.hpp"

#include <algorithm>

#include "gaitway/api/state_messages.hpp"

namespace gaitway::api {

void TreeStructure::begin(const gaitway::BehaviourNodes& part) {
  begun_ = true;
  missing_ = std::min<std::size_t>(part.node_count, kMaxTreeNodes);
  known_.assign(missing_, false);
  message_ = {};
  message_.revision = part.revision;
  message_.node_count = part.node_count;
  message_.parent.resize(missing_);
  message_.type.resize(missing_);
  message_.name.resize(missing_);
}

bool TreeStructure::take(const gaitway::BehaviourNodes& part) {
  if (!begun_ || part.revision != message_.revision || part.node_count != message_.node_count) begin(part);
  const std::size_t before = missing_;
  const std::size_t count = std::min<std::size_t>(part.count, kToldNodes);
  const std::size_t end = std::min<std::size_t>(part.first + count, known_.size());
  for (std::size_t node = part.first; node < end; ++node) {
    const std::size_t i = node - part.first;
    if (known_[node]) continue;
    known_[node] = true;
    --missing_;
    message_.parent[node] = part.parent[i];
    message_.type[node] = text_of(part.type[i]);
    message_.name[node] = text_of(part.name[i]);
  }
  const bool completed = missing_ == 0 && before > 0;
  if (completed) message_.header.stamp = ros_time(part.stamp_ns);
  return completed;
}

}  // namespace gaitway::api

// Collects frames until every node has sent one.
#include "tools/bus/frame_set_meter.hpp"

namespace gaitway::tools {

void FrameSetMeter::take(can::NodeId node, std::int64_t start_ns, std::int64_t length_ns) {
  const bool late = !seen_.empty() && start_ns > first_ns_ + period_ns_ / 2;
  if (late || seen_.contains(node)) {
    ++incomplete_;
    seen_.clear();
  }
  if (seen_.empty()) {
    first_ns_ = start_ns;
    bus_time_ns_ = 0;
  }
  seen_.insert(node);
  bus_time_ns_ += length_ns;
  last_ns_ = start_ns + length_ns;
  if (seen_.size() < nodes_) {
    return;
  }
  seen_.clear();
  bus_time_ms_.add(static_cast<double>(bus_time_ns_) * 1e-6);
  span_ms_.add(static_cast<double>(last_ns_ - first_ns_) * 1e-6);
  if (last_ns_ - first_ns_ == bus_time_ns_) {
    back_to_back_ms_.add(static_cast<double>(last_ns_ - first_ns_) * 1e-6);
  }
}

}  // namespace gaitway::tools

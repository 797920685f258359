// In place of whoever commands the walk: finish the step and stand.
#pragma once

#include "gaitway/core/fallback.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {

class StopFallback final : public Fallback {
 public:
  void follow(const Tick&) noexcept override {}
  bool act(const Tick& tick, ManagedPlugin& through) noexcept override {
    WalkCommand stop{};
    stop.stamp_ns = tick.now_ns;
    return through.publish_in_place("walk_command", stop, tick.now_ns);
  }
};

}  // namespace gaitway::core

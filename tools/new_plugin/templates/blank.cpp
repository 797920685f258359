// The plug-in plugin_name: counts the robot's steps and reports every tenth. Writes no topic yet: begin here.
#include <cstdio>

#include "gaitway/plugin/plugin.hpp"

class PluginName final : public gaitway::Plugin {
 public:
  explicit PluginName(gaitway::Setup& setup)
      : reported_steps_(setup.parameter("reported_steps", 10)),
        estimate_(setup.reads<gaitway::Estimate>("estimate")),
        report_(setup.reporter()) {}

  // Every 10 ms: no allocation, lock or system call in here.
  void step(const gaitway::Tick&) override {
    const gaitway::Estimate& estimate = estimate_.read();
    if (estimate_.has_value() && estimate.support != support_) {
      support_ = estimate.support;
      if (++steps_ % reported_steps_ == 0) {
        char text[80];
        std::snprintf(text, sizeof text, "%lld steps, %.0f N on the left foot, %.0f N on the right",
                      static_cast<long long>(steps_), estimate.foot_force[0], estimate.foot_force[1]);
        report_(gaitway::Severity::info, text);
      }
    }
  }

 private:
  std::int64_t reported_steps_;
  std::int64_t steps_ = 0;
  std::uint32_t support_ = 0;  // 0 left, 1 right
  gaitway::Input<gaitway::Estimate> estimate_;
  gaitway::Reporter report_;
};

GAITWAY_PLUGIN(PluginName, "plugin_name", "0.1.0", "Counts steps")

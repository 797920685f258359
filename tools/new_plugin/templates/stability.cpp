// The plug-in plugin_name: balance in the place of the shipped feedback; the ankles press against the trunk's
// lean.
#include "gaitway/plugin/plugin.hpp"

class PluginName final : public gaitway::Plugin {
 public:
  explicit PluginName(gaitway::Setup& setup)
      : gain_(setup.parameter("gain", 0.2, "rad/rad")),
        damping_s_(setup.parameter("damping", 0.02, "s")),
        estimate_(setup.reads<gaitway::Estimate>("estimate")),
        trim_(setup.writes<gaitway::TrimCommand>("trim")),
        correction_(setup.writes<gaitway::Correction>("correction")) {}

  void step(const gaitway::Tick& tick) override {
    const gaitway::Estimate& estimate = estimate_.read();
    gaitway::TrimCommand& trim = trim_.value();
    trim.stamp_ns = tick.now_ns;
    trim.channel_count = 8;
    trim.angle[4] = trim.angle[5] = against(estimate, 1);  // ankle pitch, left and right
    trim.angle[6] = trim.angle[7] = against(estimate, 0);  // ankle roll
    trim_.publish();
    correction_.value().stamp_ns = tick.now_ns;
    correction_.publish();  // no wish for the next batch: all zero
  }

 private:
  // Roll is axis 0, pitch axis 1.
  [[nodiscard]] double against(const gaitway::Estimate& estimate, int axis) const noexcept {
    return gain_ * estimate.attitude[axis] + damping_s_ * estimate.angular_velocity[axis];
  }

  double gain_, damping_s_;
  gaitway::Input<gaitway::Estimate> estimate_;
  gaitway::Output<gaitway::TrimCommand> trim_;
  gaitway::Output<gaitway::Correction> correction_;
};

GAITWAY_PLUGIN(PluginName, "plugin_name", "0.1.0", "Presses the ankles against the trunk's lean")

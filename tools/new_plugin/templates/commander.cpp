// The plug-in plugin_name: walks a square, turning on the spot at its corners. It takes the place of the
// behaviour: where a person commands, the robot does as the person says.
#include <cstdint>
#include <numbers>

#include "gaitway/plugin/plugin.hpp"

class PluginName final : public gaitway::Plugin {
 public:
  explicit PluginName(gaitway::Setup& setup)
      : side_m_(setup.parameter("side", 0.6, "m")),
        speed_m_per_s_(setup.parameter("speed", 0.15, "m/s")),
        turn_rate_rad_per_s_(setup.parameter("turn_rate", 0.4, "rad/s")),
        estimate_(setup.reads<gaitway::Estimate>("estimate")),
        walk_(setup.writes<gaitway::WalkCommand>("behaviour_walk")) {}

  void step(const gaitway::Tick& tick) override {
    const double yaw_rad = estimate_.read().attitude[2];
    const double time_s = static_cast<double>(tick.now_ns) * 1e-9;
    if (turning_ && yaw_rad >= heading_rad_) {
      turning_ = false;
      side_ends_s_ = time_s + side_m_ / speed_m_per_s_;
    } else if (!turning_ && time_s >= side_ends_s_) {
      turning_ = true;
      heading_rad_ += std::numbers::pi / 2.0;  // the next corner
    }
    gaitway::WalkCommand& walk = walk_.value();
    walk.stamp_ns = tick.now_ns;
    walk.walk = time_s > kStand_s ? 1 : 0;
    walk.velocity[0] = turning_ ? 0.0 : speed_m_per_s_;
    walk.turn_rate = turning_ ? turn_rate_rad_per_s_ : 0.0;
    walk.valid_until_ns = tick.now_ns + kValid_ns;
    walk_.publish();
  }

 private:
  static constexpr double kStand_s = 1.0;
  static constexpr std::int64_t kValid_ns = 500'000'000;  // if nothing comes any more, the robot stands
  double side_m_, speed_m_per_s_, turn_rate_rad_per_s_;
  bool turning_ = true;
  double heading_rad_ = 0.0;  // to be reached by turning
  double side_ends_s_ = 0.0;
  gaitway::Input<gaitway::Estimate> estimate_;
  gaitway::Output<gaitway::WalkCommand> walk_;
};

GAITWAY_PLUGIN(PluginName, "plugin_name", "0.1.0", "Walks a square")

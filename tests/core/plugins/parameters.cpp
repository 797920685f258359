// Declares one parameter of each kind and publishes what it got.
#include "gaitway/plugin/plugin.hpp"

namespace {

class Parameters final : public gaitway::Plugin {
 public:
  explicit Parameters(gaitway::Setup& setup)
      : reporter_(setup.reporter()), output_(setup.writes<gaitway::Correction>("out")) {
    auto& value = output_.value();
    value.com_offset[0] = setup.parameter("step_time", 0.4, "s");
    value.com_offset[1] = setup.parameter("share", 0.15);
    value.step_offset[0] = static_cast<double>(setup.parameter("steps", 3));
    value.step_offset[1] = setup.parameter("mirror", true) ? 1.0 : 0.0;
    value.turn_rate_offset = setup.parameter("solver", "auto") == "auto" ? 1.0 : 2.0;
  }
  void step(const gaitway::Tick&) override {
    reporter_(gaitway::Severity::warning, "battery is low");
    output_.publish();
  }

 private:
  gaitway::Reporter reporter_;
  gaitway::Output<gaitway::Correction> output_;
};

}  // namespace

GAITWAY_PLUGIN(Parameters, "parameters", "1.0.0", "Has parameters")

#include "gaitway/plugin/plugin.hpp"

// Balance in a few lines: the ankles press against the trunk's lean.
class AnkleTrim final : public gaitway::Plugin {
 public:
  explicit AnkleTrim(gaitway::Setup& setup)
      : gain_(setup.parameter("gain", 0.25, "rad/rad")),
        estimate_(setup.reads<gaitway::Estimate>("estimate")),
        trim_(setup.writes<gaitway::TrimCommand>("trim")),
        correction_(setup.writes<gaitway::Correction>("correction")) {}

  void step(const gaitway::Tick& tick) override {
    const gaitway::Estimate& estimate = estimate_.read();
    gaitway::TrimCommand& trim = trim_.value();
    trim.stamp_ns = tick.now_ns;
    trim.channel_count = 8;
    trim.angle[4] = trim.angle[5] = gain_ * estimate.attitude[1];  // ankle pitch, left and right
    trim.angle[6] = trim.angle[7] = gain_ * estimate.attitude[0];  // ankle roll
    trim_.publish();
    correction_.publish();  // no wish for the next batch: all zero
  }

 private:
  double gain_;
  gaitway::Input<gaitway::Estimate> estimate_;
  gaitway::Output<gaitway::TrimCommand> trim_;
  gaitway::Output<gaitway::Correction> correction_;
};

GAITWAY_PLUGIN(AnkleTrim, "ankle_trim", "1.0.0", "Presses the ankles against the trunk's lean")

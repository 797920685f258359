// Counts its steps in the topic `to` and hands the count on: the brick of tests that replace plug-ins.
#include <stdexcept>

#include "gaitway/plugin/plugin.hpp"

namespace {

using gaitway::Correction;

class Counter final : public gaitway::Plugin {
 public:
  explicit Counter(gaitway::Setup& setup)
      : offset_(setup.live_parameter("offset", 0.0, "m",
                                     {.lowest = -10.0, .highest = 10'000.0, .doc = "added to the count"})),
        version_(setup.parameter("state_version", 1, "1", {.lowest = 0, .highest = 100})),
        longer_state_(setup.parameter("longer_state", false)),
        failing_step_(setup.parameter("failing_step", 0)),
        reports_(setup.parameter("reports", false)),
        report_(setup.reporter()),
        output_(setup.writes<Correction>(setup.parameter("to", "out"))) {
    if (setup.parameter("throws", false)) {
      throw std::runtime_error("no room for a counter");
    }
  }

  ~Counter() override { say("destroyed"); }

  void activate() override { say("activated"); }
  void deactivate() override { say("deactivated"); }
  void step(const gaitway::Tick&) override {
    say("stepped");
    ++count_;
    if (++steps_ == failing_step_) {
      throw std::runtime_error("cannot count");
    }
    output_.value().com_offset[0] = static_cast<double>(count_) + offset_;
    output_.publish();
  }

  [[nodiscard]] std::uint32_t state_version() const override { return static_cast<std::uint32_t>(version_); }
  void save_state(gaitway::StateWriter& state) const override {
    state(count_);
    if (longer_state_) state(count_);
  }
  void restore_state(gaitway::StateReader& state) override {
    state(count_);
    if (longer_state_) state(count_);
  }

 private:
  void say(const char* text) const {
    if (reports_) {
      report_(gaitway::Severity::info, text);
    }
  }

  gaitway::Live<double> offset_;
  std::int64_t version_;
  bool longer_state_;
  std::int64_t failing_step_;
  bool reports_;
  gaitway::Reporter report_;
  gaitway::Output<Correction> output_;
  std::int64_t count_ = 0;  // since the first version
  std::int64_t steps_ = 0;  // of this one
};

}  // namespace

GAITWAY_PLUGIN(Counter, "counter", "1.0.0", "Counts its steps")

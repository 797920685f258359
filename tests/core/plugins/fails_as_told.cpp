// Writes one of the standard topics and fails as its walk command tells it: walk 1: it throws, forward speed
// beyond 100: it publishes that number.
#include <stdexcept>
#include <string>

#include "gaitway/plugin/plugin.hpp"

namespace {

using namespace gaitway;

class FailsAsTold final : public Plugin {
 public:
  explicit FailsAsTold(Setup& setup)
      : orders_(setup.reads<WalkCommand>("orders")),
        trim_(setup.writes<TrimCommand>("trim")),
        correction_(setup.writes<Correction>("correction")) {
    if (setup.parameter("every_batch", false)) {
      setup.period(Period::batch);
    }
  }

  void step(const Tick& tick) override {
    trim_.value().stamp_ns = correction_.value().stamp_ns = tick.now_ns;
    trim_.value().channel_count = kTrimChannels;
    trim_.value().angle[0] = 0.1;
    trim_.value().gain[2][4][1] = 0.25;
    correction_.value().turn_rate_offset = 0.2;
    if (orders_.read().velocity[0] > 100.0) {
      trim_.value().angle[3] = orders_.read().velocity[0];
    } else {
      trim_.value().angle[3] = 0.0;
    }
    trim_.publish();
    correction_.publish();
    if (orders_.read().walk != 0) {
      throw std::runtime_error("as told");
    }
  }

 private:
  Input<WalkCommand> orders_;
  Output<TrimCommand> trim_;
  Output<Correction> correction_;
};

}  // namespace

GAITWAY_PLUGIN(FailsAsTold, "fails_as_told", "1.0.0", "Fails as told")

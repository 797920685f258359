// From tick 2 on one element of its output is not a number.
#include <limits>

#include "gaitway/plugin/plugin.hpp"

namespace {

class PublishesNan final : public gaitway::Plugin {
 public:
  explicit PublishesNan(gaitway::Setup& setup) : output_(setup.writes<gaitway::TrimCommand>("out")) {}
  void step(const gaitway::Tick& tick) override {
    output_.value().channel_count = tick.tick;
    if (tick.tick >= 2) {
      output_.value().gain[1][6][3] = std::numeric_limits<double>::quiet_NaN();
    }
    output_.publish();
  }

 private:
  gaitway::Output<gaitway::TrimCommand> output_;
};

}  // namespace

GAITWAY_PLUGIN(PublishesNan, "publishes_nan", "1.0.0", "Divides by zero")

// Publishes first and throws then, at every third tick; at tick 4 it throws what is no std::exception.
#include <stdexcept>

#include "gaitway/plugin/plugin.hpp"

namespace {

class ThrowsInStep final : public gaitway::Plugin {
 public:
  explicit ThrowsInStep(gaitway::Setup& setup) : output_(setup.writes<gaitway::Correction>("out")) {}
  void step(const gaitway::Tick& tick) override {
    output_.value().com_offset[0] = static_cast<double>(tick.tick);
    output_.publish();
    if (tick.tick % 3 == 0) {
      throw std::runtime_error("matrix is singular");
    }
    if (tick.tick == 4) {
      throw 4;
    }
  }

 private:
  gaitway::Output<gaitway::Correction> output_;
};

}  // namespace

GAITWAY_PLUGIN(ThrowsInStep, "throws_in_step", "1.0.0", "Fails now and then")

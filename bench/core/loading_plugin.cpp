// The smallest plug-in: the same class as the one that class_loader loads.
#include "gaitway/plugin/plugin.hpp"

namespace gaitway::bench {

class Relay final : public Plugin {
 public:
  explicit Relay(Setup&) {}
  void step(const Tick& tick) override { value_ = static_cast<double>(tick.now_ns) * 1e-9; }

 private:
  double value_ = 0.0;
};

}  // namespace gaitway::bench

GAITWAY_PLUGIN(gaitway::bench::Relay, "bench_relay", "1.0.0", "Does next to nothing")

// Its constructor throws.
#include <stdexcept>

#include "gaitway/plugin/plugin.hpp"

namespace {

class ThrowsInConstructor final : public gaitway::Plugin {
 public:
  explicit ThrowsInConstructor(gaitway::Setup&) { throw std::runtime_error("no calibration file"); }
  void step(const gaitway::Tick&) override {}
};

}  // namespace

GAITWAY_PLUGIN(ThrowsInConstructor, "throws_in_constructor", "1.0.0", "Does not come to life")

// Constructs, but cannot be activated.
#include <stdexcept>

#include "gaitway/plugin/plugin.hpp"

namespace {

class ThrowsInActivate final : public gaitway::Plugin {
 public:
  explicit ThrowsInActivate(gaitway::Setup&) {}
  void activate() override { throw std::runtime_error("the camera does not answer"); }
  void step(const gaitway::Tick&) override {}
};

}  // namespace

GAITWAY_PLUGIN(ThrowsInActivate, "throws_in_activate", "1.0.0", "Is constructed only")

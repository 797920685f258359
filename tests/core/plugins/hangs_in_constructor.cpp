// A plug-in whose constructor never returns.
#include <unistd.h>

#include "gaitway/plugin/plugin.hpp"

class HangsInConstructor final : public gaitway::Plugin {
 public:
  explicit HangsInConstructor(gaitway::Setup&) {
    while (true) {
      pause();
    }
  }
  void step(const gaitway::Tick&) override {}
};

GAITWAY_PLUGIN(HangsInConstructor, "hangs_in_constructor", "1.0.0", "Waits for ever")

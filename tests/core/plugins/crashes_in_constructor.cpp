// A plug-in whose constructor ends the process.
#include <cstdlib>

#include "gaitway/plugin/plugin.hpp"

class CrashesInConstructor final : public gaitway::Plugin {
 public:
  explicit CrashesInConstructor(gaitway::Setup&) { std::abort(); }
  void step(const gaitway::Tick&) override {}
};

GAITWAY_PLUGIN(CrashesInConstructor, "crashes_in_constructor", "1.0.0", "Aborts")

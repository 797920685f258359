// The plug-in `behaviour`: missions with the leaves over the public topics.
#include "gaitway/behaviour_leaves/behaviour_plugin.hpp"

namespace {

class Behaviour final : public gaitway::behaviour_leaves::BehaviourPlugin {
 public:
  explicit Behaviour(gaitway::Setup& setup) : BehaviourPlugin(setup) {}
};

}  // namespace

GAITWAY_PLUGIN(Behaviour, "behaviour", "1.0.0", "Decides: runs missions, which are behaviour trees in files")

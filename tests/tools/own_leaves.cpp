// A library with a leaf of its own, for `gaitway behaviour --with`.
#include "gaitway/behaviour_leaves/leaf_library.hpp"

namespace {

class CountTo final : public gaitway::behaviour::Action {
 public:
  gaitway::behaviour::Outcome on_start(gaitway::behaviour::Call&) noexcept override {
    return gaitway::behaviour::Outcome::success;
  }
  gaitway::behaviour::Outcome on_running(gaitway::behaviour::Call&) noexcept override {
    return gaitway::behaviour::Outcome::success;
  }
  Halt on_halt(gaitway::behaviour::Call&) noexcept override { return Halt::ended; }
};

void register_own(gaitway::behaviour::Registry& registry,
                  const std::shared_ptr<gaitway::behaviour_leaves::Robot>&) {
  registry.add_action(
      {.id = OWN_LEAF,
       .ports = {{.name = "most",
                  .type = {.kind = gaitway::behaviour::ValueKind::integer, .lowest = 1.0, .highest = 9.0},
                  .meaning = "where it ends"}},
       .meaning = "Counts"},
      [] { return std::make_unique<CountTo>(); });
}

}  // namespace

GAITWAY_BEHAVIOUR_LEAVES(register_own)

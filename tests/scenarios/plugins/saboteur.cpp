// A shipped plug-in, built anew with a fault of its own: from `sabotage_at` on, for the time `sabotage_for`,
// it does what `sabotage` names before it steps.
#include <cmath>

#include "gaitway/plugin/plugin.hpp"
#include "misbehaviour.hpp"

#pragma push_macro("GAITWAY_PLUGIN")
#undef GAITWAY_PLUGIN
#define GAITWAY_PLUGIN(...)  // this library's entry is the one below
#include GAITWAY_SABOTAGED_SOURCE
#pragma pop_macro("GAITWAY_PLUGIN")

namespace {

class Saboteur final : public gaitway::Plugin {
 public:
  explicit Saboteur(gaitway::Setup& setup)
      : misbehaviour_(setup.parameter("sabotage", "none")),
        begin_s_(setup.parameter("sabotage_at", 0.0, "s")),
        duration_s_(setup.parameter("sabotage_for", 0.0, "s")),
        sabotaged_(setup) {}

  void activate() override { sabotaged_.activate(); }
  void deactivate() override { sabotaged_.deactivate(); }
  void step(const gaitway::Tick& tick) override {
    const double now_s = static_cast<double>(tick.now_ns) * 1e-9;
    if (now_s >= begin_s_ && now_s < begin_s_ + duration_s_) {
      misbehaviour_.begin();
    }
    sabotaged_.step(tick);
  }
  [[nodiscard]] std::uint32_t state_version() const override { return sabotaged_.state_version(); }
  void save_state(gaitway::StateWriter& state) const override { sabotaged_.save_state(state); }
  void restore_state(gaitway::StateReader& state) override { sabotaged_.restore_state(state); }

 private:
  Misbehaviour misbehaviour_;
  double begin_s_, duration_s_;
  GAITWAY_SABOTAGED_CLASS sabotaged_;
};

}  // namespace

GAITWAY_PLUGIN(Saboteur, "saboteur", "1.0.0", "A shipped plug-in with a fault")

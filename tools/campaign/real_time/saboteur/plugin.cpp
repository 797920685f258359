// The shipped balance feedback with a fault of its own, for the campaign in real time: a live parameter says
// what goes wrong, and when. To be run in a process of its own.
#include <array>
#include <stdexcept>

#include "gaitway/plugin/plugin.hpp"
#include "misbehaviour.hpp"
#include "tools/campaign/real_time/sabotage_order.hpp"

#pragma push_macro("GAITWAY_PLUGIN")
#undef GAITWAY_PLUGIN
#define GAITWAY_PLUGIN(...)  // this library's entry is the one below
#include "plugins/stability/plugin.cpp"
#pragma pop_macro("GAITWAY_PLUGIN")

namespace {

class CampaignSaboteur final : public gaitway::Plugin {
 public:
  explicit CampaignSaboteur(gaitway::Setup& setup)
      : order_(setup.live_parameter("sabotage_order", std::int64_t{0})), sabotaged_(setup) {}

  void activate() override { sabotaged_.activate(); }
  void deactivate() override { sabotaged_.deactivate(); }
  void step(const gaitway::Tick& tick) override {
    if (const std::int64_t order = order_.get();
        order != done_ && gaitway::tools::is_due(order, tick.now_ns)) {
      done_ = order;
      Misbehaviour(gaitway::tools::sabotage_of(order)).begin();
    }
    sabotaged_.step(tick);
  }
  [[nodiscard]] std::uint32_t state_version() const override { return sabotaged_.state_version(); }
  void save_state(gaitway::StateWriter& state) const override { sabotaged_.save_state(state); }
  void restore_state(gaitway::StateReader& state) override { sabotaged_.restore_state(state); }

 private:
  gaitway::Live<std::int64_t> order_;
  std::int64_t done_ = 0;
  gaitway::stability::Stability sabotaged_;
};

}  // namespace

GAITWAY_PLUGIN(CampaignSaboteur, "saboteur", "1.0.0",
               "The shipped balance feedback, which fails as it is told")

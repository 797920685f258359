// The behaviour plug-in as a class, for those who add leaves of their own:
//
//   class MyBehaviour final : public gaitway::behaviour_leaves::BehaviourPlugin {
//    public:
//     explicit MyBehaviour(gaitway::Setup& setup)
//         : BehaviourPlugin(setup, [](auto& registry, const auto& robot) {
//             registry.add_action({.id = "Dance"}, [robot] { return std::make_unique<Dance>(robot); });
//           }) {}
//   };
//   GAITWAY_PLUGIN(MyBehaviour, "behaviour", "1.0.0", "Dances, too")
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "gaitway/behaviour_leaves/leaves.hpp"
#include "gaitway/behaviour_leaves/mission_runner.hpp"
#include "gaitway/plugin/plugin.hpp"

namespace gaitway::behaviour_leaves {

class BehaviourPlugin : public Plugin {
 public:
  using MoreLeaves = std::function<void(behaviour::Registry&, const std::shared_ptr<Robot>&)>;
  // `mission`: the one that begins at the start where the parameter of that name does not say another.
  explicit BehaviourPlugin(Setup& setup, const MoreLeaves& more = {}, const std::string& mission = "");

  void step(const Tick& tick) override;

  [[nodiscard]] std::uint32_t state_version() const override { return 1; }
  void save_state(StateWriter& state) const override;
  void restore_state(StateReader& state) override;

 private:
  // Two ticks before the batch is prepared: what is ordered then is in time for it, also from another
  // process.
  static constexpr std::uint32_t kSlot = core::kBatchSlot - 2;
  // A walk that is not renewed ends then.
  static constexpr std::int64_t kWalkValid_ns = 500'000'000;

  struct Events final : MissionRunner::Listener {
    explicit Events(const Reporter& to) : report(to) {}
    void on_line(bool is_trouble, const char* text) noexcept override {
      report(is_trouble ? Severity::warning : Severity::info, text);
    }
    Reporter report;
  };

  void look(const Tick& tick);
  void pass_on();

  std::shared_ptr<Robot> robot_;
  behaviour::Registry registry_;
  Live<bool> enabled_;
  Events events_;
  MissionRunner runner_;
  bool walked_ = false, way_is_walked_ = false;
  bool ends_old_way_ = false;  // of the plug-in before this one
  Input<Estimate> estimate_;
  Input<FootstepState> footsteps_;
  Input<NavigationState> navigation_;
  Input<MotionState> motion_state_;
  Input<CommandState> command_;
  Input<SeenTargets> targets_;
  Input<VisionState> vision_;
  Input<NetworkState> network_;
  Input<BehaviourRequest> request_;
  Output<WalkCommand> walk_;
  Output<WalkToRequest> way_;
  Output<MotionRequest> motion_;
  Output<HeadCommand> head_;
  Output<BehaviourState> state_;
  Output<BehaviourNodes> nodes_;
};

}  // namespace gaitway::behaviour_leaves

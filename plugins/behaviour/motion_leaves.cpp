// Key-frame motions that begin in the stand.
#include "leaf_base.hpp"
#include "played_motion.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::Call;
using behaviour::Outcome;

// A motion that began upright is left in a fall: nothing that it does then is what it is for.
class PlayMotion final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    const auto name = call.get<behaviour::Text>(0);
    if (!name || name->view().empty()) return fail("PlayMotion", "its port 'motion' has no value");
    began_upright_ = now().is_upright();
    motion_.order(name->view(), now(), orders());
    return Outcome::running;
  }

  Outcome on_running(Call&) noexcept override {
    if (began_upright_ && now().has_fallen()) {
      motion_.leave(now(), orders());
      return fail("PlayMotion", "the robot has fallen");
    }
    using Stage = PlayedMotion::Stage;
    switch (motion_.stage(now(), orders())) {
      case Stage::waits:
      case Stage::plays:
        return Outcome::running;
      case Stage::finished:
        return Outcome::success;
      case Stage::refused:
        return fail("PlayMotion", text_of(now().motion->text));
      case Stage::broken_off:
        return fail("PlayMotion", "the motion did not come to its end");
      case Stage::not_answered:
        return fail("PlayMotion", "the order has not been answered");
      case Stage::replaced:
        return fail("PlayMotion", "another node plays a motion of its own");
    }
    return Outcome::failure;
  }

  Halt on_halt(Call& call) noexcept override {
    if (now().commands_motions()) motion_.leave(now(), orders());
    return on_halting(call);
  }
  Halt on_halting(Call&) noexcept override {
    return motion_.has_left(now(), orders()) ? Halt::ended : Halt::ending;
  }

 private:
  bool began_upright_ = true;
  PlayedMotion motion_;
};

}  // namespace

void register_motions(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot) {
  registry.add_action(
      {.id = "PlayMotion",
       .ports = {text_port("motion", std::nullopt,
                           "name of one of the robot's, as `gaitway motion list` tells")},
       .meaning =
           "Plays a key-frame motion to its end. Fails with the reason for which it was refused, where it "
           "was left or broken off, and, if it began upright, in a fall"},
      [robot] { return std::make_unique<PlayMotion>(robot); });
}

}  // namespace gaitway::behaviour_leaves

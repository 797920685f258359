// Where the head looks.
#include <cmath>

#include "head_watch.hpp"
#include "leaf_base.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::Call;
using behaviour::Outcome;

HeadCommand toward(const double (&point_m)[3]) noexcept {
  HeadCommand command{};
  command.mode = head_command::mode::point;
  for (int i = 0; i < 3; ++i) command.point[i] = point_m[i];
  return command;
}

// Goes to where it is to look, and succeeds there.
class LookTo final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    HeadCommand command{};
    command.mode = head_command::mode::direction;
    command.direction[0] = call.get<double>(0).value_or(0.0);
    command.direction[1] = call.get<double>(1).value_or(0.0);
    orders().look(command);
    watch_.begin(call.now_ns());
    return Outcome::running;
  }
  Outcome on_running(Call& call) noexcept override {
    if (now().estimate == nullptr) return fail("LookTo", not_upright());
    watch_.look(now());
    if (!watch_.is_still(call.now_ns())) return Outcome::running;
    const double(&head)[2] = now().estimate->head;
    const double off_rad =
        std::hypot(head[0] - call.get<double>(0).value_or(0.0), head[1] - call.get<double>(1).value_or(0.0));
    return off_rad <= kThere_rad ? Outcome::success : fail("LookTo", "the neck does not go there");
  }
  Halt on_halt(Call&) noexcept override { return Halt::ended; }

 private:
  static constexpr double kThere_rad = 0.07;
  HeadWatch watch_;
};

class LookAt final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    const auto odometry = now().odometry();
    if (!odometry) return fail("LookAt", "there is no navigation that knows the world");
    const auto x_m = call.get<double>(0), y_m = call.get<double>(1), z_m = call.get<double>(2);
    if (!x_m || !y_m || !z_m) return fail("LookAt", "a port of its point has no value");
    const Pose at = inside(*odometry, Pose{*x_m, *y_m, 0.0});
    orders().look(toward({at.x_m, at.y_m, *z_m}));
    watch_.begin(call.now_ns());
    return Outcome::running;
  }
  Outcome on_running(Call& call) noexcept override {
    if (now().estimate == nullptr) return fail("LookAt", not_upright());
    watch_.look(now());
    return watch_.is_still(call.now_ns()) ? Outcome::success : Outcome::running;
  }
  Halt on_halt(Call&) noexcept override { return Halt::ended; }

 private:
  HeadWatch watch_;
};

class LookAhead final : public RobotAction {
 public:
  using RobotAction::RobotAction;
  Outcome on_start(Call&) noexcept override {
    orders().look_ahead();
    return Outcome::success;
  }
  Outcome on_running(Call&) noexcept override { return Outcome::success; }
  Halt on_halt(Call&) noexcept override { return Halt::ended; }
};

// Until it is halted; then the head goes back.
class LookAtTag final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    looks_ = false;
    return on_running(call);
  }
  Outcome on_running(Call& call) noexcept override {
    const auto tag = now().tag(call.get<std::int64_t>(0).value_or(-1), call.get<std::int64_t>(1).value_or(0));
    if (!tag) {
      orders().look_ahead_after(look_);
      return Outcome::failure;
    }
    const double(&to)[3] = tag->position_m;
    constexpr double kNews_m = 0.02;
    const bool has_moved = std::hypot(to[0] - at_m_[0], to[1] - at_m_[1], to[2] - at_m_[2]) > kNews_m;
    if (!looks_ || has_moved) {
      for (int i = 0; i < 3; ++i) at_m_[i] = to[i];
      look_ = orders().look(toward(at_m_));
      looks_ = true;
    }
    return Outcome::running;
  }
  Halt on_halt(Call&) noexcept override {
    if (now().commands()) orders().look_ahead_after(look_);
    return Halt::ended;
  }

 private:
  bool looks_ = false;
  std::uint32_t look_ = 0;  // its newest order
  double at_m_[3] = {};     // odometry
};

class LookAround final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    HeadCommand command{};
    command.mode = head_command::mode::scan;
    command.extent = call.get<double>(0).value_or(0.0);
    command.direction[1] = call.get<double>(1).value_or(0.0);
    command.period = static_cast<double>(call.get<std::int64_t>(2).value_or(0)) * 1e-9;
    look_ = orders().look(command);
    return Outcome::running;
  }
  Outcome on_running(Call&) noexcept override { return Outcome::running; }
  Halt on_halt(Call&) noexcept override {
    if (now().commands()) orders().look_ahead_after(look_);
    return Halt::ended;
  }

 private:
  std::uint32_t look_ = 0;  // its order
};

}  // namespace

void register_head(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot) {
  registry.add_action({.id = "LookTo",
                       .ports = {number_port("yaw", "rad", -3.2, 3.2, "0 rad", "from the trunk, to the left"),
                                 number_port("pitch", "rad", -1.6, 1.6, "0 rad", "from the trunk, down")},
                       .meaning = "Turns the head there. Fails where the neck does not reach"},
                      [robot] { return std::make_unique<LookTo>(robot); });
  registry.add_action(
      {.id = "LookAt",
       .ports = {number_port("x", "m", -1e4, 1e4, std::nullopt, "world"),
                 number_port("y", "m", -1e4, 1e4, std::nullopt, "world"),
                 number_port("z", "m", -100.0, 100.0, "0 m", "above the ground")},
       .meaning = "Turns the head to a point and keeps it there; succeeds when it has come to rest"},
      [robot] { return std::make_unique<LookAt>(robot); });
  registry.add_action({.id = "LookAhead", .ports = {}, .meaning = "Sends the head home"},
                      [robot] { return std::make_unique<LookAhead>(robot); });
  registry.add_action({.id = "LookAtTag",
                       .ports = {tag_port(), oldest_port("3 s")},
                       .meaning = "Keeps the eyes on a tag until it is halted; fails when the tag is lost"},
                      [robot] { return std::make_unique<LookAtTag>(robot); });
  registry.add_action({.id = "LookAround",
                       .ports = {number_port("extent", "rad", 0.0, 3.2, "60 deg", "to either side"),
                                 number_port("pitch", "rad", -1.6, 1.6, "0 rad", "down"),
                                 duration_port("period", "4 s", "from one side to the other and back")},
                       .meaning = "Has the head scan until it is halted"},
                      [robot] { return std::make_unique<LookAround>(robot); });
}

}  // namespace gaitway::behaviour_leaves

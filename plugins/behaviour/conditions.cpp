// The conditions, the wait for one of them, and what is said to people.
#include <cmath>
#include <functional>

#include "leaf_base.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::Call;
using behaviour::Outcome;

using Question = bool (Situation::*)() const noexcept;

class Asks final : public RobotCondition {
 public:
  Asks(std::shared_ptr<Robot> robot, Question question)
      : RobotCondition(std::move(robot)), question_(question) {}
  bool holds(Call&) noexcept override { return (now().*question_)(); }

 private:
  Question question_;
};

struct NamedQuestion {
  const char* leaf;
  const char* word;  // of WaitUntil
  Question question;
  const char* meaning;
};
constexpr NamedQuestion kQuestions[] = {
    {"Fallen", "fallen", &Situation::has_fallen, "the robot falls, or lies"},
    {"Lies", "lies", &Situation::lies, "the robot lies"},
    {"Upright", "upright", &Situation::is_upright, "the robot neither falls nor lies"},
    {"Stands", "stands", &Situation::stands, "the robot is upright and at rest: no walk, no motion"},
    {"HasCommand", "has_command", &Situation::commands, "the behaviour's orders are obeyed"},
    {"PersonCommands", "person_commands", &Situation::person_commands,
     "a person has the command, or an emergency stop is in force"},
    {"CamerasSee", "cameras_see", &Situation::sees, "the cameras work, be it in part"},
};

class SeesTag final : public RobotCondition {
 public:
  using RobotCondition::RobotCondition;
  bool holds(Call& call) noexcept override {
    return now()
        .tag(call.get<std::int64_t>(0).value_or(-1), call.get<std::int64_t>(1).value_or(0))
        .has_value();
  }
};

class TagIsNear final : public RobotCondition {
 public:
  using RobotCondition::RobotCondition;
  bool holds(Call& call) noexcept override {
    const auto tag = now().tag(call.get<std::int64_t>(0).value_or(-1), call.get<std::int64_t>(2).value_or(0));
    return tag && now().distance_m(*tag) <= call.get<double>(1).value_or(0.0);
  }
};

class IsAt final : public RobotCondition {
 public:
  using RobotCondition::RobotCondition;
  bool holds(Call& call) noexcept override {
    const auto place = now().place();
    if (!place) return false;
    const auto x_m = call.get<double>(0), y_m = call.get<double>(1);
    return x_m && y_m &&
           std::hypot(place->x_m - *x_m, place->y_m - *y_m) <= call.get<double>(2).value_or(0.0);
  }
};

class WaitUntil final : public RobotAction {
 public:
  using RobotAction::RobotAction;
  Outcome on_start(Call& call) noexcept override { return on_running(call); }
  Outcome on_running(Call& call) noexcept override {
    const auto which = static_cast<std::size_t>(call.get<std::int64_t>(0).value_or(0));
    return (now().*kQuestions[which].question)() ? Outcome::success : Outcome::running;
  }
  Halt on_halt(Call&) noexcept override { return Halt::ended; }
};

class Say final : public RobotAction {
 public:
  using RobotAction::RobotAction;
  Outcome on_start(Call& call) noexcept override {
    if (const auto text = call.get<behaviour::Text>(0)) orders().say(text->view());
    return Outcome::success;
  }
  Outcome on_running(Call&) noexcept override { return Outcome::success; }
  Halt on_halt(Call&) noexcept override { return Halt::ended; }
};

}  // namespace

void register_conditions(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot) {
  std::vector<std::string> words;
  for (const NamedQuestion& named : kQuestions) {
    words.emplace_back(named.word);
    registry.add_condition({.id = named.leaf, .ports = {}, .meaning = named.meaning},
                           [robot, &named] { return std::make_unique<Asks>(robot, named.question); });
  }
  registry.add_condition({.id = "SeesTag",
                          .ports = {tag_port(), oldest_port("0.5 s")},
                          .meaning = "the cameras have seen the tag not long ago"},
                         [robot] { return std::make_unique<SeesTag>(robot); });
  registry.add_condition(
      {.id = "TagIsNear",
       .ports = {tag_port(),
                 number_port("within", "m", 0.0, 100.0, std::nullopt, "level distance from the base"),
                 oldest_port("2 s")},
       .meaning = "the tag has been seen not long ago, and is near"},
      [robot] { return std::make_unique<TagIsNear>(robot); });
  registry.add_condition({.id = "IsAt",
                          .ports = {number_port("x", "m", -1e4, 1e4, std::nullopt, "world"),
                                    number_port("y", "m", -1e4, 1e4, std::nullopt, "world"),
                                    number_port("within", "m", 0.0, 100.0, "0.1 m", "distance from it")},
                          .meaning = "the middle between the feet is at a place, as navigation estimates it"},
                         [robot] { return std::make_unique<IsAt>(robot); });
  registry.add_action(
      {.id = "WaitUntil",
       .ports = {choice_port("what", std::move(words), std::nullopt, "as the condition of that name has it")},
       .meaning = "Runs until that holds"},
      [robot] { return std::make_unique<WaitUntil>(robot); });
  registry.add_action({.id = "Say",
                       .ports = {text_port("text", std::nullopt, "for people")},
                       .meaning = "Puts a line into the list of events"},
                      [robot] { return std::make_unique<Say>(robot); });
}

}  // namespace gaitway::behaviour_leaves

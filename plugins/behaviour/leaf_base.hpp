// What the leaves are made of: their ports, the robot they share, and how long an order takes to be seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "fixed_text.hpp"
#include "gaitway/behaviour/leaf.hpp"
#include "gaitway/behaviour/registry.hpp"
#include "gaitway/behaviour_leaves/leaves.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::behaviour_leaves {

// From an order to the first state that it shows in: the batch that is planned next has it, and plays a cycle
// later.
inline constexpr std::int64_t kOrderShows_ns = 3 * facts::kCycle_ns;
// An order that has had no answer by then has been lost, or there is nobody to answer.
inline constexpr std::int64_t kOrderIsAnswered_ns = 1'000'000'000;

class RobotCondition : public behaviour::Condition {
 public:
  explicit RobotCondition(std::shared_ptr<Robot> robot) : robot_(std::move(robot)) {}

 protected:
  [[nodiscard]] const Situation& now() const noexcept { return robot_->situation; }

 private:
  std::shared_ptr<Robot> robot_;
};

class RobotAction : public behaviour::Action {
 public:
  explicit RobotAction(std::shared_ptr<Robot> robot) : robot_(std::move(robot)) {}

 protected:
  [[nodiscard]] const Situation& now() const noexcept { return robot_->situation; }
  [[nodiscard]] Orders& orders() const noexcept { return robot_->orders; }
  [[nodiscard]] const TimeOnFeet& on_feet() const noexcept { return robot_->on_feet; }
  // Why one that is not upright, as far as is known, is not.
  [[nodiscard]] const char* not_upright() const noexcept {
    return now().estimate == nullptr ? "nothing is known of the robot's posture"
           : now().lies()            ? "the robot lies"
                                     : "the robot falls";
  }
  // Says why, and fails.
  [[nodiscard]] behaviour::Outcome fail(std::string_view leaf, std::string_view why) const noexcept {
    orders().tell_trouble(leaf, why);
    return behaviour::Outcome::failure;
  }

 private:
  std::shared_ptr<Robot> robot_;
};

// The end of a walk: not asked for any more, and at rest. Nothing is left to wait for where somebody else
// commands, the robot has fallen, or nobody plans its steps.
class WalkEnd {
 public:
  void begin(std::int64_t now_ns) noexcept { since_ns_ = now_ns; }
  [[nodiscard]] bool is_reached(const Situation& now) const noexcept {
    if (!now.commands() || !now.is_upright() || now.footsteps == nullptr) return true;
    return now.now_ns - since_ns_ >= kOrderShows_ns && now.stands();
  }

 private:
  std::int64_t since_ns_ = 0;
};

inline behaviour::PortSpec number_port(std::string name, std::string unit, double lowest, double highest,
                                       std::optional<std::string> standard, std::string meaning) {
  return {.name = std::move(name),
          .type = {.kind = behaviour::ValueKind::number,
                   .unit = std::move(unit),
                   .lowest = lowest,
                   .highest = highest},
          .standard = std::move(standard),
          .meaning = std::move(meaning)};
}

inline behaviour::PortSpec output_port(std::string name, std::string unit, std::string meaning) {
  return {.name = std::move(name),
          .type = {.kind = behaviour::ValueKind::number, .unit = std::move(unit)},
          .direction = behaviour::PortDirection::output,
          .meaning = std::move(meaning)};
}

inline behaviour::PortSpec duration_port(std::string name, std::string standard, std::string meaning) {
  return {.name = std::move(name),
          .type = {.kind = behaviour::ValueKind::duration},
          .standard = std::move(standard),
          .meaning = std::move(meaning)};
}

inline behaviour::PortSpec integer_port(std::string name, double lowest, double highest,
                                        std::optional<std::string> standard, std::string meaning) {
  return {.name = std::move(name),
          .type = {.kind = behaviour::ValueKind::integer,
                   .unit = {},
                   .choices = {},
                   .lowest = lowest,
                   .highest = highest},
          .standard = std::move(standard),
          .meaning = std::move(meaning)};
}

inline behaviour::PortSpec text_port(std::string name, std::optional<std::string> standard,
                                     std::string meaning) {
  return {.name = std::move(name),
          .type = {.kind = behaviour::ValueKind::text},
          .standard = std::move(standard),
          .meaning = std::move(meaning)};
}

inline behaviour::PortSpec choice_port(std::string name, std::vector<std::string> choices,
                                       std::optional<std::string> standard, std::string meaning) {
  return {.name = std::move(name),
          .type = {.kind = behaviour::ValueKind::choice, .unit = {}, .choices = std::move(choices)},
          .standard = std::move(standard),
          .meaning = std::move(meaning)};
}

inline behaviour::PortSpec tag_port() {
  return integer_port("id", 0, 586, std::nullopt, "of the tag, in the family 36h11");
}
inline behaviour::PortSpec oldest_port(std::string standard) {
  return duration_port("not_older", std::move(standard), "how long ago it may have been seen");
}

void register_conditions(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot);
void register_walking(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot);
void register_ways(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot);
void register_head(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot);
void register_search(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot);
void register_motions(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot);
void register_getting_up(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot);

}  // namespace gaitway::behaviour_leaves

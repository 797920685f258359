// Actions and conditions that follow a script.
#include "scripted_leaves.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace gaitway::behaviour::test {
namespace {

constexpr std::size_t kDoes = 0, kEnds = 1;

// The letters of a port `does`, one after the other.
class Letters {
 public:
  char next(const Call& call) {
    const std::string_view all = std::get<Text>(call.value(kDoes)).view();
    return all[place_++ % all.size()];
  }

 private:
  std::size_t place_ = 0;
};

Outcome outcome(char letter) {
  switch (letter) {
    case 'R':
      return Outcome::running;
    case 'S':
      return Outcome::success;
    case 'K':
      return Outcome::skipped;
    default:
      return Outcome::failure;
  }
}

class ScriptedAction final : public Action {
 public:
  ScriptedAction(Script& script, std::string name) : script_(script), name_(std::move(name)) {}

  Outcome on_start(Call& call) noexcept override { return answer(call, '+'); }
  Outcome on_running(Call& call) noexcept override { return answer(call, '.'); }
  Halt on_halt(Call& call) noexcept override {
    left_ = call.get<std::int64_t>(kEnds).value_or(0);
    script_.write(name_, left_ > 0 ? "~" : "-");
    return left_ > 0 ? Halt::ending : Halt::ended;
  }
  Halt on_halting(Call&) noexcept override {
    --left_;
    script_.write(name_, left_ > 0 ? "~~" : "~-");
    return left_ > 0 ? Halt::ending : Halt::ended;
  }

 private:
  Outcome answer(const Call& call, char sign) {
    const char letter = letters_.next(call);
    script_.write(name_, std::string{sign, letter});
    return outcome(letter);
  }

  Script& script_;
  std::string name_;
  Letters letters_;
  std::int64_t left_ = 0;
};

class ScriptedCondition final : public Condition {
 public:
  ScriptedCondition(Script& script, std::string name) : script_(script), name_(std::move(name)) {}

  bool holds(Call& call) noexcept override {
    const char letter = letters_.next(call);
    script_.write(name_, std::string{'?', letter});
    return letter == 'S';
  }

 private:
  Script& script_;
  std::string name_;
  Letters letters_;
};

}  // namespace

Script::Script() {
  const PortSpec does{.name = "does", .type = {.kind = ValueKind::text}, .standard = "S"};
  const PortSpec ends{.name = "ends", .type = {.kind = ValueKind::integer, .lowest = 0.0}, .standard = "0"};
  for (const char* const id : {"A", "B", "C", "D", "E", "F"}) {
    registry_.add_action({.id = id, .ports = {does, ends}},
                         [this, id] { return std::make_unique<ScriptedAction>(*this, id); });
  }
  for (const char* const id : {"P", "Q", "R", "S"}) {
    registry_.add_condition({.id = id, .ports = {does}},
                            [this, id] { return std::make_unique<ScriptedCondition>(*this, id); });
  }
  log_.reserve(1U << 16U);
}

void Script::write(std::string_view leaf, std::string_view what) {
  log_ += leaf;
  log_ += what;
  log_ += ' ';
}

std::string Script::take() {
  return std::exchange(log_, "");
}

std::string file_of(std::string_view nodes) {
  return fmt::format("<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">{}</BehaviorTree></root>", nodes);
}

Description described(std::string_view nodes, const Script& script) {
  return parse_tree(file_of(nodes), "t.xml", script.registry());
}

std::string trace(Tree& tree, Script& script, int ticks, int from) {
  constexpr std::string_view kLetters = "?RSFK?";
  std::string all;
  for (int tick = from; tick < from + ticks; ++tick) {
    const NodeStatus answer = tree.tick(tick * kTick_ns);
    all += (all.empty() ? "" : " | ") + script.take() + "=" + kLetters[static_cast<std::size_t>(answer)];
  }
  return all;
}

}  // namespace gaitway::behaviour::test

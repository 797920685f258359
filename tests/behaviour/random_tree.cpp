// Random trees as text, and the leaves in them.
#include "random_tree.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <string_view>

namespace gaitway::behaviour::test {
namespace {

class RandomAction final : public Action {
 public:
  RandomAction(RandomLeaves& leaves, Watch& watch) : leaves_(leaves), watch_(watch) {}

  Outcome on_start(Call&) noexcept override {
    expect(Watch::State::idle, "on_start");
    ++watch_.started;
    return answer();
  }
  Outcome on_running(Call&) noexcept override {
    expect(Watch::State::running, "on_running");
    return answer();
  }
  Halt on_halt(Call&) noexcept override {
    expect(Watch::State::running, "on_halt");
    ++watch_.halted;
    return end();
  }
  Halt on_halting(Call&) noexcept override {
    expect(Watch::State::halting, "on_halting");
    return end();
  }

 private:
  void expect(Watch::State state, const char* call) {
    if (watch_.state != state && watch_.fault.empty()) {
      watch_.fault =
          fmt::format("{}() in state {} at tick {}", call, static_cast<int>(watch_.state), leaves_.tick());
    }
  }
  Outcome answer() {
    if (watch_.seen_in == leaves_.tick() && watch_.fault.empty()) watch_.fault = "visited twice in a tick";
    watch_.seen_in = leaves_.tick();
    constexpr std::array<Outcome, 8> kAnswers{Outcome::running, Outcome::running, Outcome::running,
                                              Outcome::success, Outcome::success, Outcome::success,
                                              Outcome::failure, Outcome::skipped};
    const Outcome outcome = kAnswers[leaves_.below(kAnswers.size())];
    watch_.state = outcome == Outcome::running ? Watch::State::running : Watch::State::idle;
    watch_.ended += outcome == Outcome::running ? 0 : 1;
    return outcome;
  }
  Halt end() {
    const bool more = leaves_.below(2) == 0;
    watch_.state = more ? Watch::State::halting : Watch::State::idle;
    return more ? Halt::ending : Halt::ended;
  }

  RandomLeaves& leaves_;
  Watch& watch_;
};

class RandomCondition final : public Condition {
 public:
  explicit RandomCondition(RandomLeaves& leaves) : leaves_(leaves) {}
  bool holds(Call&) noexcept override {
    leaves_.see_condition(last_);
    return leaves_.below(3) != 0;
  }

 private:
  RandomLeaves& leaves_;
  int last_ = -1;
};

class Writer {
 public:
  Writer(std::uint64_t seed, int nodes) : random_(seed), left_(nodes) {}

  std::string file() {
    std::string text = "<root BTCPP_format=\"4\" main_tree_to_execute=\"M\">\n";
    const int shares = left_ / 4;
    for (int i = 2; i >= 0; --i) {
      const int rest = left_;
      left_ = shares;
      sub_trees_ = i + 1;
      text += tree(fmt::format("U{}", i));
      left_ = rest;
    }
    sub_trees_ = 0;
    return text + tree("M") + "</root>";
  }

 private:
  unsigned below(unsigned bound) { return static_cast<unsigned>(random_() % bound); }

  std::string tree(const std::string& id) {
    return fmt::format("<BehaviorTree ID=\"{}\">{}</BehaviorTree>\n", id, node(0));
  }

  std::string leaf() {
    --left_;
    switch (below(12)) {
      case 0:
        return "<AlwaysSuccess/>";
      case 1:
        return "<AlwaysFailure/>";
      case 2:
        return fmt::format("<Sleep msec=\"{}\"/>", below(40));
      case 3:
        return fmt::format("<SetBlackboard value=\"{}\" output_key=\"v\"/>", "abc"[below(3)]);
      case 4:
      case 5:
      case 6:
        return "<Ask/>";
      default:
        return "<Act/>";
    }
  }

  std::string children(unsigned count, int depth) {
    std::string text;
    for (unsigned i = 0; i < count; ++i) text += node(depth + 1);
    return text;
  }

  std::string node(int depth) {
    constexpr int kDeepest = 12;
    if (left_ <= 0 || depth >= kDeepest) return leaf();
    --left_;
    switch (below(4)) {
      case 0:
        return leaf();
      case 1:
        return decorator(depth);
      default:
        return control(depth);
    }
  }

  std::string control(int depth) {
    constexpr std::array<std::string_view, 6> kPlain{"Sequence", "SequenceWithMemory", "ReactiveSequence",
                                                     "Fallback", "ReactiveFallback",   "ParallelAll"};
    const unsigned kind = below(10);
    if (kind < kPlain.size())
      return fmt::format("<{0}>{1}</{0}>", kPlain[kind], children(1 + below(4), depth));
    if (kind == 6) {
      const unsigned count = 1 + below(4);
      return fmt::format("<Parallel success_count=\"{}\" failure_count=\"{}\">{}</Parallel>",
                         1 + below(count), 1 + below(count), children(count, depth));
    }
    if (kind == 7) return fmt::format("<IfThenElse>{}</IfThenElse>", children(2 + below(2), depth));
    if (kind == 8) return fmt::format("<WhileDoElse>{}</WhileDoElse>", children(2 + below(2), depth));
    return fmt::format("<Switch2 variable=\"{{v}}\" case_1=\"a\" case_2=\"b\">{}</Switch2>",
                       children(3, depth));
  }

  std::string decorator(int depth) {
    constexpr std::array<std::string_view, 5> kPlain{"Inverter", "ForceSuccess", "ForceFailure",
                                                     "KeepRunningUntilFailure", "RunOnce"};
    const unsigned kind = below(11);
    if (kind < kPlain.size()) return fmt::format("<{0}>{1}</{0}>", kPlain[kind], node(depth + 1));
    if (kind == 5) return fmt::format("<Repeat num_cycles=\"{}\">{}</Repeat>", below(4), node(depth + 1));
    if (kind == 6) {
      return fmt::format("<RetryUntilSuccessful num_attempts=\"{}\">{}</RetryUntilSuccessful>", below(4),
                         node(depth + 1));
    }
    if (kind == 7) return fmt::format("<Timeout msec=\"{}\">{}</Timeout>", below(60), node(depth + 1));
    if (kind == 8) return fmt::format("<Delay delay_msec=\"{}\">{}</Delay>", below(60), node(depth + 1));
    if (kind == 9) return fmt::format("<Cooldown msec=\"{}\">{}</Cooldown>", below(60), node(depth + 1));
    if (sub_trees_ > 2) return leaf();
    return fmt::format("<SubTree ID=\"U{}\" _autoremap=\"{}\"/>",
                       sub_trees_ + static_cast<int>(below(static_cast<unsigned>(3 - sub_trees_))),
                       below(2) == 0);
  }

  std::mt19937_64 random_;
  int left_;
  int sub_trees_ = 0;  // those from this number on are written already
};

}  // namespace

RandomLeaves::RandomLeaves(std::uint64_t seed) : random_(seed) {
  registry_.add_action({.id = "Act"}, [this] {
    watches_.push_back(std::make_unique<Watch>());
    return std::make_unique<RandomAction>(*this, *watches_.back());
  });
  registry_.add_condition({.id = "Ask"}, [this] { return std::make_unique<RandomCondition>(*this); });
}

std::string random_file(std::uint64_t seed, int nodes) {
  return Writer(seed, nodes).file();
}

}  // namespace gaitway::behaviour::test

// Leaves that answer as a tree's file tells them and write down how they are called, for all tests of trees.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/behaviour/read.hpp"
#include "gaitway/behaviour/tree.hpp"

namespace gaitway::behaviour::test {

// Actions A to F and conditions P to S, each with a port `does`: the answers in turn, from the first again at
// the end. R, S, F and K mean running, success, failure and skipped. `ends` tells how many ticks an action
// takes to end after on_halt(), besides the one of the halt.
//
// What is written down: "A+R" on_start() and its answer, "A.S" on_running(), "A-" on_halt() that ends it,
// "A~" on_halt() that does not, "A~~" and "A~-" on_halting(), "P?S" a condition.
class Script {
 public:
  Script();

  [[nodiscard]] const Registry& registry() const noexcept { return registry_; }
  [[nodiscard]] Registry& registry() noexcept { return registry_; }
  void write(std::string_view leaf, std::string_view what);
  // What was written since the last call.
  [[nodiscard]] std::string take();

 private:
  Registry registry_;
  std::string log_;
};

// <root> around the nodes of one tree "T".
[[nodiscard]] std::string file_of(std::string_view nodes);
[[nodiscard]] Description described(std::string_view nodes, const Script& script);

inline constexpr std::int64_t kTick_ns = 10'000'000;

// The calls and the result of each of `ticks` ticks, 10 ms apart, from `from` on: "A+R =R | A.S =S".
[[nodiscard]] std::string trace(Tree& tree, Script& script, int ticks, int from = 0);

}  // namespace gaitway::behaviour::test

// Trees made at random, and leaves that answer at random and watch that they are called by contract.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "gaitway/behaviour/read.hpp"
#include "gaitway/behaviour/tree.hpp"

namespace gaitway::behaviour::test {

// What one action of a random tree has seen.
struct Watch {
  enum class State : std::uint8_t { idle, running, halting };
  State state = State::idle;
  int started = 0;
  int ended = 0;        // by an answer
  int halted = 0;       // on_halt()
  int seen_in = -1;     // tick of its last on_start() or on_running()
  std::string fault{};  // the first call against the contract; empty: none
};

class RandomLeaves {
 public:
  explicit RandomLeaves(std::uint64_t seed);

  [[nodiscard]] const Registry& registry() const noexcept { return registry_; }
  // Of the actions, in the order in which they were made: that of the nodes.
  [[nodiscard]] const std::vector<std::unique_ptr<Watch>>& watches() const noexcept { return watches_; }
  [[nodiscard]] int conditions_seen_twice() const noexcept { return seen_twice_; }
  void begin_tick() noexcept { ++tick_; }
  [[nodiscard]] int tick() const noexcept { return tick_; }
  void see_condition(int& last) noexcept {
    seen_twice_ += last == tick_ ? 1 : 0;
    last = tick_;
  }
  [[nodiscard]] unsigned below(unsigned bound) { return static_cast<unsigned>(random_() % bound); }

 private:
  Registry registry_;
  std::mt19937_64 random_;
  std::vector<std::unique_ptr<Watch>> watches_;
  int tick_ = 0;
  int seen_twice_ = 0;
};

// A file with some sub-trees and about so many nodes of all types.
[[nodiscard]] std::string random_file(std::uint64_t seed, int nodes);

}  // namespace gaitway::behaviour::test

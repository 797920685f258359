// The process behind `determinism` and `two_instances`: one pass through the walk, every output noted. The
// starter compares two such processes.
#include <memory>
#include <random>
#include <vector>

#include "tools/check_plugin/call_guard.hpp"
#include "tools/check_plugin/check_run.hpp"
#include "tools/check_plugin/topic_rules.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr int kFirstFill = 0xc1, kSecondFill = 0x3f;  // of memory that nobody initialised
constexpr std::uint32_t kStatusPort = 1000;
constexpr std::uint64_t kNeighbourOffset = 40;  // ticks by which the other instance is ahead
constexpr std::uint64_t kNeighbourEnd = 240;    // tick at which it is destroyed

void note_outputs(Board& board, Specimen& specimen, std::uint64_t n, bool fine) noexcept {
  const auto tick = static_cast<std::uint32_t>(n);
  board.add({tick, kStatusPort, fine ? 1U : 0U});
  std::uint32_t index = 0;
  for (const Port& port : specimen.host().ports()) {
    if (port.is_output() && port.published) {
      board.add({tick, index, digest_of(port)});
    }
    ++index;
  }
}

// Memory of odd sizes that stays: addresses differ from those of a process that has none.
std::vector<std::unique_ptr<char[]>> another_heap(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int i = 0; i < 200; ++i) {
    blocks.push_back(std::make_unique<char[]>(16 + random() % 4096));
    if (random() % 3 == 0) {
      blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(random() % blocks.size()));
    }
  }
  return blocks;
}

}  // namespace

void check_outputs(CheckRun& run) {
  run.begin("one pass through the walk");
  const bool second = run.job().variant == "second";
  std::vector<std::unique_ptr<char[]>> heap;
  if (run.job().check == "determinism") {
    set_stack_fill(second ? kSecondFill : kFirstFill);
    set_allocation_fill(second ? kSecondFill : kFirstFill);
    heap = another_heap(second ? run.job().seed : 0);
  }
  const SpecimenLibrary library(run.job().plugin, run.board());
  const auto make = [&] {
    auto specimen = std::make_unique<Specimen>(library, run.job(), &run.record());
    specimen->create();
    specimen->activate();
    return specimen;
  };
  std::unique_ptr<Specimen> neighbour;
  if (second && run.job().check == "two_instances") {
    neighbour = make();
  }
  const std::unique_ptr<Specimen> specimen = make();
  const std::uint64_t ticks = std::uint64_t{run.record().ticks()} * (run.job().full ? 10 : 1);
  for (std::uint64_t n = 0; n < ticks; ++n) {
    if (neighbour != nullptr) {
      neighbour->step(run.record(), n + kNeighbourOffset);
      if (n == kNeighbourEnd) {
        neighbour->deactivate();
        neighbour.reset();
      }
    }
    const bool due = specimen->prepare_step(run.record(), n);
    if (due) {
      const bool fine = specimen->run_step();
      note_outputs(run.board(), *specimen, n, fine);
    }
  }
  specimen->abandon();
}

}  // namespace gaitway::plugin_check

// Check `state`: a new instance goes on exactly where the old one was, and refuses what it cannot read.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "tools/check_plugin/check_run.hpp"
#include "tools/check_plugin/topic_rules.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::uint64_t kSave = 200;  // tick; the robot walks
constexpr std::uint64_t kEnd = 360;
constexpr std::byte kUntouched{0xa5};

std::vector<OutputDigest> outputs_of(Specimen& specimen, std::uint64_t n, bool fine) {
  std::vector<OutputDigest> outputs{{0, 0, fine ? 1U : 0U}};
  for (const Port& port : specimen.host().ports()) {
    if (port.is_output() && port.published) {
      outputs.push_back({static_cast<std::uint32_t>(n), 0, digest_of(port)});
    }
  }
  return outputs;
}

void compare_from_here(CheckRun& run, Specimen& old_one, Specimen& new_one) {
  for (std::uint64_t n = kSave; n < kEnd; ++n) {
    const bool old_fine = old_one.step(run.record(), n);
    const bool new_fine = new_one.step(run.record(), n);
    if (outputs_of(old_one, n, old_fine) != outputs_of(new_one, n, new_fine)) {
      run.finding("the new instance's outputs differ from those of the instance that it took over from",
                  fmt::format("{} ticks after", n - kSave),
                  "hand on everything that a step remembers: visit each such member in save_state and "
                  "restore_state, in the same order");
      return;
    }
  }
}

// A state that does not fit; the instance must fail and say why.
void expect_refusal(CheckRun& run, const SpecimenLibrary& library, const core::PluginState& state,
                    const std::string& what) {
  if (!run.begin(what)) {
    return;
  }
  Specimen specimen(library, run.job(), &run.record());
  specimen.create();
  if (specimen.restore_state(state)) {
    run.finding(fmt::format("takes over a state with {}", what), "",
                "compare version and size before anything is read; StateReader does");
  } else if (specimen.error().empty()) {
    run.finding(fmt::format("refuses a state with {} without a text", what), "",
                "write the reason into the error text");
  }
  specimen.abandon();
}

void check_room(CheckRun& run, Specimen& specimen, std::uint32_t size) {
  if (size == 0 || !run.begin("no room for the state")) {
    return;
  }
  const auto state = std::make_unique<core::PluginState>();
  std::ranges::fill(state->bytes, kUntouched);
  const bool saved = specimen.save_state(*state, size - 1);
  const bool overrun = std::any_of(state->bytes.begin() + size - 1, state->bytes.end(),
                                   [](std::byte byte) { return byte != kUntouched; });
  if (saved || overrun) {
    run.finding(overrun ? "save_state writes more than it has room for" : "save_state succeeds without room",
                "", "compare with the capacity before writing; StateWriter does");
  }
}

}  // namespace

void check_state(CheckRun& run) {
  const SpecimenLibrary library(run.job().plugin, run.board());
  run.begin("save and restore");
  Specimen old_one(library, run.job(), &run.record());
  old_one.create();
  old_one.activate();
  for (std::uint64_t n = 0; n < kSave; ++n) {
    old_one.step(run.record(), n);
  }
  const auto state = std::make_unique<core::PluginState>();
  if (!old_one.save_state(*state, core::PluginState::kCapacity)) {
    run.finding(fmt::format("save_state fails: {}", old_one.error()), "", "hand on less, or state_version 0");
    return;
  }
  if (state->version == 0) {
    run.remark("hands no state on");
    old_one.abandon();
    return;
  }
  run.figure("bytes", state->size);
  Specimen new_one(library, run.job(), &run.record());
  new_one.create();
  if (!new_one.activate() || !new_one.restore_state(*state)) {
    run.finding(fmt::format("its own state is refused: {}", new_one.error()), "",
                "let save_state and restore_state visit the same members");
  } else {
    compare_from_here(run, old_one, new_one);
  }
  check_room(run, old_one, state->size);
  new_one.abandon();
  old_one.abandon();
  ++state->version;
  expect_refusal(run, library, *state, "another version");
  --state->version;
  state->size += 8;
  expect_refusal(run, library, *state, "8 bytes too many");
  state->size -= 9;
  expect_refusal(run, library, *state, "one byte too few");
  run.remark(fmt::format("{} bytes handed on", state->size + 1));
}

}  // namespace gaitway::plugin_check

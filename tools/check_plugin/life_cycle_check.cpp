// Check `life_cycle`: the right order works, and every wrong one is tolerated or refused, never a crash.
#include <fmt/format.h>

#include <functional>

#include "tools/check_plugin/check_run.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::uint64_t kStepsPerLife = 40;
constexpr int kRefusalRounds = 12;
constexpr double kLeakPerLife_bytes = 8.0;

struct Sequence {
  const char* name;
  std::function<void(Specimen&, const std::function<void()>& steps)> calls;
};

const std::vector<Sequence>& sequences() {
  static const std::vector<Sequence> all{
      {"destroy without activate", [](Specimen&, const auto&) {}},
      {"activate twice",
       [](Specimen& s, const auto& steps) {
         s.activate();
         s.activate();
         steps();
         s.deactivate();
       }},
      {"deactivate before activate",
       [](Specimen& s, const auto& steps) {
         s.deactivate();
         s.activate();
         steps();
         s.deactivate();
       }},
      {"deactivate twice",
       [](Specimen& s, const auto& steps) {
         s.activate();
         steps();
         s.deactivate();
         s.deactivate();
       }},
      {"deactivate, activate, step",
       [](Specimen& s, const auto& steps) {
         s.activate();
         steps();
         s.deactivate();
         s.activate();
         steps();
         s.deactivate();
       }},
      {"step before activate",
       [](Specimen& s, const auto& steps) {
         steps();
         s.activate();
         s.deactivate();
       }},
      {"step after deactivate",
       [](Specimen& s, const auto& steps) {
         s.activate();
         steps();
         s.deactivate();
         steps();
       }},
      {"destroy while active",
       [](Specimen& s, const auto& steps) {
         s.activate();
         steps();
       }},
  };
  return all;
}

// The order that every main controller uses: nothing else can be tried where it fails.
void try_right_order(CheckRun& run, const SpecimenLibrary& library) {
  Specimen specimen(library, run.job(), &run.record());
  if (!specimen.create()) {
    run.not_usable(fmt::format("create fails: {}", specimen.error()));
    return;
  }
  if (!specimen.activate()) {
    run.not_usable(fmt::format("activate fails: {}", specimen.error()));
    specimen.abandon();
    return;
  }
  for (std::uint64_t n = 0; n < kStepsPerLife; ++n) {
    specimen.step(run.record(), n);
  }
  if (!specimen.deactivate()) {
    run.finding(fmt::format("deactivate fails: {}", specimen.error()), "",
                "let it succeed: nobody can help it");
  }
}

// Declaration number `call` is refused: create must fail, say why and keep nothing.
void try_refusal(CheckRun& run, const SpecimenLibrary& library, std::uint32_t call) {
  ProcessResources first;
  for (int round = 0; round < kRefusalRounds; ++round) {
    Specimen specimen(library, run.job(), &run.record());
    specimen.host().refuse_call(call);
    if (specimen.create()) {
      run.finding("create succeeds although the host refused one of its declarations", "",
                  "let SetupError pass, or answer GAITWAY_FAILED");
      specimen.abandon();
      return;
    }
    if (specimen.error().empty()) {
      run.finding("create fails without a text", "", "write the reason into the error text");
      return;
    }
    if (round == kRefusalRounds / 4) {
      first = process_resources();
    }
  }
  const ProcessResources last = process_resources();
  const double per_round = static_cast<double>(last.heap_bytes - first.heap_bytes) / (0.75 * kRefusalRounds);
  if (per_round >= kLeakPerLife_bytes || last.descriptors > first.descriptors) {
    run.finding(fmt::format("a create that fails keeps {:.0f} bytes and {} descriptors each time", per_round,
                            last.descriptors - first.descriptors),
                "", "free on every way out of create what was made before");
  }
}

}  // namespace

void check_life_cycle(CheckRun& run) {
  const SpecimenLibrary library(run.job().plugin, run.board());
  if (run.begin("right order")) {
    try_right_order(run, library);
  }
  for (const Sequence& sequence : sequences()) {
    if (run.begin(sequence.name)) {
      Specimen specimen(library, run.job(), &run.record());
      specimen.create();
      std::uint64_t n = 0;
      sequence.calls(specimen, [&] {
        for (const std::uint64_t end = n + kStepsPerLife; n < end; ++n) {
          specimen.step(run.record(), n);
        }
      });
    }
  }
  Specimen counted(library, run.job(), &run.record());
  counted.create();
  counted.activate();
  counted.deactivate();
  counted.destroy();
  const std::uint32_t calls = counted.host().calls();
  for (std::uint32_t call = 0; call < calls; ++call) {
    if (run.begin(fmt::format("declaration {} of {} refused", call + 1, calls))) {
      try_refusal(run, library, call);
    }
  }
  run.remark(fmt::format("{} orders, {} refusals", sequences().size() + 1, calls));
}

}  // namespace gaitway::plugin_check

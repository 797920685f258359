// What the trials with plug-ins that fail while the robot walks have in common.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string_view>

#include "gaitway/instance/event_log.hpp"

namespace gaitway::scenarios {

constexpr double kWatchedAfterFault_s = 10.0;

// `stated` in every run, fifty in the long one; one under a sanitizer.
constexpr int fault_trials(int stated) {
  return GAITWAY_SEED_PERCENT >= 500 ? 50 : (stated * GAITWAY_SEED_PERCENT + 99) / 100;
}

// What a saboteur does to its process.
struct Crash {
  const char* name;
  const char* cause;  // part of the event's text
};
constexpr std::array<Crash, 8> kCrashes{{{"segfault", "was ended by SIGSEGV in its step"},
                                         {"abort", "was ended by SIGABRT in its step"},
                                         {"exit", "exited with code 7 in its step"},
                                         {"loop", "did not answer within"},
                                         {"memory", "used up its memory"},
                                         {"descriptors", "used up its file descriptors"},
                                         {"fork", "called clone, which a plug-in"},
                                         {"garbage", "wrote over the memory"}}};

struct FaultInstant {
  double begin_s = 0.0;     // somewhere in two seconds of the walk
  double duration_s = 0.0;  // 10 ms to two seconds
};
inline FaultInstant random_fault_instant(unsigned seed) {
  std::mt19937 random(seed);
  const double begin_s = 4.0 + 0.001 * static_cast<double>(random() % 2000);
  return {begin_s, 0.01 + 0.001 * static_cast<double>(random() % 2000)};
}

// Nullptr: there is none.
inline const core::Event* first_event(const core::EventLog& events, std::string_view source,
                                      core::EventKind kind) {
  for (std::uint64_t i = events.first(); i < events.total(); ++i) {
    if (events[i].kind == kind && events[i].source() == source) {
      return &events[i];
    }
  }
  return nullptr;
}

}  // namespace gaitway::scenarios

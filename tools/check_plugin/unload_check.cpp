// Check `unload`: a plug-in that was loaded and used a hundred times has left nothing behind.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "tools/check_plugin/call_guard.hpp"
#include "tools/check_plugin/check_run.hpp"
#include "tools/check_plugin/elf_symbols.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr int kRounds = 100;
constexpr int kFullRounds = 1000;
constexpr int kWarmUp = 20;
constexpr std::uint64_t kTicksPerLoad = 16;              // two batches
constexpr double kLeakPerLoad_bytes = 16.0;              // less is the allocator's own housekeeping
constexpr std::int64_t kResidentGrowth_bytes = 8 << 20;  // what no fragmentation explains
constexpr auto kThreadGrace = std::chrono::milliseconds(300);

int entries(const char* folder) {
  return static_cast<int>(
      std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

bool is_mapped(const std::filesystem::path& file) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.ends_with(file.string())) {
      return true;
    }
  }
  return false;
}

// Threads that were told to end may need a moment.
int threads_after_grace(int expected) {
  const auto until = std::chrono::steady_clock::now() + kThreadGrace;
  int threads = process_resources().threads;
  while (threads > expected && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    threads = process_resources().threads;
  }
  return threads;
}

void use_once(CheckRun& run, const SpecimenLibrary& library) {
  Specimen specimen(library, run.job(), &run.record());
  if (!specimen.create()) {
    return;
  }
  specimen.activate();
  for (std::uint64_t n = 0; n < kTicksPerLoad; ++n) {
    specimen.step(run.record(), n);
  }
  specimen.deactivate();
}

std::string why_it_stays(const std::filesystem::path& file) {
  const ElfSymbols symbols = read_elf_symbols(file);
  if (symbols.no_delete) {
    return "it was linked with -z nodelete: link it without";
  }
  if (!symbols.unique.empty()) {
    return fmt::format("'{}' is a unique symbol, which pins the library: compile with -fno-gnu-unique",
                       symbols.unique.front());
  }
  return symbols.thread_local_data ? "it has thread_local objects with destructors, which pin it until the "
                                     "thread ends: keep such state in the plug-in's object"
                                   : "something keeps it open: look for dlopen of itself and thread_local "
                                     "objects";
}

// One round; false: the next one makes no sense.
bool round_is_clean(CheckRun& run, const ProcessResources& before) {
  SpecimenLibrary library(run.job().plugin, run.board());
  use_once(run, library);
  const int threads = threads_after_grace(before.threads);
  if (threads > before.threads) {
    run.finding(fmt::format("{} thread{} still there after destroy", threads - before.threads,
                            threads - before.threads == 1 ? " is" : "s are"),
                "after destroy",
                "end and join threads in deactivate or the destructor; a plug-in needs none");
    return false;  // its code must stay: the thread runs in it
  }
  library.unload();
  if (is_mapped(run.job().plugin)) {
    run.finding("the library is still in memory after it was closed", "after unload",
                why_it_stays(run.job().plugin));
    return false;
  }
  return true;
}

void compare(CheckRun& run, const ProcessResources& first, const ProcessResources& last, int rounds) {
  const double heap = static_cast<double>(last.heap_bytes - first.heap_bytes) / rounds;
  const std::int64_t resident = last.resident_bytes - first.resident_bytes;
  run.figure("heap_growth_bytes_per_round", heap);
  run.figure("resident_growth_bytes", resident);
  run.figure("descriptor_growth", last.descriptors - first.descriptors);
  if (heap >= kLeakPerLoad_bytes) {
    run.finding(fmt::format("leaks {:.0f} bytes every time it is created and destroyed", heap), "",
                "free in the destructor what the constructor or activate allocates; "
                "build with -fsanitize=address to see where");
  } else if (resident >= kResidentGrowth_bytes) {
    run.finding(fmt::format("the process grew by {:.1f} MiB in {} rounds",
                            static_cast<double>(resident) / (1 << 20), rounds),
                "", "unmap in the destructor what the constructor maps");
  }
  if (last.descriptors > first.descriptors) {
    run.finding(
        fmt::format("leaves {} descriptors open in {} rounds", last.descriptors - first.descriptors, rounds),
        "", "close files and sockets in the destructor");
  }
}

}  // namespace

ProcessResources process_resources() {
  ProcessResources now;
  now.descriptors = entries("/proc/self/fd");
  now.threads = entries("/proc/self/task");
  std::int64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  now.resident_bytes = pages * sysconf(_SC_PAGESIZE);
  now.heap_bytes = live_memory_bytes();
  return now;
}

void check_unload(CheckRun& run) {
  if (!run.begin("load, use, unload")) {
    return;
  }
  int rounds = run.job().full ? kFullRounds : kRounds;
  const ProcessResources start = process_resources();
  ProcessResources first = start;
  for (int round = 0; round < kWarmUp + rounds; ++round) {
    if (!round_is_clean(run, start)) {
      return;
    }
    if (round == kWarmUp - 1) {
      first = process_resources();
    }
    if (round >= 2 * kWarmUp && run.time_is_up()) {
      rounds = round + 1 - kWarmUp;
    }
  }
  compare(run, first, process_resources(), rounds);
  run.remark(fmt::format("{} rounds", rounds));
}

}  // namespace gaitway::plugin_check

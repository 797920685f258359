// Check `real_time`: a step allocates nothing, locks nothing, throws nothing, calls no system and touches no
// new page.
#include <cxxabi.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <seccomp.h>
#include <sys/resource.h>

#include <cstdlib>
#include <memory>
#include <set>

#include "tools/check_plugin/call_guard.hpp"
#include "tools/check_plugin/check_run.hpp"
#include "tools/check_plugin/elf_symbols.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::uint64_t kWatchedSteps = 2000;
constexpr std::uint64_t kFullWatchedSteps = 100'000;
constexpr std::uint64_t kWarmUpTicks = 160;
constexpr int kMostCalls = 6;
constexpr std::int64_t kToleratedFaults = 8;  // the kernel's own: reclaimed or moved pages

std::string call_text(const CaughtCall& call) {
  if (call.function != nullptr) {
    return std::string_view(call.function) == "throw" ? "throws an exception"
                                                      : fmt::format("calls {}()", call.function);
  }
  const std::unique_ptr<char, void (*)(void*)> name(
      seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, call.system_call), &std::free);
  return name != nullptr ? fmt::format("makes the system call {}", name.get())
                         : fmt::format("makes the system call number {}", call.system_call);
}

const char* remedy_of(const CaughtCall& call) {
  if (call.function == nullptr) {
    return "leave files, clocks, sockets and waiting to set-up or to another process";
  }
  const std::string_view name = call.function;
  if (name == "throw") {
    return "a throw in a step costs its output and allocates: keep it for what cannot happen on good inputs";
  }
  return name.starts_with("pthread") || name.starts_with("sem")
             ? "a plug-in is stepped by one thread: it needs no lock"
             : "allocate in the constructor or in activate; give vectors and matrices their final size there";
}

// The innermost frame that lies in the plug-in.
std::string frame_in_plugin(const CaughtCall& call, const std::string& plugin, const ElfSymbols& symbols) {
  for (int i = 0; i < call.frame_count; ++i) {
    Dl_info info{};
    void* const frame = call.frames[static_cast<std::size_t>(i)];
    if (dladdr(frame, &info) == 0 || info.dli_fname == nullptr || plugin != info.dli_fname) {
      continue;
    }
    const auto offset =
        static_cast<std::uint64_t>(static_cast<char*>(frame) - static_cast<char*>(info.dli_fbase));
    const std::string name = symbols.function_at(offset - 1);  // the call, not what follows it
    return name.empty() ? fmt::format("+{:#x}", offset) : fmt::format("{} (+{:#x})", name, offset);
  }
  return "a library that the plug-in calls";
}

std::int64_t page_faults() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_minflt + usage.ru_majflt;
}

class Watch {
 public:
  explicit Watch(CheckRun& run) : run_(run), symbols_(read_elf_symbols(run.job().plugin)) {}

  void step(Specimen& specimen) {
    const std::int64_t before = page_faults();
    {
      const CallGuard guard;
      specimen.run_step();
    }
    faults_ += page_faults() - before;
    for (int i = 0; i < caught_call_count(); ++i) {
      report(caught_call(i), specimen);
    }
    clear_caught_calls();
  }
  [[nodiscard]] std::int64_t faults() const noexcept { return faults_; }

 private:
  void report(const CaughtCall& call, const Specimen& specimen) {
    const std::string what = fmt::format("a step {}", call_text(call));
    const std::string where = frame_in_plugin(call, run_.job().plugin.string(), symbols_);
    if (reported_.size() < kMostCalls && reported_.emplace(what, where).second) {
      run_.finding(what, fmt::format("tick {}, {}", specimen.board().page().tick.load(), where),
                   remedy_of(call));
    }
  }

  CheckRun& run_;
  ElfSymbols symbols_;
  std::set<std::pair<std::string, std::string>> reported_;
  std::int64_t faults_ = 0;
};

}  // namespace

void check_real_time(CheckRun& run) {
  if (!functions_are_watched()) {
    run.skip("a build with a sanitizer has its own allocator: use another build");
    return;
  }
  if (!run.begin("steps")) {
    return;
  }
  prepare_call_guard();
  const SpecimenLibrary library(run.job().plugin, run.board());
  Specimen specimen(library, run.job(), &run.record());
  specimen.create();
  specimen.activate();
  Watch watch(run);
  std::uint64_t n = 0;
  for (; n < kWarmUpTicks; ++n) {
    specimen.step(run.record(), n);
  }
  const std::uint64_t wanted = run.job().full ? kFullWatchedSteps : kWatchedSteps;
  for (std::uint64_t steps = 0; steps < wanted && run.findings() < kMostCalls && !run.time_is_up(); ++n) {
    if (specimen.prepare_step(run.record(), n)) {
      watch.step(specimen);
      ++steps;
    }
  }
  run.figure("steps", wanted);
  run.figure("page_faults", watch.faults());
  run.figure("system_calls_watched", system_calls_are_watched());
  if (watch.faults() > kToleratedFaults && run.findings() == 0) {
    run.finding(fmt::format("{} steps touched {} new pages", wanted, watch.faults()), "",
                "write once in activate to all memory that a step uses");
  }
  run.remark(
      fmt::format("{} steps{}", wanted,
                  system_calls_are_watched() ? "" : "; system calls cannot be trapped on this machine"));
  specimen.abandon();
}

}  // namespace gaitway::plugin_check

// The process of one check: signal handlers that say where a crash was, the inputs, and the check itself.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <malloc.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <string>

#include "tools/check_plugin/call_guard.hpp"
#include "tools/check_plugin/check_run.hpp"
#include "tools/check_plugin/elf_symbols.hpp"
#include "tools/check_plugin/plugin_check.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::size_t kAlternateStack = std::size_t{256} * 1024;
constexpr rlim_t kMostMemory = rlim_t{12} << 30;  // a huge parameter may not take the machine's

BoardPage* crash_page = nullptr;
ElfSymbols* crash_symbols = nullptr;
std::string* crash_plugin = nullptr;

// The innermost frame that lies in the plug-in, as text. Only reads what was made before.
void describe_frame(char* to, std::size_t room) noexcept {
  std::array<void*, 48> frames{};
  const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
  for (int i = 0; i < count; ++i) {
    Dl_info info{};
    if (dladdr(frames[static_cast<std::size_t>(i)], &info) == 0 || info.dli_fname == nullptr ||
        *crash_plugin != info.dli_fname) {
      continue;
    }
    const auto offset = static_cast<std::uint64_t>(static_cast<char*>(frames[static_cast<std::size_t>(i)]) -
                                                   static_cast<char*>(info.dli_fbase));
    const char* name = "";
    for (const ElfFunction& function : crash_symbols->functions) {
      name = offset >= function.begin && offset < function.end ? function.name.c_str() : name;
    }
    std::snprintf(to, room, ", in the plug-in at +0x%llx %s", static_cast<unsigned long long>(offset), name);
    return;
  }
}

void on_crash(int signal, siginfo_t* info, void*) {
  char* const text = crash_page->crash.data();
  const std::size_t room = crash_page->crash.size();
  const char* const name = sigabbrev_np(signal);
  int length = std::snprintf(text, room, "crashes: SIG%s", name == nullptr ? "?" : name);
  if (signal == SIGSEGV || signal == SIGBUS) {
    length += std::snprintf(text + length, room - static_cast<std::size_t>(length), " at address %p",
                            info->si_addr);
  }
  describe_frame(text + length, room - static_cast<std::size_t>(length));
  _exit(99);
}

void catch_crashes(Board& board, const std::filesystem::path& plugin) {
  crash_page = &board.page();
  crash_plugin = new std::string(plugin.string());
  crash_symbols = new ElfSymbols;
  try {
    *crash_symbols = read_elf_symbols(plugin);
  } catch (const std::exception&) {
    crash_symbols->functions.clear();  // the check `abi` says what is wrong with the file
  }
  std::array<void*, 4> frames{};
  backtrace(frames.data(), static_cast<int>(frames.size()));  // loads the unwinder now
  static std::array<std::byte, kAlternateStack> stack;
  const stack_t alternate{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
  sigaltstack(&alternate, nullptr);
  struct sigaction action {};
  action.sa_sigaction = &on_crash;
  action.sa_flags = static_cast<int>(SA_SIGINFO | SA_ONSTACK | SA_RESETHAND);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    sigaction(signal, &action, nullptr);
  }
}

// What the plug-in prints is none of the report's.
void silence() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

void limit_memory() {
#if !GAITWAY_PLUGIN_CHECK_SANITIZED
  const rlimit limit{kMostMemory, kMostMemory};
  setrlimit(RLIMIT_AS, &limit);
  mallopt(M_ARENA_MAX, 1);  // or every thread that a plug-in leaves behind takes a great part of it
#endif
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

}  // namespace

bool CheckRun::begin(std::string_view name) {
  const std::uint32_t index = next_case_++;
  if (index < job_.first_case) {
    return false;
  }
  if (time_is_up()) {
    board_.add_line({{"untried", name}});
    return false;
  }
  case_name_ = name;
  board_.begin_case(index, name);
  return true;
}

void CheckRun::finding(std::string_view what, std::string_view where, std::string_view remedy) {
  ++findings_;
  const std::string place = case_name_.empty()
                                ? std::string(where)
                                : case_name_ + (where.empty() ? std::string() : ": " + std::string(where));
  board_.add_line({{"finding", {{"what", what}, {"where", place}, {"remedy", remedy}}}});
}

void CheckRun::figure(std::string_view name, const nlohmann::ordered_json& value) {
  board_.add_line({{"figure", {{"name", name}, {"value", value}}}});
}
void CheckRun::remark(std::string_view text) {
  board_.add_line({{"remark", text}});
}
void CheckRun::skip(std::string_view why) {
  board_.add_line({{"skipped", why}});
}
void CheckRun::not_usable(std::string_view why) {
  board_.add_line({{"not_usable", why}});
}

Job with_parameter(const Job& job, const std::string& name, const std::string& text) {
  Job changed = job;
  std::erase_if(changed.parameters,
                [&name](const core::ParameterEntry& entry) { return entry.name == name; });
  changed.parameters.push_back({name, text, 1});
  return changed;
}

int run_worker(const char* job_text) {
  const std::map<std::string, void (*)(CheckRun&), std::less<>> checks{{"abi", &check_abi},
                                                                       {"descriptor", &check_descriptor},
                                                                       {"life_cycle", &check_life_cycle},
                                                                       {"unload", &check_unload},
                                                                       {"two_instances", &check_outputs},
                                                                       {"determinism", &check_outputs},
                                                                       {"real_time", &check_real_time},
                                                                       {"budget", &check_budget},
                                                                       {"values", &check_values},
                                                                       {"parameters", &check_parameters},
                                                                       {"state", &check_state}};
  start_counting_memory();
  Board board(kBoardDescriptor);
  const Job job = read_job(job_text);
  silence();
  limit_memory();
  catch_crashes(board, job.plugin);
  try {
    const NominalRecord record = NominalRecord::load(kRecordDescriptor);
    CheckRun run(job, record, board);
    checks.at(job.check)(run);
  } catch (const std::exception& error) {
    std::snprintf(board.page().crash.data(), board.page().crash.size(), "%s", error.what());
    _exit(98);
  }
  _exit(0);  // what the plug-in left behind (threads, handlers) may not run any more
}

}  // namespace gaitway::plugin_check

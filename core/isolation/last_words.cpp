// What a child can still tell: signal handlers that only store numbers, on a stack of their own.
#include "child_program.hpp"

#include <fcntl.h>
#include <link.h>
#include <signal.h>
#include <sys/resource.h>
#include <ucontext.h>
#include <unistd.h>

#include <array>
#include <cstdio>

namespace gaitway::core {
namespace {

struct LibraryRange {
  std::uintptr_t known = 0;  // an address inside it
  std::uintptr_t base = 0, end = 0;
};
LibraryRange library;
LastWords* last_words = nullptr;
int statm = -1;  // opened while there are descriptors

std::uintptr_t program_counter(const void* context) noexcept {
  const auto* const state = static_cast<const ucontext_t*>(context);
#if defined(__x86_64__)
  return static_cast<std::uintptr_t>(state->uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
  return static_cast<std::uintptr_t>(state->uc_mcontext.pc);
#else
  static_cast<void>(state);
  return 0;
#endif
}

// SA_RESETHAND: the instruction is tried again, and then the kernel ends the process as it would have.
void note_death(int signal, siginfo_t* info, void* context) {
  const std::uintptr_t at = program_counter(context);
  last_words->address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  last_words->in_library = at >= library.base && at < library.end ? 1 : 0;
  last_words->offset = at - library.base;
  last_words->signal = static_cast<std::uint32_t>(signal);
}

int find_library(dl_phdr_info* info, std::size_t, void* result) {
  auto& range = *static_cast<LibraryRange*>(result);
  std::uintptr_t end = 0;
  bool inside = false;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const auto& part = info->dlpi_phdr[i];
    if (part.p_type == PT_LOAD) {
      const std::uintptr_t from = info->dlpi_addr + part.p_vaddr;
      end = from + part.p_memsz;
      inside = inside || (range.known >= from && range.known < end);
    }
  }
  if (inside) {
    range.base = info->dlpi_addr;
    range.end = end;
  }
  return inside ? 1 : 0;
}

}  // namespace

void describe_deaths_in(const gaitway_plugin& entry) noexcept {
  library.known = reinterpret_cast<std::uintptr_t>(&entry);
  dl_iterate_phdr(&find_library, &library);
  statm = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
}

void leave_last_words_in(LastWords& words) noexcept {
  static std::array<std::byte, std::size_t{64} * 1024> stack;
  last_words = &words;
  stack_t place{};
  place.ss_sp = stack.data();
  place.ss_size = stack.size();
  sigaltstack(&place, nullptr);
  struct sigaction action {};
  action.sa_sigaction = &note_death;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
    sigaction(signal, &action, nullptr);
  }
}

Resource exhausted_resource() noexcept {
  const int more = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0);
  if (more < 0) {
    return Resource::descriptors;
  }
  close(more);
  rlimit limit{};
  std::array<char, 64> text{};
  unsigned long long pages = 0;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
      pread(statm, text.data(), text.size() - 1, 0) > 0 && std::sscanf(text.data(), "%llu", &pages) == 1) {
    const auto page = static_cast<unsigned long long>(sysconf(_SC_PAGESIZE));
    return pages * page > limit.rlim_cur / 10 * 9 ? Resource::memory : Resource::none;
  }
  return Resource::none;
}

}  // namespace gaitway::core

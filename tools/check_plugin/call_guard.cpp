// Syscall User Dispatch: with its selector on "block", every system call of the thread becomes a SIGSYS,
// whose handler notes it, switches the selector back and makes the call itself.
#include "tools/check_plugin/call_guard.hpp"

#include <execinfo.h>
#include <malloc.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#ifndef PR_SET_SYSCALL_USER_DISPATCH
#define PR_SET_SYSCALL_USER_DISPATCH 59
#define PR_SYS_DISPATCH_OFF 0
#define PR_SYS_DISPATCH_ON 1
#endif

namespace gaitway::plugin_check {
namespace {

constexpr int kKept = 16;
constexpr char kAllow = 0, kBlock = 1;

// One thread at a time is guarded; the others see `guarded` false.
thread_local bool guarded [[gnu::tls_model("initial-exec")]] = false;
thread_local std::uint64_t exceptions [[gnu::tls_model("initial-exec")]] = 0;
volatile char selector = kAllow;
bool dispatch_is_on = false;
std::atomic<bool> memory_is_counted{false};
std::atomic<std::int64_t> live_bytes{0};
std::atomic<int> allocation_fill{0};
std::array<CaughtCall, kKept> caught{};
int caught_count = 0;

void keep(const char* function, int system_call) noexcept {
  if (caught_count < kKept) {
    CaughtCall& call = caught[static_cast<std::size_t>(caught_count++)];
    call.function = function;
    call.system_call = system_call;
    call.frame_count = backtrace(call.frames.data(), CaughtCall::kFrames);
  }
}

#if defined(__x86_64__)
// What the thread wanted, now that it is allowed; the rest of this step goes on unwatched.
void on_system_call(int, siginfo_t* info, void* context) {
  selector = kAllow;
  const bool was_guarded = guarded;
  guarded = false;
  if (was_guarded) {
    keep(nullptr, info->si_syscall);
  }
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  errno = 0;
  const long answer = syscall(info->si_syscall, registers[REG_RDI], registers[REG_RSI], registers[REG_RDX],
                              registers[REG_R10], registers[REG_R8], registers[REG_R9]);
  registers[REG_RAX] = answer == -1 && errno != 0 ? -errno : answer;
  guarded = was_guarded;
}

[[maybe_unused]] bool switch_dispatch_on() noexcept {  // not beside a sanitizer
  struct sigaction action {};
  action.sa_sigaction = &on_system_call;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, nullptr);
  return prctl(PR_SET_SYSCALL_USER_DISPATCH, PR_SYS_DISPATCH_ON, 0L, 0L, &selector) == 0;
}
#else
[[maybe_unused]] bool switch_dispatch_on() noexcept {  // not beside a sanitizer
  return false;
}
#endif

}  // namespace

void prepare_call_guard() noexcept {
  std::array<void*, 4> frames{};
  backtrace(frames.data(), static_cast<int>(frames.size()));  // loads the unwinder
#if !GAITWAY_PLUGIN_CHECK_SANITIZED
  dispatch_is_on = switch_dispatch_on();
#endif
}

bool functions_are_watched() noexcept {
  return !GAITWAY_PLUGIN_CHECK_SANITIZED;
}
bool system_calls_are_watched() noexcept {
  return dispatch_is_on;
}
std::uint64_t exceptions_thrown() noexcept {
  return exceptions;
}

CallGuard::CallGuard() noexcept {
  guarded = true;
  selector = dispatch_is_on ? kBlock : kAllow;
}
CallGuard::~CallGuard() {
  selector = kAllow;
  guarded = false;
}

int caught_call_count() noexcept {
  return caught_count;
}
const CaughtCall& caught_call(int index) noexcept {
  return caught[static_cast<std::size_t>(index)];
}
void clear_caught_calls() noexcept {
  caught_count = 0;
}

void start_counting_memory() noexcept {
  memory_is_counted = true;
}
std::int64_t live_memory_bytes() noexcept {
  return live_bytes;
}
void set_allocation_fill(int fill) noexcept {
  allocation_fill = fill;
}
void fill_allocated(void* memory, std::size_t bytes) noexcept {
  const int fill = allocation_fill.load(std::memory_order_relaxed);
  if (fill != 0 && memory != nullptr) {
    std::memset(memory, fill, bytes);
  }
}
void count_allocated(void* memory) noexcept {
  if (memory_is_counted.load(std::memory_order_relaxed) && memory != nullptr) {
    live_bytes += static_cast<std::int64_t>(malloc_usable_size(memory));
  }
}
void count_freed(void* memory) noexcept {
  if (memory_is_counted.load(std::memory_order_relaxed) && memory != nullptr) {
    live_bytes -= static_cast<std::int64_t>(malloc_usable_size(memory));
  }
}

void note_call(const char* function) noexcept {
  if (guarded) {
    const char selected = selector;
    selector = kAllow;
    guarded = false;
    keep(function, -1);
    guarded = true;
    selector = selected;
  }
}

void note_exception() noexcept {
  ++exceptions;
  note_call("throw");
}

}  // namespace gaitway::plugin_check

// Resource limits, and a seccomp filter made with libseccomp. The filter names what is forbidden: what a
// plug-in's libraries need differs from one machine to the next, what no plug-in needs does not.
#include "bounds.hpp"

#include <fcntl.h>
#include <linux/sockios.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <string_view>

namespace gaitway::core {
namespace {

constexpr std::string_view kSocketCalls = "socket socketpair connect bind listen accept accept4";

// A filter of system calls: everything is allowed but what is refused, which is a trap for refuse() below;
// calls of another architecture end the process.
class SeccompFilter {
 public:
  SeccompFilter() noexcept : context_(seccomp_init(SCMP_ACT_ALLOW)) {
    sound_ = context_ != nullptr &&
             seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS) == 0;
  }
  ~SeccompFilter() { seccomp_release(context_); }
  SeccompFilter(const SeccompFilter&) = delete;
  SeccompFilter& operator=(const SeccompFilter&) = delete;

  // What arguments a refusal is about. The kernel reads numbers of 32 bits from the lower word alone, which
  // equality looks at; what is to be `value` must be so in both words.
  static constexpr scmp_arg_cmp is_not(unsigned argument, std::uint64_t value) noexcept {
    return {argument, SCMP_CMP_NE, value, 0};
  }
  static constexpr scmp_arg_cmp has(unsigned argument, std::uint32_t mask, std::uint32_t value) noexcept {
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
  }
  static constexpr scmp_arg_cmp is(unsigned argument, std::uint32_t value) noexcept {
    return has(argument, ~0U, value);
  }

  // Where all of `when` holds. More than once for a call: where any of them does.
  void refuse(int call, std::initializer_list<scmp_arg_cmp> when = {}) noexcept {
    add(call, SCMP_ACT_TRAP, when);
  }
  // As a call that this kernel does not have.
  void hide(int call) noexcept { add(call, SCMP_ACT_ERRNO(ENOSYS), {}); }
  // By their names, with spaces between them.
  void refuse_all(std::string_view calls) noexcept {
    for (std::size_t end = 0; !calls.empty(); calls.remove_prefix(std::min(end + 1, calls.size()))) {
      end = std::min(calls.find(' '), calls.size());
      const int call = seccomp_syscall_resolve_name(std::string(calls.substr(0, end)).c_str());
      sound_ = sound_ && call != __NR_SCMP_ERROR;
      refuse(call);
    }
  }

  // For the calling thread and those that it starts from now on.
  [[nodiscard]] bool install() noexcept { return sound_ && seccomp_load(context_) == 0; }

 private:
  void add(int call, std::uint32_t action, std::initializer_list<scmp_arg_cmp> when) noexcept {
    const int result =
        seccomp_rule_add_array(context_, action, call, static_cast<unsigned>(when.size()), when.begin());
    sound_ = sound_ && (result == 0 || result == -EDOM);  // which says that this machine has no such call
  }

  scmp_filter_ctx context_;
  bool sound_ = false;
};

constexpr std::string_view kForbidden =
    "fork vfork execve execveat ptrace process_vm_readv process_vm_writev pidfd_open pidfd_getfd "
    "pidfd_send_signal rt_sigqueueinfo rt_tgsigqueueinfo tkill setrlimit setpgid setsid setpriority "
    "sched_setscheduler sched_setparam sched_setattr unshare setns mount bpf perf_event_open io_uring_setup";

volatile sig_atomic_t refused_call = -1;

// What is forbidden but for some uses has conditions. `local_sockets`: Unix sockets may be made and used; no
// others.
bool install_filter(bool local_sockets) noexcept {
  SeccompFilter filter;
  filter.refuse_all(kForbidden);
  if (local_sockets) {
    for (const int call : {SCMP_SYS(socket), SCMP_SYS(socketpair)}) {
      filter.refuse(call, {SeccompFilter::is_not(0, AF_UNIX)});
    }
  } else {
    filter.refuse_all(kSocketCalls);
  }
  // Its flags lie in memory, where no filter sees them; without it libraries use clone.
  filter.hide(SCMP_SYS(clone3));
  filter.refuse(SCMP_SYS(clone), {SeccompFilter::has(0, CLONE_THREAD, 0)});
  const auto self = static_cast<std::uint64_t>(getpid());
  filter.refuse(SCMP_SYS(kill), {SeccompFilter::is_not(0, self)});
  filter.refuse(SCMP_SYS(tgkill), {SeccompFilter::is_not(0, self)});
  filter.refuse(SCMP_SYS(prlimit64), {SeccompFilter::is_not(2, 0)});  // a new limit: else it only asks
  // A descriptor's owner is signalled by the kernel, and a terminal takes what is typed into it for its
  // user's.
  filter.refuse(SCMP_SYS(fcntl), {SeccompFilter::is(1, F_SETOWN_EX)});
  filter.refuse(SCMP_SYS(fcntl), {SeccompFilter::is(1, F_SETOWN), SeccompFilter::is_not(2, self)});
  for (const int request : {FIOSETOWN, SIOCSPGRP, TIOCSTI, TIOCLINUX}) {
    filter.refuse(SCMP_SYS(ioctl), {SeccompFilter::is(1, static_cast<std::uint32_t>(request))});
  }
  return filter.install();
}

// Answers EPERM in the kernel's stead.
void refuse(int, siginfo_t* info, void* context) {
  if (refused_call < 0) {
    refused_call = info->si_syscall;
  }
  auto* const state = static_cast<ucontext_t*>(context);
#if defined(__x86_64__)
  state->uc_mcontext.gregs[REG_RAX] = -EPERM;
#elif defined(__aarch64__)
  state->uc_mcontext.regs[0] = static_cast<unsigned long long>(-EPERM);
#else
  static_cast<void>(state);
#endif
}

void limit(decltype(RLIMIT_CORE) resource, std::uint64_t value) noexcept {
  rlimit now{};
  getrlimit(resource, &now);
  const rlim_t bound = std::min<rlim_t>(value, now.rlim_max);
  const rlimit wanted{bound, bound};
  setrlimit(resource, &wanted);
}

// The manager must get the processor when its patience ends.
void step_back_behind_manager() noexcept {
  sched_param parameter{};
  const int policy = sched_getscheduler(0);
  if ((policy == SCHED_FIFO || policy == SCHED_RR) && sched_getparam(0, &parameter) == 0) {
    parameter.sched_priority = std::max(parameter.sched_priority - 1, sched_get_priority_min(policy));
    sched_setscheduler(0, policy, &parameter);
    mlockall(MCL_CURRENT | MCL_FUTURE);
  }
}

}  // namespace

void enter_child_bounds(const ChildBounds& bounds, int first_closed) noexcept {
  syscall(SYS_close_range, static_cast<unsigned>(first_closed), ~0U, 0U);
  step_back_behind_manager();
  limit(RLIMIT_CORE, 0);
  if (bounds.memory_limit_bytes == 0) {
    return;
  }
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their shadow memory is far larger
  limit(RLIMIT_AS, bounds.memory_limit_bytes);
#endif
  limit(RLIMIT_NOFILE, bounds.descriptor_limit);
  struct sigaction action {};
  action.sa_sigaction = &refuse;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(SIGSYS, &action, nullptr);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (!install_filter(bounds.local_sockets)) {
    limit(RLIMIT_NPROC, 0);
  }
}

std::string take_refused_call() {
  const int number = refused_call;
  refused_call = -1;
  if (number < 0) {
    return {};
  }
  const std::unique_ptr<char, decltype(&std::free)> name(
      seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, number), &std::free);
  return name == nullptr ? "system call " + std::to_string(number) : name.get();
}

}  // namespace gaitway::core

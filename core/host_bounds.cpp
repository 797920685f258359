// Resource limits and a seccomp filter. The filter names what is forbidden: what a plug-in's libraries need
// differs from one machine to the next, what no plug-in needs does not.
#include "host_bounds.hpp"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <vector>

namespace gaitway::core {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;  // no filter
#endif

struct ForbiddenCall {
  long number;
  const char* name;
};
constexpr ForbiddenCall kForbidden[] {
#if defined(__x86_64__)
  {SYS_fork, "fork"}, {SYS_vfork, "vfork"},
#endif
      {SYS_execve, "execve"}, {SYS_execveat, "execveat"}, {SYS_ptrace, "ptrace"},
      {SYS_process_vm_readv, "process_vm_readv"}, {SYS_process_vm_writev, "process_vm_writev"},
      {SYS_pidfd_open, "pidfd_open"}, {SYS_pidfd_getfd, "pidfd_getfd"},
      {SYS_pidfd_send_signal, "pidfd_send_signal"}, {SYS_rt_sigqueueinfo, "rt_sigqueueinfo"},
      {SYS_rt_tgsigqueueinfo, "rt_tgsigqueueinfo"}, {SYS_tkill, "tkill"}, {SYS_socket, "socket"},
      {SYS_connect, "connect"}, {SYS_bind, "bind"}, {SYS_listen, "listen"}, {SYS_accept, "accept"},
      {SYS_accept4, "accept4"}, {SYS_setrlimit, "setrlimit"}, {SYS_setpgid, "setpgid"},
      {SYS_setsid, "setsid"}, {SYS_setpriority, "setpriority"},
      {SYS_sched_setscheduler, "sched_setscheduler"}, {SYS_sched_setparam, "sched_setparam"},
      {SYS_sched_setattr, "sched_setattr"}, {SYS_unshare, "unshare"}, {SYS_setns, "setns"},
      {SYS_mount, "mount"}, {SYS_bpf, "bpf"}, {SYS_perf_event_open, "perf_event_open"},
      {SYS_io_uring_setup, "io_uring_setup"},
};
// Forbidden but for one use.
constexpr ForbiddenCall kRestricted[]{
    {SYS_clone, "clone"}, {SYS_kill, "kill"}, {SYS_tgkill, "tgkill"}, {SYS_prlimit64, "prlimit64"}};

volatile sig_atomic_t refused_call = -1;

class Filter {
 public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    only_if(BPF_JEQ, kArchitecture, SECCOMP_RET_KILL_PROCESS);
    load(offsetof(seccomp_data, nr));
    for (const ForbiddenCall& call : kForbidden) {
      add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call.number), 0, 1);
      add(BPF_RET | BPF_K, SECCOMP_RET_TRAP);
    }
    // Its flags lie in memory, where no filter sees them; without it libraries use clone.
    add(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone3, 0, 1);
    add(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS);
    const auto self = static_cast<std::uint32_t>(getpid());
    restrict_to(SYS_clone, 0, BPF_JSET, 0x0001'0000U);  // CLONE_THREAD
    restrict_to(SYS_kill, 0, BPF_JEQ, self);
    restrict_to(SYS_tgkill, 0, BPF_JEQ, self);
    restrict_to(SYS_prlimit64, 2, BPF_JEQ, 0);  // no new limit: it only asks
    add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  }
  bool install() noexcept {
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return kArchitecture != 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
  }

 private:
  void add(unsigned code, std::uint32_t value, unsigned yes = 0, unsigned no = 0) {
    code_.push_back({static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(yes),
                     static_cast<std::uint8_t>(no), value});
  }
  void load(std::size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)); }
  void only_if(unsigned test, std::uint32_t value, std::uint32_t otherwise) {
    add(BPF_JMP | test | BPF_K, value, 1, 0);
    add(BPF_RET | BPF_K, otherwise);
  }
  // Allowed if its argument (its lower word) passes the test.
  void restrict_to(long number, unsigned argument, unsigned test, std::uint32_t value) {
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(number), 0, 4);
    load(offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t));
    only_if(test, value, SECCOMP_RET_TRAP);
    add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  }

  std::vector<sock_filter> code_;
};

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

void enter_host_bounds(const HostBounds& bounds, int first_closed) noexcept {
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
  if (!Filter().install()) {
    limit(RLIMIT_NPROC, 0);
  }
}

std::string take_refused_call() {
  const long number = refused_call;
  refused_call = -1;
  if (number < 0) {
    return {};
  }
  for (const ForbiddenCall& call : kForbidden) {
    if (call.number == number) {
      return call.name;
    }
  }
  for (const ForbiddenCall& call : kRestricted) {
    if (call.number == number) {
      return call.name;
    }
  }
  return "system call " + std::to_string(number);
}

}  // namespace gaitway::core

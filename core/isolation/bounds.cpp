// Resource limits, capabilities and a seccomp filter. The filter names what is forbidden: what a plug-in's
// libraries need differs from one machine to the next, what no plug-in needs does not.
#include "bounds.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/prctl.h>
#include <linux/seccomp.h>
#include <linux/sockios.h>
#include <sched.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "seccomp_filter.hpp"

namespace gaitway::core {
namespace {

struct NamedCall {
  long number;
  const char* name;
};
constexpr NamedCall kForbidden[] {
#if defined(__x86_64__)
  {SYS_fork, "fork"}, {SYS_vfork, "vfork"},
#endif
      {SYS_execve, "execve"}, {SYS_execveat, "execveat"}, {SYS_ptrace, "ptrace"},
      {SYS_process_vm_readv, "process_vm_readv"}, {SYS_process_vm_writev, "process_vm_writev"},
      {SYS_pidfd_open, "pidfd_open"}, {SYS_pidfd_getfd, "pidfd_getfd"},
      {SYS_pidfd_send_signal, "pidfd_send_signal"}, {SYS_rt_sigqueueinfo, "rt_sigqueueinfo"},
      {SYS_rt_tgsigqueueinfo, "rt_tgsigqueueinfo"}, {SYS_tkill, "tkill"}, {SYS_setrlimit, "setrlimit"},
      {SYS_setpgid, "setpgid"}, {SYS_setsid, "setsid"}, {SYS_setpriority, "setpriority"},
      {SYS_sched_setscheduler, "sched_setscheduler"}, {SYS_sched_setparam, "sched_setparam"},
      {SYS_sched_setattr, "sched_setattr"}, {SYS_unshare, "unshare"}, {SYS_setns, "setns"},
      {SYS_mount, "mount"}, {SYS_bpf, "bpf"}, {SYS_perf_event_open, "perf_event_open"},
      {SYS_io_uring_setup, "io_uring_setup"},
};
constexpr NamedCall kNetwork[]{{SYS_socket, "socket"},
                               {SYS_socketpair, "socketpair"},
                               {SYS_connect, "connect"},
                               {SYS_bind, "bind"},
                               {SYS_listen, "listen"}};
constexpr NamedCall kAccepting[]{{SYS_accept, "accept"}, {SYS_accept4, "accept4"}};
// Forbidden but for some uses.
constexpr NamedCall kRestricted[]{{SYS_clone, "clone"},
                                  {SYS_kill, "kill"},
                                  {SYS_tgkill, "tgkill"},
                                  {SYS_prlimit64, "prlimit64"},
                                  {SYS_fcntl, "fcntl to signal others"},
                                  {SYS_ioctl, "ioctl to signal others or to type into a terminal"}};

enum class Reach : std::uint8_t { nothing, accepted_connections, network };

volatile sig_atomic_t refused_call = -1;
bool remembers_all_threads = true;

SeccompFilter make_filter(Reach reach, std::uint32_t refusal) {
  SeccompFilter filter(refusal);
  for (const NamedCall& call : kForbidden) {
    filter.refuse(call.number);
  }
  if (reach != Reach::network) {
    for (const NamedCall& call : kNetwork) {
      filter.refuse(call.number);
    }
  }
  if (reach == Reach::nothing) {
    for (const NamedCall& call : kAccepting) {
      filter.refuse(call.number);
    }
  }
  // Its flags lie in memory, where no filter sees them; without it libraries use clone.
  filter.refuse(SYS_clone3, SECCOMP_RET_ERRNO | ENOSYS);
  constexpr std::uint32_t kThread = 0x0001'0000U;  // CLONE_THREAD
  filter.refuse_unless(SYS_clone, 0, {kThread, kThread});
  const auto self = static_cast<std::uint32_t>(getpid());
  filter.refuse_unless(SYS_kill, 0, {.value = self});
  filter.refuse_unless(SYS_tgkill, 0, {.value = self});
  filter.refuse_unless_null(SYS_prlimit64, 2);  // no new limit: it only asks
  // A descriptor's owner is signalled by the kernel, and a terminal takes what is typed into it for its
  // user's.
  filter.refuse_unless_next(SYS_fcntl, 1, F_SETOWN, self, F_SETOWN_EX);
  filter.refuse_if(SYS_ioctl, 1, {FIOSETOWN, SIOCSPGRP, TIOCSTI, TIOCLINUX});
  return filter;
}

// Answers EPERM in the kernel's stead.
void refuse(int, siginfo_t* info, void* context) {
  if (refused_call < 0 && (remembers_all_threads || syscall(SYS_gettid) == getpid())) {
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

// What comes over the network is never in the way of a controller.
void step_back_behind_everybody() noexcept {
  constexpr int kNice = 5;
  const sched_param none{};
  sched_setscheduler(0, SCHED_OTHER, &none);
  errno = 0;
  const int now = getpriority(PRIO_PROCESS, 0);
  if (errno == 0 && now < kNice) {
    setpriority(PRIO_PROCESS, 0, kNice);
  }
}

// Of root's powers only those that set-up may need: a port below 1024, and files of others. Once set-up is
// over both are of no use, since neither can be asked for any more.
void drop_capabilities() noexcept {
  constexpr std::uint32_t kKept =
      1U << CAP_NET_BIND_SERVICE | 1U << CAP_DAC_OVERRIDE | 1U << CAP_DAC_READ_SEARCH;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
  if (syscall(SYS_capget, &header, sets.data()) == 0) {
    sets[0] = {sets[0].effective & kKept, sets[0].permitted & kKept, 0};
    sets[1] = {};
    syscall(SYS_capset, &header, sets.data());
  }
}

}  // namespace

void enter_child_bounds(const ChildBounds& bounds, int first_closed) noexcept {
  syscall(SYS_close_range, static_cast<unsigned>(first_closed), ~0U, 0U);
  bounds.serves_network ? step_back_behind_everybody() : step_back_behind_manager();
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
  remembers_all_threads = !bounds.serves_network;
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (bounds.serves_network) {
    drop_capabilities();
  }
  // A trap ends a thread that blocks its signal, as those of network libraries do.
  SeccompFilter filter = bounds.serves_network ? make_filter(Reach::network, SECCOMP_RET_ERRNO | EPERM)
                                               : make_filter(Reach::nothing, SECCOMP_RET_TRAP);
  if (!filter.install()) {
    limit(RLIMIT_NPROC, 0);
  }
}

bool remember_refused_calls() noexcept {
  return make_filter(Reach::accepted_connections, SECCOMP_RET_TRAP).install();
}

std::string take_refused_call() {
  const long number = refused_call;
  refused_call = -1;
  if (number < 0) {
    return {};
  }
  const auto named = [number](const auto& calls) {
    const auto found = std::find_if(std::begin(calls), std::end(calls),
                                    [number](const NamedCall& call) { return call.number == number; });
    return found == std::end(calls) ? std::string() : std::string(found->name);
  };
  for (std::string name : {named(kForbidden), named(kNetwork), named(kAccepting), named(kRestricted)}) {
    if (!name.empty()) {
      return name;
    }
  }
  return "system call " + std::to_string(number);
}

}  // namespace gaitway::core

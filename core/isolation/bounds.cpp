// Resource limits, capabilities and a seccomp filter. The filter names what is forbidden: what a plug-in's
// libraries need differs from one machine to the next, what no plug-in needs does not.
#include "bounds.hpp"

#include <fcntl.h>
#include <linux/capability.h>
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
#include <cstdlib>
#include <memory>

#include "seccomp_filter.hpp"

namespace gaitway::core {
namespace {

constexpr int kForbidden[]{SCMP_SYS(fork),
                           SCMP_SYS(vfork),
                           SCMP_SYS(execve),
                           SCMP_SYS(execveat),
                           SCMP_SYS(ptrace),
                           SCMP_SYS(process_vm_readv),
                           SCMP_SYS(process_vm_writev),
                           SCMP_SYS(pidfd_open),
                           SCMP_SYS(pidfd_getfd),
                           SCMP_SYS(pidfd_send_signal),
                           SCMP_SYS(rt_sigqueueinfo),
                           SCMP_SYS(rt_tgsigqueueinfo),
                           SCMP_SYS(tkill),
                           SCMP_SYS(setrlimit),
                           SCMP_SYS(setpgid),
                           SCMP_SYS(setsid),
                           SCMP_SYS(setpriority),
                           SCMP_SYS(sched_setscheduler),
                           SCMP_SYS(sched_setparam),
                           SCMP_SYS(sched_setattr),
                           SCMP_SYS(unshare),
                           SCMP_SYS(setns),
                           SCMP_SYS(mount),
                           SCMP_SYS(bpf),
                           SCMP_SYS(perf_event_open),
                           SCMP_SYS(io_uring_setup)};
constexpr int kNetwork[]{SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(connect), SCMP_SYS(bind),
                         SCMP_SYS(listen)};
constexpr int kAccepting[]{SCMP_SYS(accept), SCMP_SYS(accept4)};

enum class Reach : std::uint8_t { nothing, accepted_connections, network };

volatile sig_atomic_t refused_call = -1;
bool remembers_all_threads = true;

// `refusal`: see SeccompFilter. What is forbidden but for some uses has conditions.
bool install_filter(Reach reach, std::uint32_t refusal) noexcept {
  SeccompFilter filter(refusal);
  filter.refuse_all(kForbidden);
  if (reach != Reach::network) {
    filter.refuse_all(kNetwork);
  }
  if (reach == Reach::nothing) {
    filter.refuse_all(kAccepting);
  }
  // Its flags lie in memory, where no filter sees them; without it libraries use clone.
  filter.refuse(SCMP_SYS(clone3), SCMP_ACT_ERRNO(ENOSYS));
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
  return filter.install(SeccompFilter::Threads::this_one);
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
  if (bounds.serves_network ? !install_filter(Reach::network, SCMP_ACT_ERRNO(EPERM))
                            : !install_filter(Reach::nothing, SCMP_ACT_TRAP)) {
    limit(RLIMIT_NPROC, 0);
  }
}

bool remember_refused_calls() noexcept {
  return install_filter(Reach::accepted_connections, SCMP_ACT_TRAP);
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

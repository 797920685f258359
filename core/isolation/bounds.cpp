// Resource limits, capabilities, seccomp filters made with libseccomp, and Landlock. The filters name what is
// forbidden: what a plug-in's libraries need differs from one machine to the next, what no plug-in needs does
// not.
#include "bounds.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/sockios.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <utility>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::core {
namespace {

constexpr std::string_view kSocketCalls = "socket socketpair connect bind listen";

// A filter of system calls: everything is allowed but what is refused; calls of another architecture end the
// process.
class SeccompFilter {
 public:
  // `refusal`: SCMP_ACT_TRAP or SCMP_ACT_ERRNO(number).
  explicit SeccompFilter(std::uint32_t refusal) noexcept
      : refusal_(refusal), context_(seccomp_init(SCMP_ACT_ALLOW)) {
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
    refuse(call, refusal_, when);
  }
  void refuse(int call, std::uint32_t refusal, std::initializer_list<scmp_arg_cmp> when = {}) noexcept {
    const int result =
        seccomp_rule_add_array(context_, refusal, call, static_cast<unsigned>(when.size()), when.begin());
    sound_ = sound_ && (result == 0 || result == -EDOM);  // which says that this machine has no such call
  }
  // By their names, with spaces between them.
  void refuse_all(std::string_view calls) {
    for (std::size_t end = 0; !calls.empty(); calls.remove_prefix(std::min(end + 1, calls.size()))) {
      end = std::min(calls.find(' '), calls.size());
      const int call = seccomp_syscall_resolve_name(std::string(calls.substr(0, end)).c_str());
      sound_ = sound_ && call != __NR_SCMP_ERROR;
      refuse(call);
    }
  }

  // For the calling thread and those that it starts from now on, or for all threads of the process; that
  // fails where one of them has a filter that this one has not.
  enum class Threads : std::uint8_t { this_one, all };
  [[nodiscard]] bool install(Threads threads) noexcept {
    return sound_ &&
           (threads == Threads::this_one || seccomp_attr_set(context_, SCMP_FLTATR_CTL_TSYNC, 1) == 0) &&
           seccomp_load(context_) == 0;
  }

 private:
  std::uint32_t refusal_;
  scmp_filter_ctx context_;
  bool sound_ = false;
};

constexpr std::string_view kForbidden =
    "fork vfork execve execveat ptrace process_vm_readv process_vm_writev pidfd_open pidfd_getfd "
    "pidfd_send_signal rt_sigqueueinfo rt_tgsigqueueinfo tkill setrlimit setpgid setsid setpriority "
    "sched_setscheduler sched_setparam sched_setattr unshare setns mount bpf perf_event_open io_uring_setup";
constexpr std::string_view kAccepting = "accept accept4";

enum class Reach : std::uint8_t { nothing, accepted_connections, network };

volatile sig_atomic_t refused_call = -1;
bool remembers_all_threads = true;

// `refusal`: see SeccompFilter. What is forbidden but for some uses has conditions.
bool install_filter(Reach reach, std::uint32_t refusal) noexcept {
  SeccompFilter filter(refusal);
  filter.refuse_all(kForbidden);
  if (reach != Reach::network) {
    filter.refuse_all(kSocketCalls);
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

// --- Of one that serves the network: Landlock for where files are written; a filter for everything else.

namespace {

// Landlock's own numbers: the system's header may be older than its kernel.
namespace landlock {
constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr unsigned kAskVersion = 1;
constexpr int kPathBeneath = 1;
constexpr std::uint64_t kWriteFile = 1U << 1U, kMakeRegular = 1U << 8U, kRefer = 1U << 13U,
                        kTruncate = 1U << 14U;
// Remove a folder or a file, make a device, folder, file, socket, pipe or link: bits 4 to 12.
constexpr std::uint64_t kChangeFolders = 0x1ff0;
constexpr std::uint64_t kScopeSignals = 1U << 1U;

struct Ruleset {
  std::uint64_t handled_files = 0, handled_network = 0, scoped = 0;
};
struct [[gnu::packed]] Beneath {
  std::uint64_t allowed = 0;
  std::int32_t folder = -1;
};

int version() noexcept {
  return static_cast<int>(syscall(kCreateRuleset, nullptr, 0, kAskVersion));
}
}  // namespace landlock

process::FileDescriptor open_folder(const std::filesystem::path& folder) {
  process::FileDescriptor opened(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!opened) {
    throw PluginError("its writes cannot be confined to '" + folder.string() + "': " + strerror(errno));
  }
  return opened;
}

constexpr std::string_view kFiles =
    "creat unlink rename mkdir rmdir link symlink chmod chown lchown mknod utime utimes futimesat renameat "
    "openat2 open_by_handle_at unlinkat renameat2 mkdirat linkat symlinkat fchmod fchmodat fchown fchownat "
    "mknodat truncate utimensat setxattr lsetxattr fsetxattr removexattr lremovexattr fremovexattr mount "
    "umount2 chroot pivot_root open_tree move_mount fsopen fspick fsmount mount_setattr chdir fchdir";
// Other ways to other processes, and what no server does.
constexpr std::string_view kOthers =
    "execve execveat memfd_create shmget shmat semget semop semtimedop semctl msgget msgsnd msgctl mq_open "
    "mq_unlink keyctl add_key request_key sched_setaffinity ioprio_set migrate_pages move_pages personality "
    "userfaultfd";

}  // namespace

bool confine_writes(const std::filesystem::path& folder) {
  const process::FileDescriptor opened = folder.empty() ? process::FileDescriptor() : open_folder(folder);
  const int version = landlock::version();
  if (version < 1) {
    return false;
  }
  const std::uint64_t truncate = version >= 3 ? landlock::kTruncate : 0;
  landlock::Ruleset rules;
  rules.handled_files =
      landlock::kWriteFile | landlock::kChangeFolders | truncate | (version >= 2 ? landlock::kRefer : 0);
  rules.scoped = version >= 6 ? landlock::kScopeSignals : 0;
  const std::size_t known = version >= 6 ? 3 : version >= 4 ? 2 : 1;  // fields
  const process::FileDescriptor ruleset(
      static_cast<int>(syscall(landlock::kCreateRuleset, &rules, known * sizeof(std::uint64_t), 0)));
  const landlock::Beneath beneath{landlock::kWriteFile | landlock::kMakeRegular | truncate, opened.get()};
  const bool ruled = ruleset && (!opened || syscall(landlock::kAddRule, ruleset.get(), landlock::kPathBeneath,
                                                    &beneath, 0) == 0);
  return ruled && syscall(landlock::kRestrictSelf, ruleset.get(), 0) == 0;
}

void end_set_up(bool may_write) {
  SeccompFilter filter(SCMP_ACT_ERRNO(EPERM));
  filter.refuse_all(kSocketCalls);
  filter.refuse_all(kFiles);
  filter.refuse_all(kOthers);
  // A way to connect without connect().
  for (const auto& [call, flags] :
       {std::pair{SCMP_SYS(sendto), 3U}, {SCMP_SYS(sendmsg), 2U}, {SCMP_SYS(sendmmsg), 3U}}) {
    filter.refuse(call, {SeccompFilter::has(flags, MSG_FASTOPEN, MSG_FASTOPEN)});
  }
  constexpr std::uint32_t kRefusal = SCMP_ACT_ERRNO(EACCES);
  for (const auto& [call, flags] : {std::pair{SCMP_SYS(open), 1U}, {SCMP_SYS(openat), 2U}}) {
    if (!may_write) {
      filter.refuse(call, kRefusal);
      continue;
    }
    // But for O_WRONLY | O_CREAT.
    filter.refuse(call, kRefusal, {SeccompFilter::has(flags, O_PATH, O_PATH)});
    filter.refuse(call, kRefusal, {SeccompFilter::has(flags, O_CREAT, 0)});
    for (const int mode : {O_RDONLY, O_RDWR, O_ACCMODE}) {
      filter.refuse(call, kRefusal, {SeccompFilter::has(flags, O_ACCMODE, static_cast<std::uint32_t>(mode))});
    }
  }
  if (!filter.install(SeccompFilter::Threads::all)) {
    throw PluginError(
        "its process cannot be closed off from files and connections: network: serve needs a kernel with "
        "seccomp, and a plug-in whose threads have no filters of their own");
  }
  if (!remember_refused_calls()) {
    throw PluginError(std::string("its own thread cannot be bound: ") + strerror(errno));
  }
}

}  // namespace gaitway::core

// Landlock for where files are written; a seccomp filter for everything else.
#include "network_bounds.hpp"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>

#include "bounds.hpp"
#include "gaitway/manager/plugin_error.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "seccomp_filter.hpp"

namespace gaitway::core {
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

constexpr std::array kSockets{SYS_socket, SYS_socketpair, SYS_connect, SYS_bind, SYS_listen};
constexpr std::array kFiles {
#if defined(__x86_64__)
  SYS_creat, SYS_unlink, SYS_rename, SYS_mkdir, SYS_rmdir, SYS_link, SYS_symlink, SYS_chmod, SYS_chown,
      SYS_lchown, SYS_mknod, SYS_utime, SYS_utimes, SYS_futimesat, SYS_renameat,
#endif
      SYS_openat2, SYS_open_by_handle_at, SYS_unlinkat, SYS_renameat2, SYS_mkdirat, SYS_linkat, SYS_symlinkat,
      SYS_fchmod, SYS_fchmodat, SYS_fchown, SYS_fchownat, SYS_mknodat, SYS_truncate, SYS_utimensat,
      SYS_setxattr, SYS_lsetxattr, SYS_fsetxattr, SYS_removexattr, SYS_lremovexattr, SYS_fremovexattr,
      SYS_mount, SYS_umount2, SYS_chroot, SYS_pivot_root, SYS_open_tree, SYS_move_mount, SYS_fsopen,
      SYS_fspick, SYS_fsmount, SYS_mount_setattr, SYS_chdir, SYS_fchdir
};
// Other ways to other processes, and what no server does.
constexpr std::array kOthers{
    SYS_execve,     SYS_execveat,    SYS_memfd_create,      SYS_shmget,     SYS_shmat,
    SYS_semget,     SYS_semop,       SYS_semtimedop,        SYS_semctl,     SYS_msgget,
    SYS_msgsnd,     SYS_msgctl,      SYS_mq_open,           SYS_mq_unlink,  SYS_keyctl,
    SYS_add_key,    SYS_request_key, SYS_sched_setaffinity, SYS_ioprio_set, SYS_migrate_pages,
    SYS_move_pages, SYS_personality, SYS_userfaultfd};
constexpr std::uint32_t kOpenMask = O_ACCMODE | O_CREAT | O_PATH;
constexpr std::uint32_t kOpenToWrite = O_WRONLY | O_CREAT;

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
  SeccompFilter filter(SECCOMP_RET_ERRNO | EPERM);
  const auto refuse_all = [&filter](const auto& calls) {
    for (const long call : calls) {
      filter.refuse(call);
    }
  };
  refuse_all(kSockets);
  refuse_all(kFiles);
  refuse_all(kOthers);
  // A way to connect without connect().
  filter.refuse_unless(SYS_sendto, 3, {MSG_FASTOPEN, 0});
  filter.refuse_unless(SYS_sendmsg, 2, {MSG_FASTOPEN, 0});
  filter.refuse_unless(SYS_sendmmsg, 3, {MSG_FASTOPEN, 0});
  constexpr std::uint32_t kRefusal = SECCOMP_RET_ERRNO | EACCES;
  const auto restrict_open = [&](long call, unsigned flags) {
    if (may_write) {
      filter.refuse_unless(call, flags, {kOpenMask, kOpenToWrite}, kRefusal);
    } else {
      filter.refuse(call, kRefusal);
    }
  };
#if defined(__x86_64__)
  restrict_open(SYS_open, 1);
#endif
  restrict_open(SYS_openat, 2);
  if (!filter.install_in_all_threads()) {
    throw PluginError(
        "its process cannot be closed off from files and connections: network: serve needs a kernel with "
        "seccomp, "
        "and a plug-in whose threads have no filters of their own");
  }
  if (!remember_refused_calls()) {
    throw PluginError(std::string("its own thread cannot be bound: ") + strerror(errno));
  }
}

}  // namespace gaitway::core

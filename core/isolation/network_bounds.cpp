// Landlock for where files are written; a seccomp filter for everything else.
#include "bounds.hpp"

#include <fcntl.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <utility>

#include "bounds.hpp"
#include "gaitway/instance/configuration.hpp"
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

constexpr int kSockets[]{SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(connect), SCMP_SYS(bind),
                         SCMP_SYS(listen)};
constexpr int kFiles[]{SCMP_SYS(creat),
                       SCMP_SYS(unlink),
                       SCMP_SYS(rename),
                       SCMP_SYS(mkdir),
                       SCMP_SYS(rmdir),
                       SCMP_SYS(link),
                       SCMP_SYS(symlink),
                       SCMP_SYS(chmod),
                       SCMP_SYS(chown),
                       SCMP_SYS(lchown),
                       SCMP_SYS(mknod),
                       SCMP_SYS(utime),
                       SCMP_SYS(utimes),
                       SCMP_SYS(futimesat),
                       SCMP_SYS(renameat),
                       SCMP_SYS(openat2),
                       SCMP_SYS(open_by_handle_at),
                       SCMP_SYS(unlinkat),
                       SCMP_SYS(renameat2),
                       SCMP_SYS(mkdirat),
                       SCMP_SYS(linkat),
                       SCMP_SYS(symlinkat),
                       SCMP_SYS(fchmod),
                       SCMP_SYS(fchmodat),
                       SCMP_SYS(fchown),
                       SCMP_SYS(fchownat),
                       SCMP_SYS(mknodat),
                       SCMP_SYS(truncate),
                       SCMP_SYS(utimensat),
                       SCMP_SYS(setxattr),
                       SCMP_SYS(lsetxattr),
                       SCMP_SYS(fsetxattr),
                       SCMP_SYS(removexattr),
                       SCMP_SYS(lremovexattr),
                       SCMP_SYS(fremovexattr),
                       SCMP_SYS(mount),
                       SCMP_SYS(umount2),
                       SCMP_SYS(chroot),
                       SCMP_SYS(pivot_root),
                       SCMP_SYS(open_tree),
                       SCMP_SYS(move_mount),
                       SCMP_SYS(fsopen),
                       SCMP_SYS(fspick),
                       SCMP_SYS(fsmount),
                       SCMP_SYS(mount_setattr),
                       SCMP_SYS(chdir),
                       SCMP_SYS(fchdir)};
// Other ways to other processes, and what no server does.
constexpr int kOthers[]{SCMP_SYS(execve),      SCMP_SYS(execveat),      SCMP_SYS(memfd_create),
                        SCMP_SYS(shmget),      SCMP_SYS(shmat),         SCMP_SYS(semget),
                        SCMP_SYS(semop),       SCMP_SYS(semtimedop),    SCMP_SYS(semctl),
                        SCMP_SYS(msgget),      SCMP_SYS(msgsnd),        SCMP_SYS(msgctl),
                        SCMP_SYS(mq_open),     SCMP_SYS(mq_unlink),     SCMP_SYS(keyctl),
                        SCMP_SYS(add_key),     SCMP_SYS(request_key),   SCMP_SYS(sched_setaffinity),
                        SCMP_SYS(ioprio_set),  SCMP_SYS(migrate_pages), SCMP_SYS(move_pages),
                        SCMP_SYS(personality), SCMP_SYS(userfaultfd)};

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
  filter.refuse_all(kSockets);
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

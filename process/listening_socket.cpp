// A Unix socket at a path: locks the path, binds, listens; the lock file stays behind, since another process
// may be waiting at it.
#include "gaitway/process/listening_socket.hpp"

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace gaitway::process {
namespace {

constexpr int kBacklog = 16;
constexpr mode_t kOwnerOnly = 0600;

}  // namespace

sockaddr_un socket_address(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string& text = path.native();
  if (text.empty() || text.size() >= sizeof address.sun_path) {
    throw SocketError("socket '" + text + "': a path has 1 to " +
                      std::to_string(sizeof address.sun_path - 1) + " characters, this one has " +
                      std::to_string(text.size()) + "; choose another one");
  }
  std::memcpy(address.sun_path, text.data(), text.size());
  return address;
}

ListeningSocket::ListeningSocket(std::filesystem::path path, std::string_view owner)
    : path_(std::move(path)), epoll_(epoll_create1(EPOLL_CLOEXEC)) {
  static_cast<void>(socket_address(path_));  // refuses a bad path before anything is made
  if (!epoll_) {
    fail("cannot wait for clients");
  }
  lock(owner);
  listen();
  watch(listener_);
  spare_ = take_spare();
}

ListeningSocket::~ListeningSocket() {
  unlink(path_.c_str());
}

void ListeningSocket::fail(std::string_view what) const {
  throw SocketError("socket '" + path_.native() + "': " + std::string(what) + ": " + std::strerror(errno));
}

void ListeningSocket::lock(std::string_view owner) {
  const std::string lock_path = path_.native() + ".lock";
  lock_ = FileDescriptor(open(lock_path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, kOwnerOnly));
  if (!lock_) {
    fail("cannot make '" + lock_path + "'");
  }
  if (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw SocketError("socket '" + path_.native() + "': another " + std::string(owner) +
                      " serves it; end that one first, or choose another path");
  }
}

void ListeningSocket::listen() {
  const sockaddr_un address = socket_address(path_);
  listener_ = FileDescriptor(socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!listener_) {
    fail("cannot make a socket");
  }
  if (struct stat status{}; lstat(path_.c_str(), &status) == 0 && S_ISSOCK(status.st_mode)) {
    unlink(path_.c_str());  // we hold the lock: nobody serves it
  }
  if (bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    fail("cannot bind");
  }
  if (chmod(path_.c_str(), kOwnerOnly) != 0 || ::listen(listener_.get(), kBacklog) != 0) {
    fail("cannot listen");
  }
}

FileDescriptor ListeningSocket::take_spare() const noexcept {
  return FileDescriptor(fcntl(listener_.get(), F_DUPFD_CLOEXEC, 0));
}

FileDescriptor ListeningSocket::accept() noexcept {
  while (true) {
    FileDescriptor client(accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (client || (errno != EMFILE && errno != ENFILE) || !spare_) {
      return client;
    }
    spare_ = FileDescriptor();
    const bool turned_away(FileDescriptor(accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC)));
    spare_ = take_spare();
    if (!turned_away) {
      return client;  // nobody waits: that, too, is told only with a descriptor left
    }
  }
}

void ListeningSocket::watch(const FileDescriptor& connection) const {
  epoll_event event{};
  event.events = EPOLLIN | EPOLLRDHUP;
  event.data.fd = connection.get();
  if (epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, connection.get(), &event) != 0) {
    fail("cannot wait for a client");
  }
}

}  // namespace gaitway::process

// One datagram a notice; a name that begins with @ is an abstract one.
#include "tools/robot/keeper/service_notice.hpp"

#include <sys/socket.h>
#include <sys/un.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

ServiceNotice::ServiceNotice() {
  if (const char* const socket = std::getenv("NOTIFY_SOCKET"); socket != nullptr) {
    socket_ = socket;
  }
  for (const char* const name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) unsetenv(name);
}

void ServiceNotice::tell(const std::string& what) const {
  sockaddr_un address{};
  if (socket_.empty() || socket_.size() >= sizeof address.sun_path) return;
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, socket_.data(), socket_.size());
  if (address.sun_path[0] == '@') address.sun_path[0] = '\0';
  const process::FileDescriptor out(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + socket_.size());
  // A manager that does not listen is its own loss.
  static_cast<void>(sendto(out.get(), what.data(), what.size(), MSG_NOSIGNAL,
                           reinterpret_cast<const sockaddr*>(&address), length));
}

}  // namespace gaitway::tools

// Addresses and descriptors of the bus's sockets.
#include "bus_protocol.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <string>

#include "gaitway/can/bus_error.hpp"

namespace gaitway::can {

BusDescriptor::~BusDescriptor() {
  if (fd_ >= 0) {
    close(fd_);
  }
}

namespace protocol {

sockaddr_un address_of(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string& text = path.native();
  if (text.empty() || text.size() >= sizeof address.sun_path) {
    throw BusError("bus socket '" + text + "': a path has 1 to " +
                   std::to_string(sizeof address.sun_path - 1) + " characters, this one has " +
                   std::to_string(text.size()) + "; choose a shorter one");
  }
  std::memcpy(address.sun_path, text.data(), text.size());
  return address;
}

}  // namespace protocol
}  // namespace gaitway::can

// A socket pair, a process, a sealed segment.
#include "child_link.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <string.h>
#include <sys/socket.h>

#include <cerrno>
#include <new>
#include <system_error>

namespace gaitway::core {

ChildLink::ChildLink(const std::filesystem::path& binary, const ChildBounds& bounds) {
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
    throw PluginError(fmt::format("no socket pair for its process: {}", strerror(errno)));
  }
  socket = process::FileDescriptor(ends[0]);
  const process::FileDescriptor theirs(ends[1]);
  process = ChildProcess(binary, theirs, bounds);
}

void ChildLink::attach(const std::vector<std::uint32_t>& port_sizes) {
  layout_ = std::make_unique<ExchangeLayout>(port_sizes);
  try {
    segment_ = std::make_unique<msgclient::Segment>(
        msgclient::Segment::create("gaitway plug-in exchange", layout_->bytes));
  } catch (const std::system_error& error) {
    throw PluginError(error.what());
  }
  new (segment_->data()) ExchangeHeader;
  for (std::size_t i = 0; i < port_sizes.size(); ++i) {
    new (&port(i)) PortArea;
  }
  if (!send_packet(socket, PacketWriter(ChildMessage::attach).bytes(), segment_->fd())) {
    throw PluginError("its process went before it was handed its memory");
  }
}

bool ChildLink::is_whole() const noexcept {
  bool whole = exchange().guard == kExchangeGuard && exchange().end_guard == kExchangeGuard;
  for (std::size_t i = 0; i < layout_->port_offset.size(); ++i) {
    whole = whole && port(i).guard == kExchangeGuard;
  }
  return whole;
}

void ChildLink::wait_for_message(int timeout_ms) const noexcept {
  pollfd watched[]{{socket.get(), POLLIN, 0}, {process.fd(), POLLIN, 0}};
  poll(watched, 2, timeout_ms);
}

}  // namespace gaitway::core

// A peer is an IPv6 address everywhere, also where the socket is an IPv4 one.
#include "gaitway/stopgram/stop_socket.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

namespace gaitway::stopgram {
namespace {

constexpr std::size_t kPrefixBytes = 12;  // of an IPv4 address as an IPv6 one
constexpr std::array<std::uint8_t, kPrefixBytes> kPrefix{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};

bool is_ipv4(const Peer& peer) {
  return std::equal(kPrefix.begin(), kPrefix.end(), peer.address.begin());
}

struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t length = sizeof storage;
  [[nodiscard]] sockaddr* get() noexcept { return reinterpret_cast<sockaddr*>(&storage); }
};

Peer peer_of(const sockaddr& address) {
  Peer peer;
  if (address.sa_family == AF_INET) {
    const auto& v4 = reinterpret_cast<const sockaddr_in&>(address);
    std::ranges::copy(kPrefix, peer.address.begin());
    std::memcpy(peer.address.data() + kPrefixBytes, &v4.sin_addr, sizeof v4.sin_addr);
    peer.port = ntohs(v4.sin_port);
  } else {
    const auto& v6 = reinterpret_cast<const sockaddr_in6&>(address);
    std::memcpy(peer.address.data(), &v6.sin6_addr, sizeof v6.sin6_addr);
    peer.port = ntohs(v6.sin6_port);
    peer.scope = v6.sin6_scope_id;
  }
  return peer;
}

SocketAddress address_of(const Peer& peer, bool ipv6) {
  SocketAddress address;
  if (ipv6) {
    auto& v6 = reinterpret_cast<sockaddr_in6&>(address.storage);
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(peer.port);
    v6.sin6_scope_id = peer.scope;
    std::memcpy(&v6.sin6_addr, peer.address.data(), sizeof v6.sin6_addr);
    address.length = sizeof v6;
  } else {
    auto& v4 = reinterpret_cast<sockaddr_in&>(address.storage);
    v4.sin_family = AF_INET;
    v4.sin_port = htons(peer.port);
    std::memcpy(&v4.sin_addr, peer.address.data() + kPrefixBytes, sizeof v4.sin_addr);
    address.length = sizeof v4;
  }
  return address;
}

// Nothing: `reason` is what getaddrinfo says.
std::optional<Peer> look_up(const std::string& host, std::uint16_t port, int flags, int& reason) {
  addrinfo hints{};
  hints.ai_flags = flags | AI_NUMERICSERV;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const std::string name = host == "localhost" ? "127.0.0.1" : host;
  reason = getaddrinfo(name.c_str(), std::to_string(port).c_str(), &hints, &found);
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, freeaddrinfo);
  std::optional<Peer> peer;
  for (; found != nullptr; found = found->ai_next) {
    if (!peer || (found->ai_family == AF_INET && !is_ipv4(*peer))) {
      peer = peer_of(*found->ai_addr);
    }
  }
  return peer;
}

[[noreturn]] void refuse_binding(const std::string& address, std::uint16_t port, int error) {
  const std::string where = "UDP port " + std::to_string(port) + " at address '" + address + "', for stops: ";
  if (error == EADDRINUSE) {
    throw StopSocketError(
        where + "is taken by another program (see `ss -lunp`): end it, or take another with --stop-port");
  }
  if (error == EADDRNOTAVAIL) {
    throw StopSocketError(where + "this machine has no such address: see `ip address`");
  }
  if (error == EACCES) {
    throw StopSocketError(where +
                          "ports below 1024 are for privileged programs: take a higher one with --stop-port");
  }
  throw StopSocketError(where + "cannot be opened (" + std::strerror(error) +
                        "): mend that, or do without by --stop-port 0");
}

process::FileDescriptor open_socket(bool ipv6) {
  return process::FileDescriptor(
      socket(ipv6 ? AF_INET6 : AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, IPPROTO_UDP));
}

}  // namespace

Peer find_peer(const std::string& host, std::uint16_t port) {
  int reason = 0;
  if (const auto peer = look_up(host, port, 0, reason)) {
    return *peer;
  }
  throw StopSocketError("host '" + host + "' (port " + std::to_string(port) +
                        "): has no address: " + gai_strerror(reason) + ". Give its numeric address");
}

StopSocket::StopSocket(const std::string& address, std::uint16_t port) {
  int reason = 0;
  const auto own = look_up(address, port, AI_NUMERICHOST, reason);
  if (!own) {
    throw StopSocketError("address '" + address + "', for stops (UDP port " + std::to_string(port) +
                          "): must be a numeric IPv4 or IPv6 address or localhost");
  }
  ipv6_ = !is_ipv4(*own);
  socket_ = open_socket(ipv6_);
  if (ipv6_) {
    const int only_ipv6 = 0;
    setsockopt(socket_.get(), IPPROTO_IPV6, IPV6_V6ONLY, &only_ipv6, sizeof only_ipv6);
  }
  SocketAddress where = address_of(*own, ipv6_);
  if (!socket_ || bind(socket_.get(), where.get(), where.length) != 0) {
    refuse_binding(address, port, errno);
  }
}

StopSocket::StopSocket(const Peer& peer) : ipv6_(!is_ipv4(peer)) {
  socket_ = open_socket(ipv6_);
  if (!socket_) {
    throw StopSocketError("no UDP socket to reach " + text_of(peer) + ": " + std::strerror(errno) +
                          (errno == EAFNOSUPPORT ? ". Give an address of the other IP version" : ""));
  }
}

std::optional<StopSocket::Received> StopSocket::receive() noexcept {
  SocketAddress from;
  ssize_t size = 0;
  do {
    from.length = sizeof from.storage;
    size = recvfrom(socket_.get(), room_.data(), room_.size(), 0, from.get(), &from.length);
  } while (size < 0 && errno == EINTR);
  if (size < 0) {
    return std::nullopt;
  }
  return Received{Bytes(room_).first(static_cast<std::size_t>(size)), peer_of(*from.get())};
}

bool StopSocket::send(Bytes datagram, const Peer& to) noexcept {
  SocketAddress address = address_of(to, ipv6_);
  return sendto(socket_.get(), datagram.data(), datagram.size(), MSG_NOSIGNAL, address.get(),
                address.length) >= 0;
}

std::uint16_t StopSocket::port() const {
  SocketAddress own;
  getsockname(socket_.get(), own.get(), &own.length);
  return peer_of(*own.get()).port;
}

}  // namespace gaitway::stopgram

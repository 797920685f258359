// A station in another process than the simulated bus: its end of the bus socket.
#include "gaitway/can/simulated/bus_client.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <string>
#include <utility>

#include "bus_protocol.hpp"
#include "gaitway/process/listening_socket.hpp"

namespace gaitway::can {

using protocol::Kind;
using protocol::Record;

struct BusClient::Packets {
  protocol::Packet outgoing;
  std::size_t outgoing_count = 0;
  protocol::Packet incoming;
  std::size_t incoming_count = 0;
  std::size_t incoming_next = 0;
};

BusClient::BusClient(const std::filesystem::path& socket, std::string_view name, Pace pace)
    : path_(socket), packets_(std::make_unique<Packets>()), pace_(pace) {
  const sockaddr_un address = process::socket_address(path_);
  socket_ = process::FileDescriptor(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket_) {
    fail("cannot make a socket");
  }
  if (connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    fail("nobody serves a bus there. Is virtual_robot running, with this path? connect");
  }
  Record hello{.kind = Kind::hello, .flag = static_cast<std::uint8_t>(pace), .start_ns = protocol::kMagic};
  std::copy_n(name.begin(), std::min(name.size(), hello.data.size()), hello.data.begin());
  packets_->outgoing[packets_->outgoing_count++] = hello;
  send_packet();
}

BusClient::~BusClient() = default;

void BusClient::fail(std::string_view what) const {
  throw BusError("bus socket '" + path_.native() + "': " + std::string(what) + ": " + std::strerror(errno));
}

bool BusClient::transmit(const Frame& frame, std::int64_t now_ns) {
  if (closed_ || unsent_ >= kTransmitBuffers) {
    return false;
  }
  packets_->outgoing[packets_->outgoing_count++] = protocol::record_of(Kind::transmit, frame, now_ns);
  ++unsent_;
  if (packets_->outgoing_count == packets_->outgoing.size()) {
    send_packet();
  }
  return true;
}

void BusClient::flush(std::int64_t now_ns) {
  packets_->outgoing[packets_->outgoing_count++] = Record{.kind = Kind::mark, .start_ns = now_ns};
  send_packet();
}

void BusClient::send_packet() {
  const std::size_t bytes = packets_->outgoing_count * sizeof(Record);
  if (!closed_ && send(socket_.get(), packets_->outgoing.data(), bytes, MSG_NOSIGNAL) < 0) {
    if (errno == EAGAIN || errno == EWOULDBLOCK) {
      // The server has not read for so long that the socket is full. Marks alone may get lost without harm.
      const auto end = packets_->outgoing.begin() + static_cast<std::ptrdiff_t>(packets_->outgoing_count);
      if (std::none_of(packets_->outgoing.begin(), end,
                       [](const Record& r) { return r.kind == Kind::transmit; })) {
        packets_->outgoing_count = 0;
        return;
      }
      fail("the bus does not read");
    }
    if (errno != EPIPE && errno != ECONNRESET) {
      fail("cannot send");
    }
    closed_ = true;
  }
  packets_->outgoing_count = 0;
}

bool BusClient::receive_packet() {
  if (closed_) {
    return false;
  }
  const ssize_t bytes = recv(socket_.get(), packets_->incoming.data(), sizeof packets_->incoming, 0);
  if (bytes < 0) {
    if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) {
      return false;
    }
    if (errno != ECONNRESET) {
      fail("cannot receive");
    }
  }
  closed_ = bytes <= 0;
  packets_->incoming_next = 0;
  packets_->incoming_count = closed_ ? 0 : static_cast<std::size_t>(bytes) / sizeof(Record);
  return packets_->incoming_count > 0;
}

std::optional<TimedFrame> BusClient::receive() {
  while (packets_->incoming_next < packets_->incoming_count || receive_packet()) {
    const Record& record = packets_->incoming[packets_->incoming_next++];
    // Records come in the bus's order: a frame tells how far it has run, too.
    bus_time_ns_ = std::max(bus_time_ns_, record.kind == Kind::mark ? record.start_ns : record.end_ns);
    if (record.kind == Kind::sent) {
      --unsent_;
      if (!protocol::valid_frame(record)) {
        continue;
      }
      notices_.push({BusNotice::Kind::sent, {protocol::frame_of(record), record.start_ns, record.end_ns}});
    } else if (record.kind == Kind::error) {
      notices_.push({BusNotice::Kind::error, {{}, record.start_ns, record.end_ns}});
    } else if (record.kind == Kind::delivery && protocol::valid_frame(record)) {
      return TimedFrame{protocol::frame_of(record), record.start_ns, record.end_ns};
    }
  }
  return std::nullopt;
}

LastingBusClient::LastingBusClient(std::filesystem::path socket, std::string name, Pace pace)
    : socket_(std::move(socket)), name_(std::move(name)), pace_(pace) {
  client_.emplace(socket_, name_, pace_);
}

template <class Work>
void LastingBusClient::attempt(const Work& work) noexcept {
  if (!client_) {
    return;
  }
  try {
    work();
  } catch (const BusError&) {  // it does not read any more, or the like
    client_.reset();
  }
  if (client_ && client_->closed()) {
    client_.reset();
  }
  if (!client_) {
    go_down();
    next_try_ns_ = now_ns_ + kBetweenTries_ns;
  }
}

bool LastingBusClient::transmit(const Frame& frame, std::int64_t now_ns) {
  bool taken = false;
  if (state_ != BusState::down) {
    attempt([&] { taken = client_->transmit(frame, now_ns); });
  }
  return taken;
}

std::optional<TimedFrame> LastingBusClient::receive() {
  std::optional<TimedFrame> frame;
  attempt([&] { frame = client_->receive(); });
  return frame;
}

void LastingBusClient::flush(std::int64_t now_ns) {
  now_ns_ = now_ns;
  if (!client_ && now_ns >= next_try_ns_) {
    next_try_ns_ = now_ns + kBetweenTries_ns;
    connect_again();
  }
  attempt([&] { client_->flush(now_ns); });
  judge(now_ns);
}

void LastingBusClient::connect_again() noexcept {
  try {
    client_.emplace(socket_, name_, pace_);
  } catch (const std::exception&) {  // still nobody
    client_.reset();
  }
}

void LastingBusClient::judge(std::int64_t now_ns) noexcept {
  if (!client_) {
    return;
  }
  if (pace_ == Pace::free) {
    state_ = BusState::error_active;
    return;
  }
  const std::int64_t bus_ns = client_->bus_time_ns();
  const bool was_away = now_ns - judged_ns_ > kLongestWait_ns;  // who did not listen has heard nothing
  if (bus_ns != heard_ns_ || was_away) {
    heard_ns_ = bus_ns;
    heard_at_ns_ = now_ns;
  }
  judged_ns_ = now_ns;
  if (state_ == BusState::down) {
    state_ = bus_ns >= now_ns - kLongestWait_ns ? BusState::error_active : BusState::down;
  } else if (now_ns - heard_at_ns_ > kStandstill_ns) {
    go_down();
  }
}

void LastingBusClient::go_down() noexcept {
  outages_ += state_ != BusState::down ? 1U : 0U;
  state_ = BusState::down;
}

}  // namespace gaitway::can

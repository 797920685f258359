// The simulated bus's end of the bus socket: stations of other processes come and go, their frames wait in
// transmit buffers until their time.
#include "gaitway/can/simulated/bus_server.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <string>

#include "bus_protocol.hpp"
#include "gaitway/can/simulated/bus_client.hpp"
#include "gaitway/can/simulated/station_transmitter.hpp"

namespace gaitway::can {
namespace {

using protocol::Kind;
using protocol::Record;

constexpr std::size_t kMostClients = 64;  // half of the bus's stations; the others are for local ones
constexpr int kPacketsAStep = 256;        // of one client: bounds the time that one step takes
// What may wait for a client beside its full socket: a second of a full bus. One that does not read for
// longer goes.
constexpr std::size_t kLongestBacklog = 8192;
constexpr std::int64_t kLate_ns = 1'000'000;
constexpr std::int64_t kNever_ns = std::numeric_limits<std::int64_t>::max();

// The transmit buffers of one client: frames that wait, each from its own time on.
class TransmitBuffers {
 public:
  // False: all are occupied.
  bool add(const Frame& frame, std::int64_t release_ns) noexcept {
    return insert(frame, release_ns, next_order_++);
  }

  // Frames whose time has come are there to be taken; time does not run backwards.
  void run_to(std::int64_t now_ns) noexcept { now_ns_ = now_ns; }
  [[nodiscard]] std::int64_t next_release_ns() const noexcept {
    std::int64_t next_ns = kNever_ns;
    for (const Buffer& buffer : buffers_) {
      if (buffer.used && buffer.release_ns > now_ns_) {
        next_ns = std::min(next_ns, buffer.release_ns);
      }
    }
    return next_ns;
  }
  [[nodiscard]] std::uint32_t next_id() const noexcept {
    const Buffer* const buffer = most_urgent();
    return buffer == nullptr ? kLargestExtendedId + 1 : buffer->frame.id;
  }
  [[nodiscard]] std::uint32_t next_key() const noexcept {
    const Buffer* const buffer = most_urgent();
    return buffer == nullptr ? kNoFrameKey : arbitration_key(buffer->frame);
  }
  bool take_frame(Frame& frame) noexcept {
    const Buffer* const buffer = most_urgent();
    if (buffer == nullptr) {
      return false;
    }
    frame = buffer->frame;
    buffers_[static_cast<std::size_t>(buffer - buffers_.data())].used = false;
    return true;
  }
  void put_back(const Frame& frame) noexcept { insert(frame, now_ns_, 0); }

 private:
  struct Buffer {
    bool used = false;
    Frame frame;
    std::int64_t release_ns = 0;
    std::uint64_t order = 0;
  };
  bool insert(const Frame& frame, std::int64_t release_ns, std::uint64_t order) noexcept {
    const auto free = std::ranges::find_if_not(buffers_, &Buffer::used);
    if (free == buffers_.end()) {
      return false;
    }
    *free = {true, frame, release_ns, order};
    return true;
  }
  [[nodiscard]] const Buffer* most_urgent() const noexcept {
    const Buffer* best = nullptr;
    for (const Buffer& buffer : buffers_) {
      const bool ready = buffer.used && buffer.release_ns <= now_ns_;
      if (ready && (best == nullptr || std::pair(arbitration_key(buffer.frame), buffer.order) <
                                           std::pair(arbitration_key(best->frame), best->order))) {
        best = &buffer;
      }
    }
    return best;
  }

  // One more than the client may have: the frame in the station's own buffer may have to come back.
  std::array<Buffer, kTransmitBuffers + 1> buffers_{};
  std::uint64_t next_order_ = 1;
  std::int64_t now_ns_ = 0;
};

}  // namespace

struct BusServer::Client {
  Client(process::FileDescriptor connection, int station)
      : socket(std::move(connection)), transmitter(station) {
    outgoing.reserve(kLongestBacklog);
  }

  process::FileDescriptor socket;
  StationTransmitter transmitter;
  TransmitBuffers buffers;
  int waiting = 0;  // frames that have not been sent: in the buffers and on the bus
  bool greeted = false;
  bool paced = false;
  bool started = false;  // has flushed once: a client that is still setting up does not hold up a running bus
  bool gone = false;
  std::int64_t reached_ns = 0;
  std::int64_t told_ns = 0;  // how far it knows that the bus has run
  std::vector<Record> outgoing;

  // Who keeps the bus's pace and reads nothing was stopped, and goes on with what is newest, as behind a
  // controller that has run over; who only listens would have gaps that it does not know of, and goes.
  void hand(const Record& record) {
    if (paced && outgoing.size() == kLongestBacklog) {
      std::erase_if(outgoing, [](const Record& old) { return old.kind != Kind::sent; });
    }
    gone = gone || outgoing.size() == kLongestBacklog;
    if (!gone) {
      outgoing.push_back(record);
    }
  }
  // The newest one says it all: of who does not read they do not pile up.
  void hand_mark(std::int64_t time_ns) {
    if (!outgoing.empty() && outgoing.back().kind == Kind::mark) {
      outgoing.back().start_ns = time_ns;
    } else {
      hand(Record{.kind = Kind::mark, .start_ns = time_ns});
    }
  }
  bool take(const Record& record, std::int64_t time_ns, BusServerStatistics& statistics);
  void flush();
};

// False: the client breaks the protocol.
bool BusServer::Client::take(const Record& record, std::int64_t time_ns, BusServerStatistics& statistics) {
  if (!greeted) {
    greeted = record.kind == Kind::hello && record.start_ns == protocol::kMagic;
    paced = record.flag == static_cast<std::uint8_t>(Pace::kept);
    return greeted;
  }
  if (record.kind == Kind::mark) {
    reached_ns = std::max(reached_ns, record.start_ns);
    started = true;
    return true;
  }
  if (record.kind != Kind::transmit || !protocol::valid_frame(record) || waiting >= kTransmitBuffers) {
    return false;
  }
  ++waiting;
  statistics.late_frames += record.start_ns < time_ns - kLate_ns ? 1U : 0U;
  return buffers.add(protocol::frame_of(record), record.start_ns);
}

void BusServer::Client::flush() {
  std::size_t sent = 0;
  while (!gone && sent < outgoing.size()) {
    const std::size_t count = std::min(outgoing.size() - sent, protocol::kRecordsAPacket);
    if (send(socket.get(), outgoing.data() + sent, count * sizeof(Record), MSG_NOSIGNAL) < 0) {
      gone = errno != EAGAIN && errno != EWOULDBLOCK;
      break;  // a full socket: it goes out with the next flush
    }
    sent += count;
  }
  outgoing.erase(outgoing.begin(), outgoing.begin() + static_cast<std::ptrdiff_t>(sent));
}

BusServer::BusServer(std::filesystem::path socket, std::int64_t start_ns)
    : listener_(std::move(socket), "bus"), time_ns_(start_ns) {}

BusServer::~BusServer() = default;

void BusServer::step() {
  bus_.detach_sent(leaving_stations_);
  while (true) {
    process::FileDescriptor connection = listener_.accept();
    if (!connection) {
      break;  // nobody waits, or the system has no descriptor left and they were turned away
    }
    if (clients_.size() == kMostClients) {
      ++statistics_.refused;
      continue;
    }
    listener_.watch(connection);
    clients_.emplace_back(std::move(connection), bus_.attach());
    ++statistics_.clients;
  }
  for (auto client = clients_.begin(); client != clients_.end();) {
    const auto next = std::next(client);
    if (!serve(*client)) {
      leaving_stations_.push_back(client->transmitter.station());
      clients_.erase(client);
    }
    client = next;
  }
  bus_.detach_sent(leaving_stations_);
}

bool BusServer::serve(Client& client) {
  protocol::Packet packet;
  for (int i = 0; i < kPacketsAStep && !client.gone; ++i) {
    const ssize_t bytes = recv(client.socket.get(), packet.data(), sizeof packet, 0);
    if (bytes < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
      return true;
    }
    if (bytes <= 0) {
      return false;
    }
    const auto size = static_cast<std::size_t>(bytes);
    bool whole = size % sizeof(Record) == 0;
    for (std::size_t record = 0; whole && record < size / sizeof(Record); ++record) {
      whole = client.take(packet[record], time_ns_, statistics_);
    }
    if (!whole) {
      ++statistics_.broken;
      return false;
    }
  }
  statistics_.not_reading += client.outgoing.size() == kLongestBacklog ? 1U : 0U;
  return !client.gone;
}

std::optional<SimulatedBus::Delivery> BusServer::advance(std::int64_t until_ns) {
  while (true) {
    offer();
    std::int64_t stop_ns = until_ns;
    for (const Client& client : clients_) {
      stop_ns = std::min(stop_ns, client.buffers.next_release_ns());
    }
    const auto delivery = bus_.advance(stop_ns);
    while (const auto error = bus_.next_error_frame()) {
      hand_to_clients(*error);
    }
    if (delivery) {
      time_ns_ = std::max(time_ns_, delivery->end_ns);
      hand_to_clients(*delivery);
      return delivery;
    }
    time_ns_ = std::max(time_ns_, stop_ns);
    if (stop_ns >= until_ns) {
      return std::nullopt;
    }
  }
}

void BusServer::offer() {
  for (Client& client : clients_) {
    client.buffers.run_to(time_ns_);
    client.transmitter.offer(bus_, client.buffers, time_ns_);
  }
}

void BusServer::hand_to_clients(const SimulatedBus::Delivery& delivery) {
  for (Client& client : clients_) {
    const int station = client.transmitter.station();
    const bool own = delivery.sent_by(station);
    if (own) {
      client.transmitter.on_delivery(delivery);
      --client.waiting;
    } else if (!delivery.received_by(station)) {
      continue;
    }
    client.hand(protocol::record_of(own ? Kind::sent : Kind::delivery, delivery.frame, delivery.start_ns,
                                    delivery.end_ns));
  }
}

// Every station that follows the bus sees it.
void BusServer::hand_to_clients(const ErrorFrame& error) {
  for (Client& client : clients_) {
    client.hand(protocol::record_of(Kind::error, {}, error.error_ns, error.error_ns));
  }
}

void BusServer::flush() {
  for (Client& client : clients_) {
    if (client.paced && client.told_ns < time_ns_) {
      client.told_ns = time_ns_;
      client.hand_mark(time_ns_);
    }
    client.flush();
  }
}

bool BusServer::reached(std::int64_t time_ns) const noexcept {
  return std::ranges::all_of(clients_, [time_ns](const Client& client) {
    return !client.paced || !client.started || client.reached_ns >= time_ns;
  });
}

}  // namespace gaitway::can

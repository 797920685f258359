// The bus socket (can/simulated/bus_protocol.hpp) as BusServer reads it, through a real socket: clients that
// send any packets beside one that keeps to the protocol. Whatever they send: the server goes on, what it
// delivers are valid frames in the order of time, and once they have gone, the decent client's frame is sent
// at once.
#include <array>
#include <cstdint>
#include <cstring>
#include <list>
#include <span>
#include <vector>

#include "can/simulated/bus_protocol.hpp"
#include "fuzz_frame.hpp"
#include "gaitway/can/simulated/bus_client.hpp"
#include "gaitway/can/simulated/bus_server.hpp"
#include "socket_place.hpp"

namespace gaitway::fuzz {
namespace {

using can::protocol::Kind;
using can::protocol::Record;

constexpr std::size_t kMostClients = 4;
constexpr std::int64_t kTwoFrames_ns = 400'000;

std::vector<std::byte> bytes_of(const Record& record) {
  std::vector<std::byte> bytes(sizeof record);
  std::memcpy(bytes.data(), &record, sizeof record);
  return bytes;
}

Record take_record(Input& input) {
  Record record = can::protocol::record_of(static_cast<Kind>(1 + input.choose(6)), take_frame(input), 0);
  record.flag = input.take<std::uint8_t>();
  const auto when = input.take<std::uint8_t>();
  record.start_ns = (when & 1U) != 0 ? input.take<std::int64_t>() : std::int64_t{when} * 100'000;
  return record;
}

class Bus {
 public:
  explicit Bus(const std::filesystem::path& path)
      : path_(path), server_(path, 0), decent_(path, "decent", can::Pace::free) {
    server_.bus().attach();  // somebody has to acknowledge
    server_.step();
  }

  void connect(bool greets) {
    if (intruders_.size() < kMostClients) {
      intruders_.emplace_back(path_);
      server_.step();  // else those that wait for it fill its backlog
      if (greets) {
        intruders_.back().send(
            bytes_of(Record{.kind = Kind::hello, .flag = 1, .start_ns = can::protocol::kMagic}));
      }
    }
  }
  void send(std::size_t client, std::span<const std::byte> packet) {
    if (!intruders_.empty()) {
      at(client).send(packet);
    }
  }
  void disconnect(std::size_t client) {
    if (!intruders_.empty()) {
      const auto gone =
          std::next(intruders_.begin(), static_cast<std::ptrdiff_t>(client % intruders_.size()));
      intruders_.erase(gone);
    }
  }

  void run(std::int64_t duration_ns) {
    server_.step();
    now_ns_ += duration_ns;
    while (const auto delivery = server_.advance(now_ns_)) {
      require(can::is_valid(delivery->frame), "what is delivered is a frame");
      require(delivery->start_ns >= busy_until_ns_ && delivery->end_ns > delivery->start_ns &&
                  delivery->end_ns <= now_ns_,
              "one frame after the other is on the bus");
      busy_until_ns_ = delivery->end_ns;
    }
    server_.flush();
    for (const BareClient& intruder : intruders_) {
      intruder.drain();
    }
  }

  void check_that_it_goes_on() {
    intruders_.clear();
    server_.step();
    require(server_.client_count() == 1, "who has gone is no client any more");
    require(server_.statistics().broken <= server_.statistics().clients, "each client breaks at most once");
    const can::Frame frame{.id = 0x7FF, .size = 1, .data = {42}};
    require(decent_.transmit(frame, now_ns_), "the decent client may send");
    decent_.flush(now_ns_);
    run(kTwoFrames_ns);  // one may be on the wire yet
    while (decent_.receive()) {
    }
    require(!decent_.closed(), "the decent client stays connected");
    require(!decent_.transmit_pending(), "the decent client's frame is sent when the bus is free");
  }

 private:
  BareClient& at(std::size_t client) {
    return *std::next(intruders_.begin(), static_cast<std::ptrdiff_t>(client % intruders_.size()));
  }

  std::filesystem::path path_;
  can::BusServer server_;
  can::BusClient decent_;
  std::list<BareClient> intruders_;
  std::int64_t now_ns_ = 0, busy_until_ns_ = 0;
};

void send_records(Bus& bus, Input& input) {
  const std::size_t client = input.choose(kMostClients);
  std::vector<std::byte> packet;
  for (std::size_t records = 1 + input.choose(8); records > 0; --records) {
    const std::vector<std::byte> record = bytes_of(take_record(input));
    packet.insert(packet.end(), record.begin(), record.end());
  }
  bus.send(client, packet);
}

}  // namespace

void bus_socket(std::span<const std::uint8_t> bytes) {
  static const SocketPlace place;
  Input input(bytes);
  Bus bus(place.path());
  constexpr int kMostActions = 200;
  for (int action = 0; action < kMostActions && !input.empty(); ++action) {
    switch (input.choose(6)) {
      case 0:
        bus.connect(input.flag());
        break;
      case 1:
        bus.send(input.choose(kMostClients), std::as_bytes(input.take_bytes(input.take<std::uint8_t>())));
        break;
      case 2:
        bus.disconnect(input.choose(kMostClients));
        break;
      case 3:
        bus.run(std::int64_t{input.take<std::uint8_t>()} * 10'000);
        break;
      default:
        send_records(bus, input);
    }
  }
  bus.check_that_it_goes_on();
}

}  // namespace gaitway::fuzz

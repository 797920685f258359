// The control channel of a simulation (simulator/control/) as ControlServer reads it, through a real socket:
// clients that send any packets beside one that keeps to the protocol. Whatever they send: what is carried
// out keeps to the rules, no step does more than its part, and once they have gone the decent client is
// answered at once.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <list>
#include <span>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/simulation/control_client.hpp"
#include "gaitway/simulation/control_server.hpp"
#include "socket_place.hpp"

namespace gaitway::fuzz {
namespace {

using namespace simulation;

constexpr std::size_t kIntruders = ControlServer::kMostClients + 2;

template <class Packet>
Packet packet_of(std::span<const std::uint8_t> bytes) {
  Packet packet{};
  std::ranges::copy(std::as_bytes(bytes), packet.begin());
  return packet;
}

void check_codecs(std::span<const std::uint8_t> bytes) {
  const auto packet = packet_of<RequestPacket>(bytes.first(std::min(bytes.size(), kRequestBytes)));
  if (const auto request = decode_request(packet)) {
    require(encode(*request) == packet, "a request that decodes encodes to the same bytes");
  }
  const auto answer_packet = packet_of<AnswerPacket>(bytes.first(std::min(bytes.size(), kAnswerBytes)));
  if (const auto answer = decode_answer(answer_packet)) {
    require(encode(*answer) == answer_packet, "an answer that decodes encodes to the same bytes");
  }
}

class Simulator {
 public:
  explicit Simulator(const std::filesystem::path& path)
      : path_(path), server_(path, [this](const Push& push) { take(push); }), decent_(path) {
    step();
    step();
  }

  void connect() {
    if (intruders_.size() < kIntruders) {
      intruders_.emplace_back(path_);
      step();
    }
  }
  void send(std::size_t client, std::span<const std::byte> packet) {
    if (!intruders_.empty()) {
      at(client)->send(packet);
    }
  }
  void disconnect(std::size_t client) {
    if (!intruders_.empty()) {
      intruders_.erase(at(client));
    }
  }
  void step() {
    now_ns_ += facts::kMillisecond_ns;
    const std::size_t before = pushes_;
    server_.step();
    require(pushes_ <= before + ControlServer::kRequestsAStep, "a step carries out its part at most");
    require(server_.client_count() <= ControlServer::kMostClients, "so many clients at most");
    decent_.step(now_ns_);
  }
  void check_that_it_goes_on() {
    intruders_.clear();
    for (std::size_t i = 0; i < 2 * kIntruders + 60; ++i) {  // which is longer than the client's pause
      step();
    }
    require(server_.client_count() == 1, "who has gone is no client any more");
    while (decent_.take_answer()) {
    }
    decent_.push({.link = "trunk", .force_N = {1.0, 0.0, 0.0}, .duration_s = 0.1}, now_ns_);
    step();
    const auto answer = decent_.take_answer();
    require(answer && answer->accepted, "the decent client is answered at once");
  }

 private:
  void take(const Push& push) {
    require(objection(push).empty(), "what is carried out keeps to the rules");
    ++pushes_;
  }
  std::list<BareClient>::iterator at(std::size_t client) {
    return std::next(intruders_.begin(), static_cast<std::ptrdiff_t>(client % intruders_.size()));
  }

  std::filesystem::path path_;
  ControlServer server_;
  ControlClient decent_;
  std::list<BareClient> intruders_;
  std::size_t pushes_ = 0;
  std::int64_t now_ns_ = 0;
};

// A request whose head is right, and whose body is anything.
RequestPacket take_request(Input& input) {
  Request request;
  request.version = input.flag() ? kControlVersion : input.take<std::uint16_t>();
  request.kind = input.flag() ? 1 : input.take<std::uint16_t>();
  request.number = input.take<std::uint32_t>();
  std::ranges::copy(std::as_bytes(input.take_bytes(request.body.size())), request.body.begin());
  return encode(request);
}

}  // namespace

void simulation_requests(std::span<const std::uint8_t> bytes) {
  static const SocketPlace place;
  check_codecs(bytes);
  Input input(bytes);
  Simulator simulator(place.path());
  constexpr int kMostActions = 100;
  for (int action = 0; action < kMostActions && !input.empty(); ++action) {
    const std::size_t client = input.choose(kIntruders);
    switch (input.choose(5)) {
      case 0:
        simulator.connect();
        break;
      case 1:
        simulator.send(client, std::as_bytes(input.take_bytes(input.take<std::uint8_t>())));
        break;
      case 2:
        simulator.disconnect(client);
        break;
      case 3:
        simulator.step();
        break;
      default:
        simulator.send(client, take_request(input));
    }
  }
  simulator.check_that_it_goes_on();
}

}  // namespace gaitway::fuzz

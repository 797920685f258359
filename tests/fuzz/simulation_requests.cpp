// The control channel of a simulation (simulator/control/) as ControlServer reads it, through a real socket:
// clients that send any packets beside one that keeps to the protocol. Whatever they send: what is carried
// out keeps to the rules, no step does more than its part, and once they have gone the decent client is
// answered at once.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <list>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/simulation/control_client.hpp"
#include "gaitway/simulation/control_server.hpp"
#include "socket_place.hpp"

namespace gaitway::fuzz {
namespace {

using namespace simulation;

constexpr std::size_t kIntruders = ControlServer::kMostClients + 2;

void check_codecs(std::span<const std::uint8_t> bytes) {
  const auto packet = std::as_bytes(bytes);
  if (const auto request = decode_request(packet)) {
    require(std::ranges::equal(encode(*request), packet), "a request that decodes encodes to the same bytes");
  }
  if (const auto answer = decode_answer(packet)) {
    require(std::ranges::equal(encode(*answer), packet), "an answer that decodes encodes to the same bytes");
  }
}

class Simulator {
 public:
  explicit Simulator(const std::filesystem::path& path)
      : path_(path),
        server_(
            path,
            [this](const Ticket&, const Push& push) {
              take(push);
              return true;
            },
            [this](const Ticket& ticket, std::string_view order) { return take(ticket, order); }),
        decent_(path) {
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
  // An order that was left open is done, or is not; whoever gave it.
  void answer(std::size_t which, bool accepted) {
    if (!open_.empty()) {
      const auto ticket = open_.begin() + static_cast<std::ptrdiff_t>(which % open_.size());
      server_.answer(*ticket, accepted, accepted ? "{}" : "it cannot be done");
      open_.erase(ticket);
    }
  }
  void step() {
    now_ns_ += facts::kMillisecond_ns;
    const std::size_t before = carried_out_;
    server_.step();
    require(carried_out_ <= before + ControlServer::kRequestsAStep, "a step carries out its part at most");
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
    const auto pushed = decent_.take_answer();
    require(pushed && pushed->accepted, "the decent client is answered at once");
    decent_.order("\x02", now_ns_, facts::kSecond_ns);
    step();
    const auto ordered = decent_.take_answer();
    require(ordered && ordered->accepted && ordered->text == "{}", "and so are its orders");
  }

 private:
  void take(const Push& push) {
    require(objection(push).empty(), "what is carried out keeps to the rules");
    ++carried_out_;
  }
  // What an order means nobody knows here: its first byte says whether it is answered, refused or left open.
  std::optional<std::string> take(const Ticket& ticket, std::string_view order) {
    require(objection_to_order(order).empty(), "what is carried out keeps to the rules");
    require(std::ranges::find(open_, ticket) == open_.end(), "an open ticket is given once");
    ++carried_out_;
    switch (static_cast<unsigned char>(order.front()) % 4) {
      case 0:
        throw std::invalid_argument("there is no such order");
      case 1:
        return std::string(kMostTextBytes + order.size() % 2, 'x');
      case 2:
        return "{}";
      default:
        open_.push_back(ticket);
        return std::nullopt;
    }
  }
  std::list<BareClient>::iterator at(std::size_t client) {
    return std::next(intruders_.begin(), static_cast<std::ptrdiff_t>(client % intruders_.size()));
  }

  std::filesystem::path path_;
  ControlServer server_;
  ControlClient decent_;
  std::list<BareClient> intruders_;
  std::vector<Ticket> open_;
  std::size_t carried_out_ = 0;  // pushes and orders
  std::int64_t now_ns_ = 0;
};

// A request whose head is right, and whose body is anything.
Packet take_request(Input& input) {
  Request request;
  request.version = input.flag() ? kControlVersion : input.take<std::uint16_t>();
  request.kind = input.flag() ? static_cast<std::uint16_t>(1 + input.choose(2)) : input.take<std::uint16_t>();
  request.number = input.take<std::uint32_t>();
  const std::size_t size = request.kind == static_cast<std::uint16_t>(RequestKind::push)
                               ? kPushBytes
                               : input.take<std::uint16_t>() % (kMostBodyBytes + 1);
  const auto body = std::as_bytes(input.take_bytes(size));
  request.body.assign(body.begin(), body.end());
  request.body.resize(size);
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
    switch (input.choose(6)) {
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
      case 4:
        simulator.answer(input.take<std::uint8_t>(), input.flag());
        break;
      default:
        simulator.send(client, take_request(input));
    }
  }
  simulator.check_that_it_goes_on();
}

}  // namespace gaitway::fuzz

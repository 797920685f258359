// A stop is dated by the desk's own clock: the stamp of a welcome. So a client needs no place before its
// first stop, and a recording of greetings wins nothing.
#include "gaitway/stopgram/stop_desk.hpp"

#include <algorithm>

namespace gaitway::stopgram {
namespace {

constexpr std::array kCounts{&link::StopCounts::stops, &link::StopCounts::holds, &link::StopCounts::softs};

}  // namespace

Bytes StopDesk::on_datagram(Bytes datagram, const Peer& peer, std::int64_t now_ns) noexcept {
  now_ns_ = std::max(now_ns_, now_ns);
  const std::optional<std::uint8_t> version = version_of(datagram);
  if (!version || *version != kProtocolVersion) {
    refusals_.note(version ? Refusal::other_version : Refusal::foreign, peer, now_ns_);
    return {};
  }
  if (datagram.size() != kGreetingBytes && datagram.size() != kStopBytes) {
    refusals_.note(Refusal::foreign, peer, now_ns_);
    return {};
  }
  if (!key_.has_signed(datagram)) {
    refusals_.note(Refusal::forged, peer, now_ns_);
    return {};
  }
  const Bytes content = datagram.first(datagram.size() - kMacBytes);
  Greeting greeting;
  Stop stop;
  if (decode(content, greeting)) {
    return welcome(greeting);
  }
  if (decode(content, stop)) {
    return on_stop(stop);
  }
  refusals_.note(Refusal::misplaced, peer, now_ns_);
  return {};
}

Bytes StopDesk::welcome(const Greeting& greeting) noexcept {
  ++counts_.greetings;
  return signed_datagram(key_, Welcome{greeting.client, greeting.number, epoch_, now_ns_}, answer_);
}

Bytes StopDesk::on_stop(const Stop& stop) noexcept {
  if (stop.epoch != epoch_ || stop.stamp_ns > now_ns_) {
    return stranger(stop);
  }
  const auto kind = static_cast<std::size_t>(stop.kind);
  const bool is_fresh = now_ns_ - stop.stamp_ns <= kFreshness_ns;
  Client* client = find(stop.client);
  // What has been taken is answered however old its stamp is.
  if (client != nullptr && stop.number <= client->latest[kind].number) {
    if (stop.number < client->latest[kind].number) {
      ++counts_.replays;
      return {};
    }
    ++counts_.repeats;
    if (is_fresh) {  // an old one may be of a recording, which holds nobody's place
      client->heard_ns = now_ns_;
    }
    client->newest_stamp_ns = std::max(client->newest_stamp_ns, stop.stamp_ns);
    return acknowledge(stop, client->latest[kind]);
  }
  if (!is_fresh || stop.stamp_ns <= (client != nullptr ? client->floor_ns : floor_ns_)) {
    return stranger(stop);
  }
  if (client == nullptr) {
    client = &make_place();
    client->used = true;
    client->id = stop.client;
    client->floor_ns = floor_ns_;
  }
  ++counts_.stops;
  client->heard_ns = now_ns_;
  client->newest_stamp_ns = std::max(client->newest_stamp_ns, stop.stamp_ns);
  Latest& latest = client->latest[kind];
  waiting_ += latest.waits ? 0 : 1;  // one that nobody has fetched yet stands for both
  latest = {.number = stop.number, .waits = true};
  return acknowledge(stop, latest);
}

std::optional<StopRequest> StopDesk::next_stop(const link::StopCounts& asked) noexcept {
  if (waiting_ == 0) {
    return std::nullopt;
  }
  for (std::size_t kind = kStopKinds; kind-- > 0;) {  // what stops most first
    for (Client& client : clients_) {
      Latest& latest = client.latest[kind];
      if (latest.waits) {
        latest.waits = false;
        --waiting_;
        latest.count = asked.*kCounts[kind] + 1;
        return StopRequest{static_cast<StopKind>(kind), client.id, latest.number};
      }
    }
  }
  return std::nullopt;
}

Bytes StopDesk::acknowledge(const Stop& stop, const Latest& latest) noexcept {
  const std::uint32_t obeyed = obeyed_.*kCounts[static_cast<std::size_t>(stop.kind)];
  const bool is_obeyed =  // counts go round
      !latest.waits && static_cast<std::int32_t>(obeyed - latest.count) >= 0;
  return signed_datagram(key_, Ack{stop.client, stop.number, stop.kind, is_obeyed}, answer_);
}

Bytes StopDesk::stranger(const Stop& stop) noexcept {
  ++counts_.strangers;
  return signed_datagram(key_, Stranger{stop.client, stop.epoch, stop.stamp_ns}, answer_);
}

StopDesk::Client* StopDesk::find(std::uint64_t id) noexcept {
  const auto found =
      std::ranges::find_if(clients_, [id](const Client& each) { return each.used && each.id == id; });
  return found == clients_.end() ? nullptr : &*found;
}

// The caller fetches stops after each datagram, so of a client that gives way none waits.
StopDesk::Client& StopDesk::make_place() noexcept {
  Client& place = *std::ranges::min_element(
      clients_, {}, [](const Client& each) { return each.used ? each.heard_ns : std::int64_t{-1}; });
  for (const Latest& latest : place.latest) {
    waiting_ -= latest.waits ? 1 : 0;
  }
  floor_ns_ = std::max(floor_ns_, place.newest_stamp_ns);
  place = {};
  return place;
}

}  // namespace gaitway::stopgram

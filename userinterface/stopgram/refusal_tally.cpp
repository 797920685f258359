// An address keeps its place until what it did is told and ten seconds have passed.
#include "gaitway/stopgram/refusal_tally.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace gaitway::stopgram {
namespace {

std::string_view reason(Refusal cause) {
  switch (cause) {
    case Refusal::foreign:
      return "what is no stop datagram";
    case Refusal::other_version:
      return "a stop datagram of another version: client and robot need the same version of Gaitway";
    case Refusal::forged:
      return "a stop datagram with a wrong code: another token than the robot's, or a forgery";
    default:
      return "a stop datagram that no client sends";
  }
}

std::string address_text(const Peer& peer) {
  in6_addr address{};
  std::ranges::copy(peer.address, address.s6_addr);
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (IN6_IS_ADDR_V4MAPPED(&address)) {
    inet_ntop(AF_INET, peer.address.data() + 12, text.data(), text.size());
    return text.data();
  }
  inet_ntop(AF_INET6, &address, text.data(), text.size());
  return "[" + std::string(text.data()) + (peer.scope != 0 ? "%" + std::to_string(peer.scope) : "") + "]";
}

}  // namespace

std::string text_of(const Peer& peer) {
  return address_text(peer) + ":" + std::to_string(peer.port);
}

void RefusalTally::note(Refusal cause, const Peer& peer, std::int64_t now_ns) noexcept {
  ++counts_[static_cast<std::size_t>(cause)];
  Entry& entry = entry_of(peer, now_ns);
  ++entry.count;
  entry.latest = peer;
  entry.cause = cause;
}

RefusalTally::Entry& RefusalTally::entry_of(const Peer& peer, std::int64_t now_ns) noexcept {
  Entry* free = &entries_.back();
  for (Entry& entry : std::span(entries_).first(kAddresses)) {
    const bool is_used = entry.count != 0 || entry.rests(now_ns);
    if (is_used && entry.latest.address == peer.address) {
      return entry;
    }
    if (!is_used) {
      free = &entry;
    }
  }
  if (free != &entries_.back()) {
    free->told_ns.reset();
  }
  return *free;
}

std::optional<std::string> RefusalTally::take(std::int64_t now_ns) {
  for (Entry& entry : entries_) {
    if (entry.count == 0 || entry.rests(now_ns)) {
      continue;
    }
    entry.told_ns = now_ns;
    const std::uint64_t count = std::exchange(entry.count, 0);
    const bool is_rest = &entry == &entries_.back();
    return "refused " + std::string(reason(entry.cause)) + ": from " + text_of(entry.latest) +
           (count > 1 ? ", the latest of " + std::to_string(count) : "") +
           (is_rest ? " from further addresses" : "");
  }
  return std::nullopt;
}

}  // namespace gaitway::stopgram

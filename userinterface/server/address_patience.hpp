// How long who was refused has to wait for being told so: the longer, the more often its address was. And
// what counts as one address.
#pragma once

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

namespace gaitway::api {

// An IPv4 address, and of IPv6 the /64: a computer takes as many addresses of its own as it likes.
[[nodiscard]] inline boost::asio::ip::address counted_address(const boost::asio::ip::address& address) {
  constexpr std::ptrdiff_t kNetworkBytes = 8;
  if (!address.is_v6()) {
    return address;
  }
  auto bytes = address.to_v6().to_bytes();
  std::fill(bytes.begin() + kNetworkBytes, bytes.end(), std::uint8_t{0});
  return boost::asio::ip::address_v6(bytes, address.to_v6().scope_id());
}

class AddressPatience {
 public:
  static constexpr double kForgottenPerSecond = 1.0;
  static constexpr double kFreeRefusals = 3.0;
  static constexpr std::int64_t kFirstWait_ns = 50'000'000, kLongestWait_ns = 2'000'000'000;
  static constexpr std::size_t kMostAddresses = 1024;

  // Another one; how long it waits for its answer.
  [[nodiscard]] std::int64_t refused(const boost::asio::ip::address& whose, std::int64_t now_ns) {
    constexpr double kMostRemembered = 16.0;
    const boost::asio::ip::address address = counted_address(whose);
    if (refusals_.size() >= kMostAddresses && !refusals_.contains(address)) {
      forget_one();
    }
    Refusals& known = refusals_[address];
    known.count = std::min(known.at(now_ns) + 1.0, kMostRemembered);
    known.since_ns = now_ns;
    if (known.count <= kFreeRefusals) {
      return 0;
    }
    const double wait_ns = static_cast<double>(kFirstWait_ns) * std::exp2(known.count - kFreeRefusals - 1.0);
    return static_cast<std::int64_t>(std::min(wait_ns, static_cast<double>(kLongestWait_ns)));
  }
  [[nodiscard]] std::size_t addresses() const noexcept { return refusals_.size(); }

 private:
  struct Refusals {
    double count = 0.0;
    std::int64_t since_ns = 0;
    [[nodiscard]] double at(std::int64_t now_ns) const noexcept {
      return std::max(count - static_cast<double>(now_ns - since_ns) * 1e-9 * kForgottenPerSecond, 0.0);
    }
  };
  // The one that was refused longest ago.
  void forget_one() {
    refusals_.erase(
        std::ranges::min_element(refusals_, {}, [](const auto& entry) { return entry.second.since_ns; }));
  }

  std::map<boost::asio::ip::address, Refusals> refusals_;
};

}  // namespace gaitway::api

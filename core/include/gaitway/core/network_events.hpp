// What the message controller found wrong on its network, as events for people: each cause when it is new,
// and then whenever its count has doubled, so that a bad bus fills no log.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {

class NetworkEvents {
 public:
  static constexpr std::size_t kCauses = 15;

  // Calls `report(text)` for each cause that is worth an event since the last call. No allocation.
  template <class Report>
  void compare(const NetworkHealth& health, Report report) noexcept {
    for (std::size_t cause = 0; cause < kCauses; ++cause) {
      std::array<char, 160> text{};
      if (const std::size_t length = describe(cause, health, text); length > 0) {
        report(std::string_view(text.data(), length));
      }
    }
  }

 private:
  // Length of the text; 0: nothing new.
  std::size_t describe(std::size_t cause, const NetworkHealth& health, std::array<char, 160>& text) noexcept;

  std::array<std::uint64_t, kCauses> next_{};  // count at which the cause is told again; 0: not told yet
};

}  // namespace gaitway::core

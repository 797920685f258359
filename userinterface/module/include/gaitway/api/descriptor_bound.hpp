// As many descriptors for this process as its connections may take, and more.
#pragma once

#include <cstddef>

#include "gaitway/api/limits.hpp"

namespace gaitway::api {

// Descriptors that the process has open at most.
[[nodiscard]] constexpr std::size_t most_descriptors(const Limits& limits) noexcept {
  constexpr std::size_t kTurnedAway = 32;  // connections that are told that there are too many
  constexpr std::size_t kOwn = 64;         // sockets, link, recording, and what libraries open for a moment
  return limits.connections + kTurnedAway + kOwn;
}

// Otherwise those who hold all connections would keep the link and recordings from theirs. Throws
// std::runtime_error, which names the limit and the remedy, when the system does not give so many.
void provide_descriptors(const Limits& limits);

}  // namespace gaitway::api

// What a person's clock shows at an instant of the clock that all processes share.
#pragma once

#include <cstdint>
#include <string>

namespace gaitway::process {

// "2026-01-31T12:00:00.000Z": of this instant of monotonic_ns(), by the clock as it goes now.
[[nodiscard]] std::string date_and_time_of(std::int64_t monotonic_ns);

}  // namespace gaitway::process

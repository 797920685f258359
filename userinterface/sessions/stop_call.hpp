// Which message calls a stop, told before it is parsed.
#pragma once

#include <string_view>

namespace gaitway::api {

// /stop or /emergency_stop, as a client may write them.
[[nodiscard]] bool is_stop_service(std::string_view service) noexcept;

// Whether the message, as JSON, calls a stop. Short messages only: what a client puts beside its call must
// not make others wait. Most messages cost the search for one word.
[[nodiscard]] bool is_stop_call(std::string_view message) noexcept;

}  // namespace gaitway::api

// Which message calls a stop, told before it is parsed.
#pragma once

#include <string_view>

#include "gaitway/api/session.hpp"

namespace gaitway::api {

// Of /stop and /emergency_stop, as a client may write them; none of all others.
[[nodiscard]] Urgency urgency_of_service(std::string_view service) noexcept;

// Of the message, as JSON, if it calls a stop. Short messages only: what a client puts beside its call must
// not make others wait. Most messages cost the search for one word.
[[nodiscard]] Urgency urgency_of_stop_call(std::string_view message) noexcept;

}  // namespace gaitway::api

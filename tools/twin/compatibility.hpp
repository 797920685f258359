// Whether a robot's API and description are those that this program is made for, and if not, what differs.
#pragma once

#include <string>
#include <string_view>

namespace gaitway::tools {

// `server`: as the API names itself, "gaitway/0.1.0". Empty: they fit, since releases of one minor number do;
// otherwise what differs, and the remedy.
[[nodiscard]] std::string release_difference(std::string_view server, std::string_view own_release);

// Two robot descriptions (URDF). Empty: they are the same; otherwise the first line that differs, and the
// remedy.
[[nodiscard]] std::string description_difference(std::string_view there, std::string_view here);

}  // namespace gaitway::tools

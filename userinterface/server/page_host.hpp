// Whether the robot's own page may talk to it: a page has no origin that one could list beforehand, but the
// address under which it was asked for.
#pragma once

#include <string_view>

namespace gaitway::api {

// Whether `host` (of a request: with or without port) is localhost or a numeric address. Nobody can make a
// name of his own mean such a one, so a page that comes from there comes from the robot.
[[nodiscard]] bool is_numeric_host(std::string_view host);

// Whether `origin` is that of the page which the robot gives to those who ask for `host`.
[[nodiscard]] bool is_own_page(std::string_view origin, std::string_view host, bool tls);

}  // namespace gaitway::api

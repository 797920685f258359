// Who listens on a TCP port of this computer, as the system tells it.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace gaitway::tools {

// Whether this process does. Nothing: what it has open may not be looked at.
[[nodiscard]] std::optional<bool> listens(pid_t process, int port);

// "process 1234 (user_interface of the robot in /run/gaitway)"; "a program that cannot be looked at" of
// another user's; empty: nobody listens there.
[[nodiscard]] std::string describe_listener(int port);

}  // namespace gaitway::tools

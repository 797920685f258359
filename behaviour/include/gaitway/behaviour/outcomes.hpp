// What a tree can come to, as far as its structure tells.
#pragma once

#include "gaitway/behaviour/description.hpp"

namespace gaitway::behaviour {

// False: no tick of it answers success, whatever its leaves answer; a patrol is such a tree. True also where
// that hangs on values that are set while it runs.
[[nodiscard]] bool may_succeed(const Description& tree);

}  // namespace gaitway::behaviour

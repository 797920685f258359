// Puts sub-trees in where they are used: from the trees of a file to one flat description.
#pragma once

#include "definitions.hpp"
#include "gaitway/behaviour/description.hpp"

namespace gaitway::behaviour {

// Complains about sub-trees that contain themselves, and about a tree that becomes too large or too deep;
// then, and where entries and ports do not agree, the description is not to be used.
[[nodiscard]] Description expand(const Definitions& definitions, Complaints& complaints);

}  // namespace gaitway::behaviour

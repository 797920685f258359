// Whether a DAE may be given to a reader that calls itself for each level of its nodes.
#pragma once

#include <string_view>

namespace gaitway::importer {

// Throws std::runtime_error with the reason for elements, or instances of nodes, that are nested deeper or
// are more than any robot needs, for nodes that hold themselves, and for text of which this cannot be told.
void check_dae(std::string_view text);

}  // namespace gaitway::importer

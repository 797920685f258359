// The view's frame as bytes, and the texts that describe it.
#pragma once

#include <string>

#include "gaitway/page/view_layout.hpp"

namespace gaitway::page {

// Numbers beyond a row's range are its ends. What is not known is the lowest number of a signed type, and the
// highest of an unsigned one.
[[nodiscard]] std::string encode_view(const ViewState& state);

[[nodiscard]] std::string view_reference();  // docs/view.md
[[nodiscard]] std::string view_layout_ts();  // userinterface/web/src/view_layout.ts

// A frame whose every row holds something else, and what a decoder has to find in it (JSON):
// userinterface/web/test/view_golden.json.
[[nodiscard]] std::string view_golden();

}  // namespace gaitway::page

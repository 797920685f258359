// Which known name somebody probably meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gaitway::core {

// "Did you mean 'x'?" for the candidate with the fewest edits, if at most half of the characters differ;
// otherwise "Known here: a, b, c.", or "There is none." without any candidate.
[[nodiscard]] std::string suggest(std::string_view name, std::span<const std::string> candidates);

}  // namespace gaitway::core

// Which known name somebody probably meant.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gaitway::input {

// Edits (insert, remove, replace one character, swap two neighbours) between two names.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidate with the fewest edits, if at most half of the name's characters differ; nothing otherwise.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> candidates);

// "Did you mean 'x'?", or "Known here: a, b, c." where nothing is near, or "There is none." without
// candidates.
[[nodiscard]] std::string suggest(std::string_view name, std::span<const std::string> candidates);

}  // namespace gaitway::input

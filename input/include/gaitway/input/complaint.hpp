// One shape for every complaint about what people write: file, line, field, value, rule, remedy; and which
// known name somebody probably meant.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gaitway::input {

// What is wrong with a file or a value that somebody wrote.
class InputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Complaint {
  std::filesystem::path file;
  int line = 0;        // 1 is the first; 0: not known
  std::string field;   // e.g. "joints[3].node" or "joint 'left_knee' limit lower"
  std::string value;   // as written; empty: there is none
  std::string rule;    // what must hold, e.g. "must be 1..64"
  std::string remedy;  // what to do about it
};

// "file:line: field = value: rule. remedy", as a terminal may show it.
[[nodiscard]] std::string in_words(const Complaint& complaint);

// Throws InputError with that text.
[[noreturn]] void refuse(const Complaint& complaint);

// Edits (insert, remove, replace one character, swap two neighbours) between two names.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidate with the fewest edits, if at most half of the name's characters differ; nothing otherwise.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> candidates);

// "Did you mean 'x'?", or "Known here: a, b, c." where nothing is near, or "There is none." without
// candidates.
[[nodiscard]] std::string suggest(std::string_view name, std::span<const std::string> candidates);

}  // namespace gaitway::input

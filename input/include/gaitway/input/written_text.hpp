// Text that comes from outside as it is written into files.
#pragma once

#include <string>
#include <string_view>

namespace gaitway::input {

// terminal_text() with newlines and tabs as \x0A and \x09, too: for a comment, or a name in a list.
[[nodiscard]] std::string one_line(std::string_view text);

// Text as YAML reads it back, in quotes where it must be: what is no letter followed by letters, digits and
// `also_plain`, and YAML's words for nothing and truth.
[[nodiscard]] std::string yaml_text(std::string_view text, std::string_view also_plain = "_");

}  // namespace gaitway::input

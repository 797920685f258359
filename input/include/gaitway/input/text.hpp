// Text that comes from outside: read from files, up to a size, and made safe for the terminal.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace gaitway::input {

// Far above what anybody writes by hand, far below what takes noticeable time to read.
inline constexpr std::size_t kLargestWrittenFile_bytes = std::size_t{4} << 20U;

// The whole file. Throws InputError with `remedy` when it is missing, a folder or not readable, and with its
// name and the limit when it is larger.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file, const std::string& remedy,
                                         std::size_t largest_bytes = kLargestWrittenFile_bytes);

// Text with what a terminal would obey, or cannot show, as \x1B or \u202E: control characters other than
// newline and tab, what changes the direction of writing, and what is not UTF-8.
[[nodiscard]] std::string terminal_text(std::string_view text);

}  // namespace gaitway::input

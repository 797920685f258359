// Writes a whole text file, or says why it could not.
#pragma once

#include <filesystem>
#include <string_view>

namespace gaitway::process {

// Throws std::runtime_error that names the file and the reason when it cannot be written to its end.
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace gaitway::process

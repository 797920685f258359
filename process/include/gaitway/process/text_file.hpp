// Writes a whole text file, or says why it could not; and one that is never seen half-written.
#pragma once

#include <filesystem>
#include <string_view>

namespace gaitway::process {

// Throws std::runtime_error that names the file and the reason when it cannot be written to its end.
void write_text_file(const std::filesystem::path& path, std::string_view text);

// The same for a file that is there at every instant, as it was or as it will be, whoever is killed or
// whatever disk is full meanwhile: written beside it, brought to the disk, and put into its place. What is no
// file (a device, a pipe) is written as above.
void replace_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace gaitway::process

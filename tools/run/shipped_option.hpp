// An option that takes a file, or the name of a shipped one.
#pragma once

#include <filesystem>
#include <string>

namespace gaitway::tools {

// What is no file and has no folder before it is looked for in that directory, also without its `.yaml`.
// Throws input::InputError where it is not there either.
[[nodiscard]] std::filesystem::path file_or_shipped(const std::string& option,
                                                    const std::filesystem::path& given,
                                                    const std::filesystem::path& directory);

// Of --config.
[[nodiscard]] std::filesystem::path configuration_file(const std::filesystem::path& given);

}  // namespace gaitway::tools

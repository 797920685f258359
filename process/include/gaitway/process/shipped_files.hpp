// Files that come with the installation and go by their names: scenarios, worlds, missions.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gaitway::process {

// Without the extension (".yaml"), in alphabetical order.
[[nodiscard]] std::vector<std::string> shipped_names(const std::filesystem::path& directory,
                                                     const std::string& extension);

// The file of that name, with the extension or without it.
[[nodiscard]] std::optional<std::filesystem::path> find_shipped(const std::filesystem::path& directory,
                                                                const std::string& name,
                                                                const std::string& extension);

// There, and no folder.
[[nodiscard]] bool is_file(const std::filesystem::path& path);

}  // namespace gaitway::process

// The folder that an import writes: made beside what is there, and put in its place when all is well.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/importer/import.hpp"

namespace gaitway::tools {

class ImportFolder {
 public:
  // Throws std::invalid_argument where `place` holds what is imported, what no import wrote, or, unless it
  // may be replaced, anything.
  ImportFolder(std::filesystem::path place, const importer::ImportedRobot& imported, bool may_replace);
  // What was not put in its place is gone, and so are folders that were made for it.
  ~ImportFolder();
  ImportFolder(const ImportFolder&) = delete;
  ImportFolder& operator=(const ImportFolder&) = delete;

  // Where the new files are written.
  [[nodiscard]] const std::filesystem::path& path() const { return new_files_; }
  [[nodiscard]] const std::filesystem::path& place() const { return place_; }

  // Names of what is there and stays. Throws input::InputError where the new robot does not load with it.
  [[nodiscard]] std::vector<std::string> kept() const;

  // The new files replace those that an import wrote before.
  void take_its_place();

 private:
  void make_parents(const std::filesystem::path& folder);

  std::filesystem::path place_;
  bool is_there_ = false;
  std::vector<std::filesystem::path> made_;     // parents, the outermost first
  std::filesystem::path workshop_, new_files_;  // on the file system of `place_`
};

}  // namespace gaitway::tools

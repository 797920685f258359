// Old files go aside before new ones come in, and are deleted last.
#include "tools/robot/import_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "gaitway/input/complaint.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 5> kOwn{"robot.urdf", "robot.yaml", "import.html", "robot.png", "meshes"};
constexpr const char* kCalibration = "calibration.yaml";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool lies_in(const fs::path& folder, const fs::path& file) {
  const fs::path real = fs::weakly_canonical(file);
  return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
}

// What an import writes says so in its network file.
bool is_of_an_import(const fs::path& folder) {
  return text_of(folder / "robot.yaml").find("\n# Written from ") != std::string::npos;
}

void require_outside(const fs::path& place, const importer::ImportedRobot& imported) {
  const fs::path folder = fs::canonical(place);
  const auto require = [&](const fs::path& read) {
    if (!lies_in(folder, read)) return;
    throw std::invalid_argument(
        fmt::format("{}: {} is read from there. Give another --out", place.string(), read.string()));
  };
  require(imported.robot.file);
  for (const importer::MakerLink& link : imported.robot.links) {
    for (const importer::Surface& surface : link.collision) require(surface.source);
    for (const importer::VisualSurface& visual : link.visual) require(visual.surface.source);
  }
}

// Whether an earlier import wrote the mesh: then its URDF names it.
bool is_named(const std::string& urdf, const fs::path& mesh) {
  return urdf.find(fmt::format("\"meshes/{}\"", mesh.filename().string())) != std::string::npos;
}

}  // namespace

ImportFolder::ImportFolder(fs::path place, const importer::ImportedRobot& imported, bool may_replace)
    : place_(std::move(place)) {
  if (!place_.has_filename()) place_ = place_.parent_path();
  is_there_ = fs::exists(fs::symlink_status(place_));
  if (is_there_ && !fs::is_directory(place_))
    throw std::invalid_argument(
        fmt::format("{}: is there already, and is no folder. Give another --out", place_.string()));
  if (is_there_) {
    require_outside(place_, imported);
    if (!fs::is_empty(place_) && !is_of_an_import(place_)) {
      throw std::invalid_argument(
          fmt::format("{}: is there already, and no import wrote it. Give another --out", place_.string()));
    }
    if (!fs::is_empty(place_) && !may_replace) {
      throw std::invalid_argument(fmt::format(
          "{}: is there already. Give another --out, or --force to replace what an import writes there",
          place_.string()));
    }
  }
  const fs::path parent =
      is_there_ ? fs::canonical(place_) : fs::absolute(place_).lexically_normal().parent_path();
  make_parents(parent);
  std::string pattern = (parent / ".import-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "cannot make a folder in " + parent.string());
  workshop_ = pattern;
  new_files_ = workshop_ / "new";
  fs::create_directory(new_files_);
}

ImportFolder::~ImportFolder() {
  std::error_code ignored;
  if (!workshop_.empty()) fs::remove_all(workshop_, ignored);
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
}

void ImportFolder::make_parents(const fs::path& folder) {
  for (fs::path above = folder; !fs::exists(above); above = above.parent_path()) {
    made_.insert(made_.begin(), above);
  }
  fs::create_directories(folder);
}

std::vector<std::string> ImportFolder::kept() const {
  std::vector<std::string> names;
  if (!is_there_) return names;
  for (const auto& entry : fs::directory_iterator(place_)) {
    const std::string name = entry.path().filename().string();
    if (std::find(kOwn.begin(), kOwn.end(), name) == kOwn.end() && name != workshop_.filename())
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  if (!std::binary_search(names.begin(), names.end(), kCalibration)) return names;
  fs::copy_file(place_ / kCalibration, new_files_ / kCalibration);
  try {
    (void)urdf::load_robot(new_files_);
  } catch (const input::InputError& error) {
    std::string why = error.what();
    const std::string there = new_files_.string() + "/";
    if (why.starts_with(there)) why.erase(0, there.size());
    throw input::InputError(
        fmt::format("{}: is there and does not fit the new robot: {}. Move it away, or give another --out",
                    (place_ / kCalibration).string(), why));
  }
  fs::remove(new_files_ / kCalibration);
  return names;
}

void ImportFolder::take_its_place() {
  if (!is_there_) {
    fs::rename(new_files_, place_);
    made_.clear();
    return;
  }
  const fs::path old_files = workshop_ / "old";
  fs::create_directory(old_files);
  const auto exists = [](const fs::path& path) { return fs::exists(fs::symlink_status(path)); };
  for (const char* const name : kOwn) {
    if (exists(place_ / name)) fs::rename(place_ / name, old_files / name);
    if (exists(new_files_ / name)) fs::rename(new_files_ / name, place_ / name);
  }
  if (!fs::is_directory(old_files / "meshes")) return;
  const std::string urdf = text_of(old_files / "robot.urdf");
  for (const auto& mesh : fs::directory_iterator(old_files / "meshes")) {
    const fs::path target = place_ / "meshes" / mesh.path().filename();
    if (is_named(urdf, mesh.path()) || exists(target)) continue;
    fs::create_directories(place_ / "meshes");
    fs::rename(mesh.path(), target);
  }
}

}  // namespace gaitway::tools

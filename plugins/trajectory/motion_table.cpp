// Files: a head, then numbers and arrays in a fixed order; what is read is checked before it is used as an
// index or a size.
#include "gaitway/trajectory/motion_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <type_traits>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::trajectory {
namespace {

constexpr std::uint64_t kMagic = 0x31'4E'4F'49'54'4F'4D'47ULL;  // "GMOTION1", and the layout's number
constexpr std::uint64_t kMostElements = 1U << 24U;

[[noreturn]] void refuse(const std::filesystem::path& file, const char* why) {
  throw MotionTableError(
      fmt::format("{}: {}. Prepare it again with `gaitway motion prepare`", file.string(), why));
}

class Writer {
 public:
  explicit Writer(std::ofstream& out) : out_(out) {}
  template <class T>
  void number(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    out_.write(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Elements>
  void array(const Elements& elements) {
    number(std::uint64_t{elements.size()});
    out_.write(reinterpret_cast<const char*>(elements.data()),
               static_cast<std::streamsize>(elements.size() * sizeof *elements.data()));
  }
  void way(const MotionWay& way) {
    array(way.points);
    array(way.offset_rad);
  }

 private:
  std::ofstream& out_;
};

class Reader {
 public:
  Reader(std::vector<char> bytes, const std::filesystem::path& file)
      : bytes_(std::move(bytes)), file_(file) {}
  template <class T>
  void number(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    take(&value, sizeof value);
  }
  template <class Elements>
  void array(Elements& elements) {
    std::uint64_t size = 0;
    number(size);
    if (size > kMostElements || size * sizeof *elements.data() > bytes_.size() - at_)
      refuse(file_, "it is cut off");
    elements.resize(size);
    take(elements.data(), size * sizeof *elements.data());
  }
  void way(MotionWay& way, std::size_t joints) {
    array(way.points);
    array(way.offset_rad);
    const bool fits = !way.points.empty() && way.offset_rad.size() == way.points.size() * joints;
    const bool finite = std::ranges::all_of(way.offset_rad, [](float x) { return std::isfinite(x); });
    const bool stands = std::ranges::all_of(
        way.points, [](const MotionPoint& point) { return point.support <= kNothingStands; });
    if (!fits || !finite || !stands) refuse(file_, "its points are not those of a motion");
  }
  [[nodiscard]] bool at_end() const noexcept { return at_ == bytes_.size(); }

 private:
  void take(void* to, std::size_t size) {
    if (size > bytes_.size() - at_) refuse(file_, "it is cut off");
    if (size != 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }

  std::vector<char> bytes_;
  const std::filesystem::path& file_;
  std::size_t at_ = 0;
};

// Every exit ends within what a safe tail holds.
void require_exits(const MotionTable& table, const std::filesystem::path& file) {
  if (table.exits.size() < 2 || table.path.size() != table.batch_count() * kBatchPoints + 1) {
    refuse(file, "its path is not whole batches");
  }
  for (std::size_t b = 0; b < table.exits.size(); ++b) {
    const MotionExit& exit = table.exits[b];
    if (exit.way < -1 || exit.way >= static_cast<std::int32_t>(table.ways.size()) ||
        b + exit.go_on_batches > table.batch_count()) {
      refuse(file, "a way out leads nowhere");
    }
    if (b > 0 && table.exit_points(b) > static_cast<std::size_t>(kMaxTailPoints))
      refuse(file, "a way out is too long");
  }
  for (const MotionWay& way : table.ways) {
    if (way.size() % kBatchPoints != 0) refuse(file, "a way out is not whole batches");
  }
}

// Where a motion begins: in the stand, on the ground, or there on one side, the sides in their order.
constexpr std::uint64_t kStand = 0, kGround = 1, kFirstSide = 2;

std::uint64_t start_of(const MotionTable& table) noexcept {
  if (table.lies_on) return kFirstSide + static_cast<std::uint64_t>(*table.lies_on);
  return table.on_ground ? kGround : kStand;
}

}  // namespace

std::size_t MotionTable::exit_points(std::size_t batches) const noexcept {
  const MotionExit& exit = exits[batches];
  const std::size_t way = exit.way < 0 ? 0 : ways[static_cast<std::size_t>(exit.way)].size();
  return std::size_t{exit.go_on_batches} * kBatchPoints + way;
}

void write_motion_table(const MotionTable& table, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  Writer write(out);
  write.number(kMagic);
  write.array(table.name);
  write.array(table.description);
  write.number(table.robot_digest);
  write.number(std::uint64_t{table.joint_count});
  write.number(start_of(table));
  write.way(table.path);
  write.array(table.exits);
  write.number(std::uint64_t{table.ways.size()});
  for (const MotionWay& way : table.ways) write.way(way);
  out.flush();
  if (!out) {
    throw MotionTableError(fmt::format("{}: cannot be written. Check folder and permissions", file.string()));
  }
}

MotionTable read_motion_table(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(file, "it cannot be read");
  Reader read({std::istreambuf_iterator<char>(in), {}}, file);
  std::uint64_t magic = 0, joints = 0, start = 0, ways = 0;
  read.number(magic);
  if (magic != kMagic) refuse(file, "it is no prepared motion of this version");
  MotionTable table;
  read.array(table.name);
  read.array(table.description);
  read.number(table.robot_digest);
  read.number(joints);
  read.number(start);
  if (joints == 0 || joints > static_cast<std::uint64_t>(kMaxJoints))
    refuse(file, "its number of joints is none");
  table.joint_count = joints;
  if (start >= kFirstSide + kLyingSideNames.size()) refuse(file, "where it begins is not known");
  table.on_ground = start != kStand;
  if (start >= kFirstSide) table.lies_on = static_cast<LyingSide>(start - kFirstSide);
  read.way(table.path, joints);
  read.array(table.exits);
  read.number(ways);
  if (ways > table.exits.size()) refuse(file, "it has more ways out than batches");
  table.ways.resize(ways);
  for (MotionWay& way : table.ways) read.way(way, joints);
  if (!read.at_end()) refuse(file, "something follows its end");
  require_exits(table, file);
  return table;
}

// FNV-1a over both files.
std::uint64_t robot_digest(const std::filesystem::path& robot_directory) {
  constexpr std::uint64_t kOffset = 0xcbf29ce484222325ULL, kPrime = 0x100000001b3ULL;
  std::uint64_t digest = kOffset;
  for (const char* const name : {"robot.urdf", "robot.yaml"}) {
    std::ifstream in(robot_directory / name, std::ios::binary);
    if (!in) {
      throw MotionTableError(
          fmt::format("{}: cannot be read. Check folder and permissions", (robot_directory / name).string()));
    }
    for (std::istreambuf_iterator<char> c(in), end; c != end; ++c) {
      digest = (digest ^ static_cast<unsigned char>(*c)) * kPrime;
    }
    digest *= kPrime;
  }
  return digest;
}

std::vector<std::filesystem::path> motion_table_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == kMotionTableEnding) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace gaitway::trajectory

// One file at a time, made beneath an open folder.
#include "gaitway/api/recording_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "gaitway/api/message_definition.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

constexpr std::size_t kLongestName = 100;
constexpr mode_t kFileMode = 0640;
constexpr unsigned kAbout = STATX_TYPE | STATX_SIZE | STATX_MTIME | STATX_BTIME;

std::vector<McapChannel> channels() {
  std::vector<McapChannel> result;
  for (const TopicRow& topic : kTopics) {
    result.push_back({std::string(topic.name), std::string(topic.type), full_message_definition(topic.type),
                      topic.latched});
  }
  return result;
}

int create_file(int folder, const char* name) {
  return ::openat(folder, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kFileMode);
}

std::uint64_t free_bytes_of_disk(int folder) {
  struct statvfs about {};
  const bool known = ::fstatvfs(folder, &about) == 0;
  return known ? std::uint64_t{about.f_bavail} * about.f_frsize : std::numeric_limits<std::uint64_t>::max();
}

}  // namespace

RecordingDisk RecordingDisk::real() {
  return {create_file, free_bytes_of_disk};
}

bool is_recording_name(std::string_view name) noexcept {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
  return !name.empty() && name.size() <= kLongestName && name.front() != '.' &&
         name.find_first_not_of(kPlain) == std::string_view::npos;
}

RecordingFolder::RecordingFolder(std::filesystem::path folder, RecordingLimits limits, RecordingDisk disk)
    : folder_(std::move(folder)), limits_(limits), disk_(std::move(disk)) {
  opened_.reset(::opendir(folder_.c_str()));
  if (!opened_) {
    throw std::runtime_error(
        fmt::format("the recordings folder '{}' cannot be opened: {}; make it, or name another one",
                    folder_.string(), std::strerror(errno)));
  }
}

RecordingFolder::~RecordingFolder() {
  if (writer_) writer_->finish();
}

std::string RecordingFolder::path() const {
  return (folder_ / file_name_).string();
}

std::string RecordingFolder::start(std::string_view name) {
  if (recording()) {
    throw std::runtime_error(fmt::format("'{}' is being recorded; stop that first", file_name_));
  }
  if (!is_recording_name(name)) {
    throw std::runtime_error(fmt::format(
        "'{}' is no name for a recording: 1 to {} letters, digits, '.', '_' and '-', no '.' in front",
        name.substr(0, kLongestName), kLongestName));
  }
  if (is_full()) {
    throw std::runtime_error(fmt::format("'{}' holds {} recordings, and may hold no more: remove some",
                                         folder_.string(), limits_.files));
  }
  if (const auto lack = lack_of_room()) {
    throw std::runtime_error(fmt::format("nothing is recorded: {}; remove some recordings", *lack));
  }
  file_name_ = fmt::format("{}.mcap", name);
  const int file = disk_.create(::dirfd(opened_.get()), file_name_.c_str());
  if (file < 0) {
    throw std::runtime_error(
        errno == EEXIST ? fmt::format("there is a recording '{}' already; choose another name", path())
                        : fmt::format("'{}' cannot be made: {}", path(), std::strerror(errno)));
  }
  writer_ = std::make_unique<McapWriter>(file, channels());
  if (!writer_->error().empty()) {
    const std::string reason = writer_->error();
    writer_.reset();
    throw std::runtime_error(fmt::format("'{}' cannot be written: {}", path(), reason));
  }
  return path();
}

std::string RecordingFolder::stop() {
  if (!recording()) throw std::runtime_error("nothing is being recorded");
  const bool well = writer_->finish();
  const std::string error = writer_->error();
  writer_.reset();
  if (!well) {
    throw std::runtime_error(fmt::format(
        "the end of '{}' could not be written: {}; what is before it can be read", path(), error));
  }
  return path();
}

// Of the next recording in the folder; nullptr: there are no more.
const char* RecordingFolder::next_name() const {
  constexpr std::string_view kEnding = ".mcap";
  while (const dirent* const entry = ::readdir(opened_.get())) {
    const std::string_view name = entry->d_name;
    if (name.ends_with(kEnding) && is_recording_name(name.substr(0, name.size() - kEnding.size()))) {
      return entry->d_name;
    }
  }
  return nullptr;
}

bool RecordingFolder::is_full() const {
  ::rewinddir(opened_.get());
  std::size_t count = 0;
  while (count < limits_.files && next_name() != nullptr) ++count;
  return count == limits_.files;
}

RecordingList RecordingFolder::list(std::size_t most) const {
  RecordingList list;
  std::size_t looked_at = 0;
  ::rewinddir(opened_.get());
  while (const char* const name = next_name()) {
    if (looked_at++ == limits_.files) {
      list.complete = false;
      break;
    }
    struct statx about {};
    if (::statx(::dirfd(opened_.get()), name, AT_SYMLINK_NOFOLLOW, kAbout, &about) != 0 ||
        !S_ISREG(about.stx_mode)) {
      continue;
    }
    // Not every file system keeps when a file was made.
    const statx_timestamp& start = (about.stx_mask & STATX_BTIME) != 0 ? about.stx_btime : about.stx_mtime;
    list.newest.push_back({(folder_ / name).string(), about.stx_size,
                           start.tv_sec * facts::kSecond_ns + std::int64_t{start.tv_nsec}});
  }
  list.count = list.newest.size();
  std::ranges::sort(list.newest, [](const RecordingStatus& a, const RecordingStatus& b) {
    return std::tie(b.start_ns, a.file) < std::tie(a.start_ns, b.file);
  });
  list.newest.resize(std::min(most, list.count));
  return list;
}

std::optional<std::string> RecordingFolder::lack_of_room() const {
  constexpr std::uint64_t kMebibyte = 1 << 20;
  if (disk_.free_bytes(::dirfd(opened_.get())) >= limits_.reserve_bytes) return std::nullopt;
  return fmt::format("less than {} MiB are free on the disk of '{}'", limits_.reserve_bytes / kMebibyte,
                     folder_.string());
}

void RecordingFolder::end_without_room() {
  if (const auto lack = lack_of_room()) end(*lack);
}

void RecordingFolder::flush() {
  if (!recording()) return;
  if (!writer_->flush()) {
    end(writer_->error());
  } else {
    end_without_room();
  }
}

std::optional<std::string> RecordingFolder::take_report() {
  return std::exchange(report_, std::nullopt);
}

void RecordingFolder::end(std::string_view reason) {
  if (!recording()) return;
  const std::string why(reason);
  writer_->finish();
  const std::uint64_t messages = writer_->messages();
  writer_.reset();
  report_ = fmt::format("the recording '{}' has ended with {} messages: {}", path(), messages, why);
}

void RecordingFolder::write(Topic topic, std::string_view data, std::int64_t robot_ns) {
  constexpr std::uint64_t kAround = 64;  // of a message: its record's header and its index entry
  if (!recording()) return;
  if (writer_->size_bytes() + data.size() + kAround > limits_.file_bytes) {
    end(fmt::format("it has reached the limit of {} bytes", limits_.file_bytes));
  } else if (!writer_->write(static_cast<std::size_t>(topic), data, robot_ns, robot_ns)) {
    end(writer_->error());
  } else if (!writer_->waits()) {  // a chunk was written
    end_without_room();
  }
}

}  // namespace gaitway::api

// One file at a time, made beneath an open folder.
#include "gaitway/api/recorder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "gaitway/api/message_definition.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

constexpr std::size_t kLongestName = 100;
constexpr std::int64_t kFlushPeriod_ns = 1'000'000'000;
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

}  // namespace

bool is_recording_name(std::string_view name) noexcept {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
  return !name.empty() && name.size() <= kLongestName && name.front() != '.' &&
         name.find_first_not_of(kPlain) == std::string_view::npos;
}

Recorder::Recorder(std::filesystem::path folder, std::uint64_t limit_bytes)
    : folder_(std::move(folder)), limit_bytes_(limit_bytes) {
  opened_.reset(::opendir(folder_.c_str()));
  if (!opened_) {
    throw std::runtime_error(
        fmt::format("the recordings folder '{}' cannot be opened: {}; make it, or name another one",
                    folder_.string(), std::strerror(errno)));
  }
}

Recorder::~Recorder() {
  if (writer_) writer_->finish();
}

std::string Recorder::path() const {
  return (folder_ / file_name_).string();
}

std::string Recorder::start(std::string_view name, std::int64_t robot_ns) {
  if (recording()) {
    throw std::runtime_error(fmt::format("'{}' is being recorded; stop that first", file_name_));
  }
  if (!is_recording_name(name)) {
    throw std::runtime_error(fmt::format(
        "'{}' is no name for a recording: 1 to {} letters, digits, '.', '_' and '-', no '.' in front",
        name.substr(0, kLongestName), kLongestName));
  }
  file_name_ = fmt::format("{}.mcap", name);
  const int file = ::openat(::dirfd(opened_.get()), file_name_.c_str(),
                            O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kFileMode);
  if (file < 0) {
    throw std::runtime_error(
        errno == EEXIST ? fmt::format("there is a recording '{}' already; choose another name", path())
                        : fmt::format("'{}' cannot be made: {}", path(), std::strerror(errno)));
  }
  writer_ = std::make_unique<McapWriter>(file, channels());
  report_.reset();
  flushed_wall_ns_.reset();
  for (const TopicRow& topic : kTopics) {
    const std::string& last = latched_[static_cast<std::size_t>(topic.topic)];
    if (!last.empty() && writer_) write(topic.topic, last, robot_ns);
  }
  if (!writer_ || !writer_->error().empty()) {
    const std::string reason = report_ ? *report_ : writer_->error();
    writer_.reset();
    report_.reset();
    throw std::runtime_error(fmt::format("'{}' cannot be written: {}", path(), reason));
  }
  return path();
}

std::string Recorder::stop() {
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

RecordingList Recorder::list(std::size_t most) const {
  constexpr std::string_view kEnding = ".mcap";
  RecordingList list;
  ::rewinddir(opened_.get());
  while (const dirent* const entry = ::readdir(opened_.get())) {
    const std::string_view name = entry->d_name;
    struct statx about {};
    if (!name.ends_with(kEnding) || !is_recording_name(name.substr(0, name.size() - kEnding.size())) ||
        ::statx(::dirfd(opened_.get()), entry->d_name, AT_SYMLINK_NOFOLLOW, kAbout, &about) != 0 ||
        !S_ISREG(about.stx_mode)) {
      continue;
    }
    // Not every file system keeps when a file was made.
    const statx_timestamp& start = (about.stx_mask & STATX_BTIME) != 0 ? about.stx_btime : about.stx_mtime;
    list.newest.push_back({(folder_ / name).string(), about.stx_size,
                           start.tv_sec * facts::kSecond_ns + std::int64_t{start.tv_nsec}});
  }
  list.count = list.newest.size();
  std::sort(list.newest.begin(), list.newest.end(), [](const RecordingStatus& a, const RecordingStatus& b) {
    return std::tie(b.start_ns, a.file) < std::tie(a.start_ns, b.file);
  });
  list.newest.resize(std::min(most, list.count));
  return list;
}

void Recorder::step(std::int64_t wall_ns) {
  if (!recording()) return;
  if (!flushed_wall_ns_) flushed_wall_ns_ = wall_ns;
  if (wall_ns - *flushed_wall_ns_ < kFlushPeriod_ns) return;
  flushed_wall_ns_ = wall_ns;
  if (!writer_->flush()) end(writer_->error());
}

std::optional<std::string> Recorder::take_report() {
  return std::exchange(report_, std::nullopt);
}

void Recorder::end(std::string_view reason) {
  const std::string why(reason);
  writer_->finish();
  const std::uint64_t messages = writer_->messages();
  writer_.reset();
  report_ = fmt::format("the recording '{}' has ended with {} messages: {}", path(), messages, why);
}

void Recorder::write(Topic topic, std::string_view data, std::int64_t robot_ns) {
  constexpr std::uint64_t kAround = 64;  // of a message: its record's header and its index entry
  if (writer_->size_bytes() + data.size() + kAround > limit_bytes_) {
    end(fmt::format("it has reached the limit of {} bytes", limit_bytes_));
  } else if (!writer_->write(static_cast<std::size_t>(topic), data, robot_ns, robot_ns)) {
    end(writer_->error());
  }
}

}  // namespace gaitway::api

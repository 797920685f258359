// Writes blocks of lines, cuts off what is not whole, and begins the next file when one is full.
#include "gaitway/process/log_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace gaitway::process {
namespace {

constexpr mode_t kMode = 0644;

// A file beyond the process's limit of file sizes is an error of write(), like a full disk, and no reason to
// die of its signal.
void let_the_size_limit_be_an_error() noexcept {
  struct sigaction now {};
  if (sigaction(SIGXFSZ, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) {
    now.sa_handler = SIG_IGN;
    sigaction(SIGXFSZ, &now, nullptr);
  }
}

std::uint64_t count_lines(std::string_view text) noexcept {
  return static_cast<std::uint64_t>(std::ranges::count(text, '\n'));
}

// Of all up to and with the last end of a line.
std::uint64_t whole_bytes(int file, std::uint64_t size_bytes) noexcept {
  std::array<char, 4096> piece{};
  while (size_bytes > 0) {
    const std::uint64_t from = size_bytes - std::min<std::uint64_t>(size_bytes, piece.size());
    const ssize_t count = pread(file, piece.data(), size_bytes - from, static_cast<off_t>(from));
    if (count <= 0) return size_bytes;
    const std::string_view read(piece.data(), static_cast<std::size_t>(count));
    if (const std::size_t end = read.rfind('\n'); end != std::string_view::npos) return from + end + 1;
    size_bytes = from;
  }
  return 0;
}

[[noreturn]] void refuse(const std::string& name, const std::string& reason, const char* remedy) {
  throw std::runtime_error(name + ": " + reason + "; " + remedy);
}

}  // namespace

LogFile::LogFile(std::filesystem::path file, LogOptions options)
    : name_(file.string()), options_(std::move(options)) {
  let_the_size_limit_be_an_error();
  open(file, options_.start);
  std::error_code none;
  std::filesystem::remove(name_ + ".new", none);  // of one that was killed while it began a file
  static_cast<void>(has_head());
}

LogFile::LogFile(int descriptor, std::string name) : name_(std::move(name)), descriptor_(descriptor) {
  let_the_size_limit_be_an_error();
}

void LogFile::open(const std::filesystem::path& file, LogOptions::Start start) {
  own_ = FileDescriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode));
  if (!own_ && (errno == EACCES || errno == EINVAL)) {  // a device that takes no reader
    own_ = FileDescriptor(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  }
  if (!own_) {
    refuse(name_, std::string("cannot be created: ") + std::strerror(errno),
           "is the folder there and writable?");
  }
  descriptor_ = own_.get();
  struct stat about {};
  regular_ = fstat(descriptor_, &about) == 0 && S_ISREG(about.st_mode);
  if (!regular_) return;
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    refuse(name_, "is being written by another process", "end that one first, or name another file");
  }
  if (start == LogOptions::Start::go_on) {
    size_bytes_ = whole_bytes(descriptor_, static_cast<std::uint64_t>(about.st_size));
  }
  const auto end = static_cast<off_t>(size_bytes_);
  if (ftruncate(descriptor_, end) != 0 || lseek(descriptor_, end, SEEK_SET) != end) {
    refuse(name_, std::string("cannot be written: ") + std::strerror(errno), "name another file");
  }
}

bool LogFile::append(std::string_view lines) noexcept {
  const bool full = regular_ && options_.most_bytes > 0 && size_bytes_ > options_.head.size() &&
                    size_bytes_ + lines.size() > options_.most_bytes;
  const std::size_t done = (full && !begin_next_file()) || !mend() || !has_head() ? 0 : put(lines);
  size_bytes_ += done;
  lines_ += count_lines(lines.substr(0, done));
  lost_ += count_lines(lines.substr(done));
  return done == lines.size();
}

// A disk that was full when the log began may have room by now.
bool LogFile::has_head() noexcept {
  if (size_bytes_ == 0) size_bytes_ = put(options_.head);
  return size_bytes_ > 0 || options_.head.empty();
}

std::size_t LogFile::put(std::string_view lines) noexcept {
  std::size_t done = 0;
  while (done < lines.size()) {
    const ssize_t count = ::write(descriptor_, lines.data() + done, lines.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      error_ = std::strerror(count < 0 ? errno : EIO);
      break;
    }
    done += static_cast<std::size_t>(count);
  }
  const std::size_t whole = lines.substr(0, done).rfind('\n') + 1;  // npos + 1 is 0
  torn_ = done != whole;
  if (torn_ && regular_) {
    const auto end = static_cast<off_t>(size_bytes_ + whole);
    torn_ = ftruncate(descriptor_, end) != 0 || lseek(descriptor_, end, SEEK_SET) != end;
  }
  return whole;
}

// What stands there in part and cannot be taken back becomes a line of its own, so that those after it are
// whole.
bool LogFile::mend() noexcept {
  if (!torn_) return true;
  if (regular_) {
    const auto end = static_cast<off_t>(size_bytes_);
    torn_ = ftruncate(descriptor_, end) != 0 || lseek(descriptor_, end, SEEK_SET) != end;
  } else {
    torn_ = ::write(descriptor_, "\n", 1) != 1;
  }
  return !torn_;
}

// The new file is whole before it takes its name, and both names are changed at once, each: a kill in between
// leaves the lines under FILE.1, and the next try finds nothing to rename.
bool LogFile::begin_next_file() noexcept {
  const std::string next = name_ + ".new", before = name_ + ".1";
  FileDescriptor file(::open(next.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, kMode));
  const auto head = static_cast<ssize_t>(options_.head.size());
  if (!file || ::write(file.get(), options_.head.data(), options_.head.size()) != head ||
      (::rename(name_.c_str(), before.c_str()) != 0 && errno != ENOENT) ||
      ::rename(next.c_str(), name_.c_str()) != 0) {
    error_ = std::strerror(errno);
    ::unlink(next.c_str());
    return false;
  }
  flock(file.get(), LOCK_EX | LOCK_NB);
  own_ = std::move(file);
  descriptor_ = own_.get();
  torn_ = false;
  size_bytes_ = options_.head.size();
  return true;
}

void LogFile::sync() noexcept {
  if (regular_) fdatasync(descriptor_);
}

}  // namespace gaitway::process

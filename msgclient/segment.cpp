// memfd, seals and mapping.
#include "gaitway/msgclient/segment.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "gaitway/msgclient/topic.hpp"

namespace gaitway::msgclient {
namespace {

constexpr int kSeals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), "shared memory: " + what);
}

void* map_fd(int fd, std::size_t bytes, Access access) {
  const int protection = access == Access::read_write ? PROT_READ | PROT_WRITE : PROT_READ;
  void* const data = mmap(nullptr, bytes, protection, MAP_SHARED, fd, 0);
  if (data == MAP_FAILED) {
    fail("cannot map " + std::to_string(bytes) + " bytes");
  }
  return data;
}

}  // namespace

Segment::Segment(process::FileDescriptor fd, void* data, std::size_t bytes) noexcept
    : fd_(std::move(fd)), data_(data), bytes_(bytes) {}

Segment::Segment(Segment&& other) noexcept
    : fd_(std::move(other.fd_)), data_(std::exchange(other.data_, nullptr)), bytes_(other.bytes_) {}

Segment& Segment::operator=(Segment&& other) noexcept {
  std::swap(fd_, other.fd_);
  std::swap(data_, other.data_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

Segment::~Segment() {
  if (data_ != nullptr) {
    munmap(data_, bytes_);
  }
}

Segment Segment::create(const std::string& name, std::size_t bytes) {
  process::FileDescriptor fd(memfd_create(name.c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!fd) {
    fail("memfd_create of " + name);
  }
  if (fchmod(fd.get(), 0400) != 0 || ftruncate(fd.get(), static_cast<off_t>(bytes)) != 0 ||
      fcntl(fd.get(), F_ADD_SEALS, kSeals) != 0) {
    fail("cannot size and seal " + name);
  }
  void* const data = map_fd(fd.get(), bytes, Access::read_write);
  return Segment(std::move(fd), data, bytes);
}

Segment Segment::map(process::FileDescriptor fd, std::size_t bytes, Access access) {
  struct stat status {};
  if (fstat(fd.get(), &status) != 0) {
    fail("fstat");
  }
  const int seals = fcntl(fd.get(), F_GET_SEALS);
  if (seals < 0 || (seals & kSeals) != kSeals || static_cast<std::size_t>(status.st_size) != bytes) {
    throw TopicError(
        "the server gave memory that is not sealed or has another size than announced: is it another "
        "program's socket?");
  }
  // Its descriptor is closed: through it the memory could be opened once more, for writing (/proc/self/fd).
  return Segment({}, map_fd(fd.get(), bytes, access), bytes);
}

void Segment::keep_to_this_process() {
  if (mmap(data_, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_FIXED, fd_.get(), 0) == MAP_FAILED) {
    fail("cannot map " + std::to_string(bytes_) + " bytes of its own for a copy of the process");
  }
}

void Segment::share_anew(const std::string& name) {
  Segment fresh = create(name, bytes_);
  std::memcpy(fresh.data_, data_, bytes_);
  if (mmap(data_, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, fresh.fd_.get(), 0) == MAP_FAILED) {
    fail("cannot map " + std::to_string(bytes_) + " bytes anew in a copy of the process");
  }
  std::swap(fd_, fresh.fd_);
}

process::FileDescriptor Segment::reopen_read_only() const {
  const std::string path = "/proc/self/fd/" + std::to_string(fd_.get());
  process::FileDescriptor fd(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd) {
    fail("cannot open " + path + " for reading");
  }
  return fd;
}

}  // namespace gaitway::msgclient

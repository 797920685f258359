// Preloaded into a robot's programs by the campaign: a clock of the day that jumps, and a disk that is slow.
// Both are told while the programs run (disturbance.h). Calls that are not on a file go through at once.
#include <dlfcn.h>
#include <fcntl.h>
#include <stdio_ext.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tools/campaign/real_time/disturbance.h"

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr gaitway_disturbance kNone{};

// The words are whole ones, aligned: they are read as they are written.
const volatile gaitway_disturbance* map_words() noexcept {
  const char* const path = std::getenv(GAITWAY_DISTURBANCE_VARIABLE);
  const int file = path == nullptr ? -1 : open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return &kNone;
  void* const words = mmap(nullptr, sizeof(gaitway_disturbance), PROT_READ, MAP_SHARED, file, 0);
  close(file);
  return words == MAP_FAILED ? &kNone : static_cast<const volatile gaitway_disturbance*>(words);
}
const volatile gaitway_disturbance* const kWords = map_words();

bool is_file(int descriptor) noexcept {
  struct stat what {};
  return fstat(descriptor, &what) == 0 && S_ISREG(what.st_mode);
}

void wait_for_disk(int descriptor) noexcept {
  // A constructor of another library may write before this one has its words.
  const std::int64_t wait_ns = kWords == nullptr ? 0 : kWords->write_ns;
  if (wait_ns <= 0 || !is_file(descriptor)) return;
  timespec left{wait_ns / kSecond_ns, wait_ns % kSecond_ns};
  while (nanosleep(&left, &left) != 0) {
  }
}

template <class Function>
Function* next(const char* name) noexcept {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#pragma GCC visibility push(default)  // they stand in for the C library's
extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static auto* const real = next<int(clockid_t, timespec*)>("clock_gettime");
  const int result = real(clock, time);
  if (result == 0 && clock == CLOCK_REALTIME && kWords != nullptr && kWords->clock_shift_ns != 0) {
    const std::int64_t now_ns = time->tv_sec * kSecond_ns + time->tv_nsec + kWords->clock_shift_ns;
    *time = {now_ns / kSecond_ns, now_ns % kSecond_ns};
  }
  return result;
}

int gettimeofday(timeval* time, void*) noexcept {
  timespec now{};
  const int result = clock_gettime(CLOCK_REALTIME, &now);
  *time = {now.tv_sec, now.tv_nsec / 1000};
  return result;
}

time_t time(time_t* seconds) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (seconds != nullptr) *seconds = now.tv_sec;
  return now.tv_sec;
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
  wait_for_disk(descriptor);
  return syscall(SYS_write, descriptor, bytes, count);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
  wait_for_disk(descriptor);
  return syscall(SYS_writev, descriptor, parts, count);
}

size_t fwrite(const void* bytes, size_t size, size_t count, FILE* file) {
  static auto* const real = next<size_t(const void*, size_t, size_t, FILE*)>("fwrite");
  // What is kept in a buffer is written later, by fflush() or at the end.
  if (__fbufsize(file) <= 1 || __flbf(file) != 0) wait_for_disk(fileno(file));
  return real(bytes, size, count, file);
}

int fflush(FILE* file) {
  static auto* const real = next<int(FILE*)>("fflush");
  if (file != nullptr && __fpending(file) > 0) wait_for_disk(fileno(file));
  return real(file);
}

int fsync(int descriptor) {
  wait_for_disk(descriptor);
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}

int fdatasync(int descriptor) {
  wait_for_disk(descriptor);
  return static_cast<int>(syscall(SYS_fdatasync, descriptor));
}

}  // extern "C"
#pragma GCC visibility pop

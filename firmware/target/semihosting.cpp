// The calls of Arm semihosting: how a program on the emulated microcontroller reads and writes the host's
// files.
#include "gaitway_target/semihosting.hpp"

namespace gaitway::target {
namespace {

constexpr std::int32_t kOpen = 0x01, kClose = 0x02, kPrint = 0x04, kWrite = 0x05, kRead = 0x06,
                       kCommandLine = 0x15, kExitExtended = 0x20;
constexpr std::uintptr_t kApplicationExit = 0x20026;

std::int32_t call(std::int32_t operation, const void* argument) {
  register std::int32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

}  // namespace

HostFile::HostFile(const char* path, std::size_t path_length, Mode mode) {
  const std::uintptr_t arguments[3] = {reinterpret_cast<std::uintptr_t>(path),
                                       static_cast<std::uintptr_t>(mode), path_length};
  handle_ = call(kOpen, arguments);
}

HostFile::~HostFile() {
  if (is_open()) {
    call(kClose, &handle_);
  }
}

std::size_t HostFile::read(std::uint8_t* bytes, std::size_t size) {
  const std::uintptr_t arguments[3] = {static_cast<std::uintptr_t>(handle_),
                                       reinterpret_cast<std::uintptr_t>(bytes), size};
  return size - static_cast<std::size_t>(call(kRead, arguments));  // the answer is what is missing
}

std::size_t HostFile::write(const std::uint8_t* bytes, std::size_t size) {
  const std::uintptr_t arguments[3] = {static_cast<std::uintptr_t>(handle_),
                                       reinterpret_cast<std::uintptr_t>(bytes), size};
  return size - static_cast<std::size_t>(call(kWrite, arguments));
}

bool command_line(char* text, std::size_t size) {
  std::uintptr_t arguments[2] = {reinterpret_cast<std::uintptr_t>(text), size};
  return call(kCommandLine, arguments) == 0;
}

void print(const char* text) {
  call(kPrint, text);
}

void print(std::uint32_t number) {
  char digits[11];
  char* first = digits + sizeof(digits) - 1;
  *first = '\0';
  do {
    *--first = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  print(first);
}

void exit(int code) {
  const std::uintptr_t arguments[2] = {kApplicationExit, static_cast<std::uintptr_t>(code)};
  while (true) {
    call(kExitExtended, arguments);
  }
}

}  // namespace gaitway::target

// Files, text and exit of the machine that debugs or emulates the microcontroller (Arm semihosting 2.0).
#pragma once

#include <cstddef>
#include <cstdint>

namespace gaitway::target {

class HostFile {
 public:
  enum class Mode : std::uint8_t { read = 1, write = 5 };  // "rb", "wb"

  HostFile(const char* path, std::size_t path_length, Mode mode);
  HostFile(const HostFile&) = delete;
  HostFile& operator=(const HostFile&) = delete;
  ~HostFile();

  [[nodiscard]] bool is_open() const { return handle_ >= 0; }
  // Bytes that were read or written: fewer than `size` at the end of the file, or on an error.
  std::size_t read(std::uint8_t* bytes, std::size_t size);
  std::size_t write(const std::uint8_t* bytes, std::size_t size);

 private:
  std::int32_t handle_;
};

// The command line that the program was started with, cut off at `size` - 1 characters. False without one.
bool command_line(char* text, std::size_t size);
void print(const char* text);  // zero-terminated
void print(std::uint32_t number);
[[noreturn]] void exit(int code);

}  // namespace gaitway::target

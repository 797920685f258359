// What happened to a robot and its parts, as lines in a file: written at once, so that they survive the end
// of whoever writes them; bounded; and a full disk costs lines, which is told, and nothing else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace gaitway::tools {

class EventFile {
 public:
  // Appends to the file. `most_bytes`: then it becomes FILE.1 in place of the one before, and a new one is
  // begun.
  explicit EventFile(std::filesystem::path file, std::uintmax_t most_bytes = 1'000'000);

  // With date and time before it. Never throws for what becomes of the file.
  void tell(const std::string& text);
  // Lines that could not be written so far, and are not told of yet.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }

 private:
  [[nodiscard]] bool append(const std::string& line) const;

  std::filesystem::path file_;
  std::uintmax_t most_bytes_;
  std::uint64_t lost_ = 0;
};

}  // namespace gaitway::tools

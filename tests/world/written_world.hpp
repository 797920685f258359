// A world file of a test's own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/input/complaint.hpp"
#include "gaitway/world/world_file.hpp"

namespace gaitway::world::test {

class WrittenWorld {
 public:
  explicit WrittenWorld(std::string text) : text_(std::move(text)) {
    std::string pattern = (std::filesystem::temp_directory_path() / "gaitway-world-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + pattern);
    folder_ = pattern;
    std::ofstream(file()) << text_;
  }
  ~WrittenWorld() { std::filesystem::remove_all(folder_); }
  WrittenWorld(const WrittenWorld&) = delete;
  WrittenWorld& operator=(const WrittenWorld&) = delete;

  [[nodiscard]] std::filesystem::path file() const { return folder_ / "course.yaml"; }
  [[nodiscard]] World read() const { return read_world(file()); }

  // It is refused in the line in which `at` stands first, with all of these parts.
  void expect_refused(const std::string& at, const std::vector<std::string>& parts) const {
    const std::size_t place = text_.find(at);
    ASSERT_NE(place, std::string::npos) << at;
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    try {
      (void)read();
      ADD_FAILURE() << "was read without complaint:\n" << text_;
    } catch (const input::InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("course.yaml:" + std::to_string(line) + ": "));
      for (const std::string& part : parts) EXPECT_THAT(error.what(), testing::HasSubstr(part));
    }
  }

 private:
  std::string text_;
  std::filesystem::path folder_;
};

}  // namespace gaitway::world::test

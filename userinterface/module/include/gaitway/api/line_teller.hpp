// Lines for people, on a descriptor that may not take them: a pipe that nobody reads, a terminal that rests.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace gaitway::api {

// Whole lines from any thread, each behind the program's name. Waits for nobody: what the descriptor does not
// take at once is left out, and how many lines were is told by the next one.
class LineTeller {
 public:
  static constexpr std::size_t kMostBytes = 4096;  // of a line; of a longer one the beginning

  // `descriptor`: somebody else's, and open for as long as this is.
  LineTeller(int descriptor, std::string program) : descriptor_(descriptor), program_(std::move(program)) {}
  LineTeller(const LineTeller&) = delete;
  LineTeller& operator=(const LineTeller&) = delete;

  void tell(std::string_view line);

 private:
  [[nodiscard]] bool put(std::string text) const;

  const int descriptor_;
  const std::string program_;
  std::mutex mutex_;
  std::size_t left_out_ = 0;
};

}  // namespace gaitway::api

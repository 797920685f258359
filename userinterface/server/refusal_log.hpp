// Who was refused, and how often, in words: the first at once, then one line for all of a while.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "gaitway/api/server_statistics.hpp"

namespace gaitway::api {

class RefusalLog {
 public:
  static constexpr std::int64_t kPeriod_ns = 10'000'000'000;

  // `who`: an address; of a web page with its origin.
  void note(Refusal cause, std::string who);
  // A line for people, if one is due; to be asked for until there is none.
  [[nodiscard]] std::optional<std::string> take(std::int64_t now_ns);

 private:
  struct Entry {
    std::uint64_t count = 0;  // since it was told of
    std::string latest;
    std::optional<std::int64_t> told_ns;
  };
  std::array<Entry, kRefusalCount> entries_;
};

}  // namespace gaitway::api

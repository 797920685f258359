// Events that say the same again and again, told once and then counted.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api {

// Two events say the same when level, source and text do, but for the numbers in it.
class EventDigest {
 public:
  static constexpr std::int64_t kPeriod_ns = 10'000'000'000;  // from one line to the next that says the same
  static constexpr std::size_t kMostKinds = 64;  // that are counted; the others are told as they come

  // Whether the event is to be told now; if not, repeats() tells of it.
  [[nodiscard]] bool is_news(const ros::Log& event, std::int64_t now_ns);
  // The newest of those that were held back, with their count in its text, once their period is over; to be
  // asked for until there is none.
  [[nodiscard]] std::optional<ros::Log> repeats(std::int64_t now_ns);
  // The clock is another one.
  void clear() noexcept { kinds_.clear(); }

 private:
  struct Kind {
    std::int64_t told_ns = 0;
    std::uint64_t held_back = 0;
    ros::Log newest;
  };
  std::map<std::string, Kind> kinds_;
};

}  // namespace gaitway::api

// What was told lately, by its text without numbers.
#include "event_digest.hpp"

#include <fmt/format.h>

#include <utility>

namespace gaitway::api {
namespace {

std::string kind_of(const ros::Log& event) {
  std::string kind = fmt::format("{} {} ", event.level, event.name);
  bool in_number = false;
  for (const char c : event.msg) {
    const bool digit = c >= '0' && c <= '9';
    if (!digit || !in_number) {
      kind += digit ? '#' : c;
    }
    in_number = digit;
  }
  return kind;
}

}  // namespace

bool EventDigest::is_news(const ros::Log& event, std::int64_t now_ns) {
  const std::string kind = kind_of(event);
  const auto known = kinds_.find(kind);
  if (known == kinds_.end()) {
    if (kinds_.size() < kMostKinds) {
      kinds_[kind].told_ns = now_ns;
    }
    return true;
  }
  ++known->second.held_back;
  known->second.newest = event;
  return false;
}

std::optional<ros::Log> EventDigest::repeats(std::int64_t now_ns) {
  for (auto kind = kinds_.begin(); kind != kinds_.end();) {
    Kind& known = kind->second;
    if (now_ns - known.told_ns < kPeriod_ns) {
      ++kind;
    } else if (known.held_back == 0) {
      kind = kinds_.erase(kind);
    } else {
      known.told_ns = now_ns;
      const std::uint64_t count = std::exchange(known.held_back, 0);
      ros::Log log = std::move(known.newest);
      if (count > 1) {
        log.msg += fmt::format(" (the newest of {} like it in {:g} s)", count,
                               static_cast<double>(kPeriod_ns) * 1e-9);
      }
      return log;
    }
  }
  return std::nullopt;
}

}  // namespace gaitway::api

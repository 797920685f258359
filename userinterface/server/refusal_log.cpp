// One entry for each cause, so that a flood of one hides no other.
#include "refusal_log.hpp"

#include <string_view>
#include <utility>

namespace gaitway::api {
namespace {

std::string_view reason(Refusal cause) {
  switch (cause) {
    case Refusal::foreign_origin:
      return "a web page whose origin is not among the API's origins";
    case Refusal::wrong_token:
      return "a client with a wrong token";
    case Refusal::other_page:
      return "a page of another version, which its browser must load again";
    case Refusal::too_many:
      return "a client for which there is no place";
    default:
      return "a client that does not speak as it must";
  }
}

}  // namespace

void RefusalLog::note(Refusal cause, std::string who) {
  Entry& entry = entries_[static_cast<std::size_t>(cause)];
  ++entry.count;
  entry.latest = std::move(who);
}

std::optional<std::string> RefusalLog::take(std::int64_t now_ns) {
  for (std::size_t cause = 0; cause < entries_.size(); ++cause) {
    Entry& entry = entries_[cause];
    if (entry.count == 0 || (entry.told_ns && now_ns - *entry.told_ns < kPeriod_ns)) {
      continue;
    }
    entry.told_ns = now_ns;
    const std::uint64_t count = std::exchange(entry.count, 0);
    return "refused " + std::string(reason(static_cast<Refusal>(cause))) + ": " + entry.latest +
           (count > 1 ? ", the latest of " + std::to_string(count) : "");
  }
  return std::nullopt;
}

}  // namespace gaitway::api

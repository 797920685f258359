// A search between two points.
#include "tools/twin/track.hpp"

#include <algorithm>

namespace gaitway::tools {
namespace {

constexpr double kWidestGap_s = 0.1;

}  // namespace

void Track::add(double time_s, std::vector<double> values, double kept_s) {
  if (!points_.empty() && time_s <= points_.back().time_s) return;
  points_.push_back({time_s, std::move(values)});
  while (points_.front().time_s < time_s - kept_s) points_.pop_front();
}

std::optional<std::vector<double>> Track::at(double time_s) const {
  const auto after = std::ranges::lower_bound(points_, time_s, {}, &Point::time_s);
  if (after == points_.end()) return std::nullopt;
  if (after->time_s == time_s) return after->values;
  if (after == points_.begin()) return std::nullopt;
  const Point& before = *std::prev(after);
  const double gap_s = after->time_s - before.time_s;
  if (gap_s > kWidestGap_s || before.values.size() != after->values.size()) return std::nullopt;
  const double share = (time_s - before.time_s) / gap_s;
  std::vector<double> values(before.values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = before.values[i] + share * (after->values[i] - before.values[i]);
  }
  return values;
}

}  // namespace gaitway::tools

// Two histories, one shifted over the other.
#include "tools/twin/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string_view>
#include <utility>

#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {
namespace {

constexpr double kKept_s = 4.0;       // window, longest lag, and some
constexpr double kPeriod_s = 0.2;     // of comparisons
constexpr double kOld_s = 0.5;        // what comes no more is not known
constexpr double kClockSet_s = 2.0;   // a clock that is off by more was set
constexpr double kClockSpan_s = 2.0;  // in which the message that was under way the shortest is looked for
constexpr double kLagStep_s = 0.01;
constexpr double kMoves_rad = 0.01;  // RMS of a joint about its mean: less is a stand, which fits everywhere
constexpr double kToldAgainBelow = 0.7;    // of the limit
constexpr std::size_t kOtherChannels = 7;  // but the joints
constexpr std::size_t kMostNamed = 3;      // in a sentence

// Over 2 s, of what a robot that is as described, and has other masses and joint zeros within what is usual,
// stays below while it walks; measured with simulated ones (docs/simulator.md).
constexpr double kJointLimit_rad = 3.0 * facts::kRadPerDegree;
constexpr double kAttitudeLimit_rad = 2.0 * facts::kRadPerDegree;
constexpr double kPlaceLimit_m = 0.25,
                 kHeadingLimit_rad = 20.0 * facts::kRadPerDegree;  // then they are no picture of each other
constexpr double kLoadLimit = 0.25;                                // of the robot's weight

double turned_into_half(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

// A walk fits itself once a stride: of the shifts that fit about as well as the best, the least is meant.
// `candidates`: squared difference and lag [s], by lag.
std::optional<double> best_lag_s(const std::vector<std::pair<double, double>>& candidates) {
  constexpr double kAboutAsWell = 1.5;
  if (candidates.empty()) return std::nullopt;
  const double least = std::ranges::min_element(candidates)->first;
  std::optional<double> best_s;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& [square, lag_s] = candidates[i];
    const bool is_minimum = (i == 0 || square <= candidates[i - 1].first) &&
                            (i + 1 == candidates.size() || square <= candidates[i + 1].first);
    if (!is_minimum || square > kAboutAsWell * least) continue;
    if (!best_s || std::abs(lag_s) < std::abs(*best_s)) best_s = lag_s;
  }
  return best_s;
}

std::string shown(const Channel& channel, double value) {
  if (std::string_view(channel.unit) == "rad") return fmt::format("{:.1f} deg", value / facts::kRadPerDegree);
  if (std::string_view(channel.unit) == "m") return fmt::format("{:.0f} mm", value * 1e3);
  return fmt::format("{:.0f} {}", value, channel.unit);
}

}  // namespace

std::optional<double> Comparison::ClockFit::here(double stamp_s, double arrived_s) {
  const double offset_s = arrived_s - stamp_s;
  const bool is_set =
      offset_s_ && (stamp_s < last_stamp_s_ - kClockSet_s || std::abs(offset_s - *offset_s_) > kClockSet_s);
  if (is_set) {
    forget();
    return std::nullopt;
  }
  if (!offset_s_ || arrived_s - began_s_ > kClockSpan_s) {
    offset_before_s_ = offset_s_;
    offset_s_ = offset_s;
    began_s_ = arrived_s;
  }
  offset_s_ = std::min(*offset_s_, offset_s);
  last_stamp_s_ = stamp_s;
  return stamp_s + std::min(*offset_s_, offset_before_s_.value_or(*offset_s_));
}

Comparison::Comparison(const urdf::RobotModel& robot) {
  for (const urdf::Joint& joint : robot.joints) channels_.push_back({joint.name, "rad", kJointLimit_rad});
  const double load_limit_N = kLoadLimit * robot.total_mass_kg() * facts::kGravity_m_per_s2;
  channels_.insert(channels_.end(), {{"roll", "rad", kAttitudeLimit_rad},
                                     {"pitch", "rad", kAttitudeLimit_rad},
                                     {"left foot", "N", load_limit_N},
                                     {"right foot", "N", load_limit_N},
                                     {"place x", "m", kPlaceLimit_m},
                                     {"place y", "m", kPlaceLimit_m},
                                     {"heading", "rad", kHeadingLimit_rad}});
  values_.resize(channels_.size());
  is_told_.resize(channels_.size());
  above_since_s_.resize(channels_.size());
}

const Track& Comparison::track(Robot robot, Measurement what) const {
  return halves_[static_cast<std::size_t>(robot)].tracks[static_cast<std::size_t>(what)];
}

bool Comparison::take(Robot robot, const ArrivedPoint& arrived) {
  Half& half = halves_[static_cast<std::size_t>(robot)];
  // A place is told when it changes, and to who comes later once more, with its old stamp.
  if (arrived.point.what == Measurement::place) {
    half.tracks[static_cast<std::size_t>(Measurement::place)].add(arrived.arrived_s, arrived.point.values,
                                                                  kKept_s);
    return true;
  }
  const auto here_s = half.clock.here(arrived.point.stamp_s, arrived.arrived_s);
  if (!here_s) {
    forget(robot);
    return false;
  }
  half.tracks[static_cast<std::size_t>(arrived.point.what)].add(*here_s, arrived.point.values, kKept_s);
  return true;
}

void Comparison::forget(Robot robot) {
  Half& half = halves_[static_cast<std::size_t>(robot)];
  half.clock.forget();
  for (Track& one : half.tracks) one.clear();
}

void Comparison::pause(Robot robot) {
  Half& half = halves_[static_cast<std::size_t>(robot)];
  const Track place = half.tracks[static_cast<std::size_t>(Measurement::place)];
  forget(robot);
  half.tracks[static_cast<std::size_t>(Measurement::place)] = place;
}

void Comparison::look(double now_s) {
  if (now_s - looked_s_ < kPeriod_s) return;
  looked_s_ = now_s;
  std::ranges::fill(values_, ChannelValues{});
  const std::size_t channel = channels_.size() - kOtherChannels;
  compare_places(channel + 4);
  const bool both = is_known(now_s, track(Robot::real, Measurement::joints)) &&
                    is_known(now_s, track(Robot::simulated, Measurement::joints));
  if (!both) {
    lag_s_.reset();
    return;
  }
  const double until_s = std::min(track(Robot::real, Measurement::joints).points().back().time_s,
                                  track(Robot::simulated, Measurement::joints).points().back().time_s) -
                         kLongestLag_s;
  find_lag(until_s);
  compare(Measurement::joints, 0, until_s);
  compare(Measurement::attitude, channel, until_s);
  compare(Measurement::left_foot, channel + 2, until_s);
  compare(Measurement::right_foot, channel + 3, until_s);
  tell(now_s);
}

bool Comparison::is_known(double now_s, const Track& track) {
  return !track.points().empty() && now_s - track.points().back().time_s < kOld_s;
}

// The mean over the joints' points of the real robot in that time; nothing: it stands, or there is too
// little.
std::optional<double> Comparison::squared_difference(double lag_s, double from_s, double until_s) const {
  const Track& simulated = track(Robot::simulated, Measurement::joints);
  double sum = 0.0;
  std::size_t count = 0;
  for (const Track::Point& point : track(Robot::real, Measurement::joints).points()) {
    if (point.time_s < from_s || point.time_s > until_s) continue;
    const auto there = simulated.at(point.time_s + lag_s);
    if (!there || there->size() != point.values.size()) continue;
    for (std::size_t i = 0; i < there->size(); ++i) {
      const double apart_rad = point.values[i] - (*there)[i];
      if (std::isfinite(apart_rad)) sum += apart_rad * apart_rad;
    }
    ++count;
  }
  constexpr std::size_t kFewest = 25;
  return count < kFewest ? std::nullopt : std::optional(sum / static_cast<double>(count));
}

void Comparison::find_lag(double until_s) {
  const double from_s = until_s - kWindow_s;
  std::vector<double> sum, squares;
  std::size_t count = 0;
  for (const Track::Point& point : track(Robot::real, Measurement::joints).points()) {
    if (point.time_s < from_s || point.time_s > until_s) continue;
    sum.resize(point.values.size());
    squares.resize(point.values.size());
    for (std::size_t i = 0; i < point.values.size(); ++i) {
      sum[i] += point.values[i];
      squares[i] += point.values[i] * point.values[i];
    }
    ++count;
  }
  double largest_square = 0.0;
  for (std::size_t i = 0; i < sum.size() && count > 0; ++i) {
    const double mean = sum[i] / static_cast<double>(count);
    largest_square = std::max(largest_square, squares[i] / static_cast<double>(count) - mean * mean);
  }
  if (largest_square < kMoves_rad * kMoves_rad) return;
  std::vector<std::pair<double, double>> candidates;  // square, lag
  constexpr int kSteps = 60;
  for (int step = -kSteps; step <= kSteps; ++step) {
    const double lag_s = kLagStep_s * step;
    if (const auto square = squared_difference(lag_s, from_s, until_s))
      candidates.emplace_back(*square, lag_s);
  }
  lag_s_ = best_lag_s(candidates);
}

void Comparison::compare(Measurement what, std::size_t first_channel, double until_s) {
  const Track& real = track(Robot::real, what);
  const Track& simulated = track(Robot::simulated, what);
  if (real.points().empty()) return;
  const std::size_t width = real.points().back().values.size();
  std::vector<double> sum(width);
  std::size_t count = 0;
  for (const Track::Point& point : real.points()) {
    if (point.time_s < until_s - kWindow_s) continue;
    const auto there = simulated.at(point.time_s + lag_s_.value_or(0.0));
    if (!there || there->size() != width || point.values.size() != width) continue;
    const bool is_in_window = point.time_s <= until_s;
    count += is_in_window ? 1 : 0;
    for (std::size_t i = 0; i < width; ++i) {
      values_[first_channel + i].measured = point.values[i];
      values_[first_channel + i].simulated = (*there)[i];
      const double apart = is_in_window ? point.values[i] - (*there)[i] : 0.0;
      sum[i] += apart * apart;
    }
  }
  for (std::size_t i = 0; i < width && count > 0; ++i) {
    values_[first_channel + i].difference = std::sqrt(sum[i] / static_cast<double>(count));
  }
}

// A place is told as it changes, so the last one holds.
void Comparison::compare_places(std::size_t first_channel) {
  const auto& real = track(Robot::real, Measurement::place).points();
  const auto& simulated = track(Robot::simulated, Measurement::place).points();
  if (real.empty() || simulated.empty()) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const double there = real.back().values.at(i), here = simulated.back().values.at(i);
    const double apart = i == 2 ? turned_into_half(there - here) : there - here;
    values_[first_channel + i] = {there, here, std::abs(apart)};
  }
}

void Comparison::tell(double now_s) {
  std::vector<std::size_t> new_ones;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const double limit = channels_[i].limit, difference = values_[i].difference;
    if (limit == 0.0 || !std::isfinite(difference)) continue;
    if (difference <= limit) above_since_s_[i] = 0.0;
    if (difference < kToldAgainBelow * limit) is_told_[i] = false;
    if (difference <= limit || is_told_[i]) continue;
    if (above_since_s_[i] == 0.0) above_since_s_[i] = now_s;
    if (now_s - above_since_s_[i] < kLasts_s) continue;
    is_told_[i] = true;
    new_ones.push_back(i);
  }
  const auto share = [this](std::size_t i) { return values_[i].difference / channels_[i].limit; };
  std::ranges::sort(new_ones, std::greater<>(), share);
  std::string text;
  for (std::size_t k = 0; k < std::min(new_ones.size(), kMostNamed); ++k) {
    const std::size_t i = new_ones[k];
    text += fmt::format("{}{} by {} (more than {})", k == 0 ? "" : ", ", channels_[i].name,
                        shown(channels_[i], values_[i].difference), shown(channels_[i], channels_[i].limit));
  }
  if (new_ones.size() > kMostNamed) text += fmt::format(" and {} others", new_ones.size() - kMostNamed);
  if (!text.empty())
    news_ = fmt::format("differs from the simulated one, RMS of {:g} s: {}", kWindow_s, text);
}

std::string Comparison::take_news() {
  return std::exchange(news_, {});
}

}  // namespace gaitway::tools

// Measured values over time, and what they were at an instant in between.
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace gaitway::tools {

class Track {
 public:
  struct Point {
    double time_s = 0.0;
    std::vector<double> values;
  };

  // Later than all before, or it is left out. What is older than `kept_s` is forgotten.
  void add(double time_s, std::vector<double> values, double kept_s);
  void clear() noexcept { points_.clear(); }
  // Linear between two points that are no more than 0.1 s apart; nothing outside of them.
  [[nodiscard]] std::optional<std::vector<double>> at(double time_s) const;
  [[nodiscard]] const std::deque<Point>& points() const noexcept { return points_; }

 private:
  std::deque<Point> points_;
};

}  // namespace gaitway::tools

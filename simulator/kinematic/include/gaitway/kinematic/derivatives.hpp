// Value and derivatives at evenly spaced samples: those of the parabola that fits them best.
#pragma once

namespace gaitway::kinematic {

template <class Value>
struct Derivatives {
  Value value, first, second;
};

// `sample(k)` for k = -half..half, `interval` apart; what is returned is the parabola's at k = `at`. In the
// middle half = 1 gives central differences. A. Savitzky, M. J. E. Golay, "Smoothing and differentiation of
// data by simplified least squares procedures", 1964.
template <class Value, class Sample>
[[nodiscard]] Derivatives<Value> fit_parabola(int half, double interval, const Sample& sample, int at = 0) {
  const double count = 2.0 * half + 1.0;
  double squares = 0.0, fourths = 0.0;
  for (int k = 1; k <= half; ++k) {
    const double square = static_cast<double>(k) * k;
    squares += 2.0 * square;
    fourths += 2.0 * square * square;
  }
  const double mean_square = squares / count;
  const double spread = fourths - squares * mean_square;
  Value mean = sample(0) / count, slope = 0.0 * sample(0), bend = -mean_square * sample(0);
  for (int k = 1; k <= half; ++k) {
    const Value before = sample(-k), after = sample(k);
    const double square = static_cast<double>(k) * k - mean_square;
    mean += (before + after) / count;
    slope += static_cast<double>(k) * (after - before);
    bend += square * (before + after);
  }
  bend /= spread;
  slope /= squares;
  return {Value(mean + static_cast<double>(at) * slope + (static_cast<double>(at) * at - mean_square) * bend),
          Value((slope + 2.0 * at * bend) / interval), Value(2.0 * bend / (interval * interval))};
}

}  // namespace gaitway::kinematic

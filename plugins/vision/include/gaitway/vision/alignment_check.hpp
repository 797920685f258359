// Whether the two cameras still look the way their calibration says: matches of single corners, sought
// further than the map's matching does.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace gaitway::vision {

struct Alignment {
  enum class Verdict { unknown, fine, exchanged, misaligned };
  Verdict verdict = Verdict::unknown;
  int matches = 0;           // of single corners
  double rows_off_px = 0.0;  // root mean square of the matches' distances from their common row
};

// Of rectified pictures of up to 320 pixels a row. `unknown`: too few corners have a clear match to say
// anything.
[[nodiscard]] Alignment alignment_of(const cv::Mat& left, const cv::Mat& right);

}  // namespace gaitway::vision

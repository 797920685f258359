// Pairs of pictures of a chessboard as they lie in a folder, and the corners that both show.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace gaitway::calibration {

struct Board {
  int columns = 9, rows = 6;  // inner corners; one of them even, one odd, so that it is never upside down
  double square_m = 0.025;
};

struct BoardPair {
  std::string name;
  std::vector<cv::Point2f> left, right;  // row by row
};

struct BoardPictures {
  cv::Size size;
  std::vector<BoardPair> pairs;
  std::vector<std::string> without_board;  // in one picture at least
};

// PNGs in `folder`, both pictures side by side (as `gaitway run --eyes` writes them), or in its folders left
// and right under the same names. Throws input::InputError, with what to do, for a folder without pictures,
// pictures of different sizes, or a board that could be upside down.
[[nodiscard]] BoardPictures find_boards(const std::filesystem::path& folder, const Board& board);

}  // namespace gaitway::calibration

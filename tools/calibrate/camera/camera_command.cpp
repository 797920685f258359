// Reads the pictures, tells how well the corners fit, and writes the camera file without losing the old one.
#include "tools/calibrate/camera/camera_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/urdf/camera_file.hpp"
#include "tools/calibrate/camera/board_pictures.hpp"
#include "tools/calibrate/camera/stereo_calibration.hpp"

namespace gaitway::calibration {
namespace {

namespace fs = std::filesystem;

struct CameraOptions {
  fs::path pictures, robot;
  Board board;
  std::optional<fs::path> out;
};

// A name beside the file that nothing has yet.
fs::path kept_name(const fs::path& file) {
  fs::path kept = file.string() + ".bak";
  for (int i = 2; fs::exists(kept); ++i) kept = fmt::format("{}.bak{}", file.string(), i);
  return kept;
}

// Checked as a robot's before it takes the old one's place.
void write_camera_file(const fs::path& file, const std::string& text) {
  const fs::path unchecked = file.string() + ".new";
  process::write_text_file(unchecked, text);
  try {
    (void)urdf::read_stereo_camera(unchecked);
  } catch (const input::InputError&) {
    fs::remove(unchecked);
    throw;
  }
  if (fs::exists(file)) {
    const fs::path kept = kept_name(file);
    fs::rename(file, kept);
    fmt::print("the old one is {}\n", kept.string());
  }
  fs::rename(unchecked, file);
  fmt::print("wrote {}\n", file.string());
}

int calibrate_camera(const CameraOptions& options) {
  const fs::path camera_file = options.robot / "camera.yaml";
  const std::string old = input::read_text_file(
      camera_file,
      "It says where on the robot the camera sits: write it first (urdf/README.md); any lens will do");
  const BoardPictures pictures = find_boards(options.pictures, options.board);
  const StereoCalibration found = calibrate(pictures, options.board, options.pictures);
  fmt::print("{} pairs of {} x {} pixels used, {} without the whole board\n", pictures.pairs.size(),
             pictures.size.width, pictures.size.height, pictures.without_board.size());
  fmt::print("corners off by {:.3f} px (left), {:.3f} px (right), {:.3f} px (both together)\n",
             found.lens_error_px[0], found.lens_error_px[1], found.pair_error_px);
  fmt::print("boards reach {:.0f} % of the left picture, {:.0f} % of the right one\n", 100 * found.covered[0],
             100 * found.covered[1]);
  fmt::print("base {:.2f} mm\n", 1e3 * found.right_in_left.translation().norm());
  write_camera_file(options.out.value_or(camera_file),
                    with_calibration(old, found, pictures.size.width, pictures.size.height));
  return tools::kExitFine;
}

}  // namespace

void declare_camera(const tools::CommandLine& calibrate) {
  const tools::CommandLine command =
      calibrate.subcommand("camera", "The stereo camera, from pairs of pictures of a chessboard");
  CameraOptions& options = command.runs(calibrate_camera);
  options.robot = process::default_robot_directory();
  command
      .option("pictures", options.pictures,
              "Folder with PNGs, pairs side by side, or with the folders left and right")
      .required();
  command.option("--columns", options.board.columns, "Inner corners along the board's first side")
      .between(3, 40);
  command.option("--rows", options.board.rows, "Inner corners along the other").between(3, 40);
  command.option("--square", options.board.square_m, "Side of a square, m").between(0.002, 1.0);
  command.option("--robot", options.robot, "Folder of the robot's description, with camera.yaml");
  command.option("--out", options.out, "File for the result, in place of the robot's own camera.yaml");
  command.footer(
      "Examples:\n"
      "  gaitway calibrate camera out/board --columns 9 --rows 6 --square 0.025\n"
      "  gaitway calibrate camera out/board --robot my_robot --out camera_new.yaml\n"
      "Exit code: 0 written, 1 the input was bad, and nothing was written.");
}

}  // namespace gaitway::calibration

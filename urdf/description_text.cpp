// Whole, or an error.
#include "gaitway/urdf/description_text.hpp"

#include <fstream>
#include <iterator>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

std::string description_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) {
    throw RobotError("the robot's description '" + file.string() +
                     "' cannot be read; check the file and its permissions");
  }
  return text;
}

}  // namespace gaitway::urdf

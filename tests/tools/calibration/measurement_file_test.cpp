// Measurements survive their file, and what is wrong with a file is said with its place.
#include "tools/calibrate/standing_measurement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "synthetic_stances.hpp"
#include "tools/calibrate/calibration_estimator.hpp"

namespace gaitway::calibration {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class MeasurementFileTest : public ::testing::Test {
 protected:
  MeasurementFileTest() {
    std::mt19937_64 random(2);
    SyntheticStances stances(robot_, motion::read_motion(GAITWAY_POSES, robot_));
    measured_ = {Weighing{6.812, 0.01}, stances.measure(stances.draw(random, {}), {}, random)};
    measured_.poses[0].inclination_rad.reset();
    measured_.poses[1].placement = 3;
    measured_.poses[1].inclination_rad = Eigen::Vector2d(0.01, -0.02);
    measured_.poses[1].inclination_deviation_rad = {0.001, 0.002};
  }
  ~MeasurementFileTest() override { std::filesystem::remove(file_); }

  void write(const std::string& text) const { std::ofstream(file_) << text; }

  // After `before` has become `after` in a sound file.
  std::string complaint(const std::string& before, const std::string& after) const {
    std::string text = measurement_text(measured_, robot_);
    const std::size_t place = text.find(before);
    EXPECT_NE(place, std::string::npos) << before;
    write(text.replace(place, before.size(), after));
    try {
      (void)read_measurements(file_, robot_);
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "(read without complaint)";
  }

  const urdf::RobotModel robot_ = urdf::load_robot(GAITWAY_ROBOT);
  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("gaitway-measured-" + std::to_string(getpid()) + ".yaml");
  MeasurementFile measured_;
};

TEST_F(MeasurementFileTest, gives_the_same_calibration_as_what_was_written) {
  write(measurement_text(measured_, robot_));
  const MeasurementFile read = read_measurements(file_, robot_);
  ASSERT_EQ(read.poses.size(), measured_.poses.size());
  ASSERT_TRUE(read.weighing && read.poses[1].inclination_rad && !read.poses[0].inclination_rad);
  EXPECT_EQ(read.weighing->mass_kg, 6.812);
  EXPECT_EQ(read.poses[1].placement, 3);
  EXPECT_EQ(read.poses[2].pose, "bent forward");
  CalibrationSettings settings;
  settings.weighing = measured_.weighing;
  const Calibration before = calibrate(robot_, measured_.poses, settings);
  const Calibration after = calibrate(robot_, read.poses, settings);
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    EXPECT_NEAR(after.zero_rad[j].value, before.zero_rad[j].value, 0.05 * before.zero_rad[j].deviation);
  }
}

TEST_F(MeasurementFileTest, complains_with_line_field_and_remedy) {
  EXPECT_THAT(complaint("robot: humanoid22", "robot: other"), AllOf(HasSubstr(":1"), HasSubstr("--robot")));
  EXPECT_THAT(complaint("left_knee: ", "left_nee: "), AllOf(HasSubstr("left_nee"), HasSubstr("left_knee")));
  EXPECT_THAT(complaint("stands: both", "stands: all"),
              AllOf(HasSubstr(":5"), HasSubstr("both, left or right")));
  EXPECT_THAT(complaint("left_cells_N", "left_cell_N"), HasSubstr("left_cells_N"));
  EXPECT_THAT(complaint("mass_kg: 6.8120", "mass_kg: -1"), AllOf(HasSubstr("mass_kg"), HasSubstr("0.1")));
  EXPECT_THAT(complaint("      right_elbow", "      # "), HasSubstr("right_elbow"));
  EXPECT_THAT(complaint("value: [", "value: [1, "), HasSubstr("specific_force_m_per_s2.value"));
}

}  // namespace
}  // namespace gaitway::calibration

// A world is seen as it is: surfaces, tags the right way round, and a robot that nothing hides.
#include "gaitway/simulator/camera.hpp"
#include "gaitway/world/picture.hpp"
#include "world_fixture.hpp"

namespace gaitway::simulator {
namespace {

constexpr int kSide_px = 360;

class WorldPictureTest : public WorldTest {
 protected:
  static Eigen::Vector3i pixel(const Image& image, int row, int column) {
    const auto at = static_cast<std::size_t>(3 * (row * image.width_px + column));
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
  }
  // Straight on to the middle of a tag of 0.8 m, a cell of it 0.1 m, from so far that a cell is 20 pixels.
  static View in_front(const Eigen::Vector3d& tag_m, double azimuth_deg, double elevation_deg) {
    const double half_height_m = 0.1 * kSide_px / 20 / 2.0;
    return {.look_at_m = tag_m,
            .distance_m = half_height_m / std::tan(kFieldOfView_deg / 2.0 * std::numbers::pi / 180.0),
            .azimuth_deg = azimuth_deg,
            .elevation_deg = elevation_deg};
  }
  static void expect_tag(const Image& image, int id) {
    const auto cells = world::tag_cells(id);
    for (int row = 0; row < world::kTagCells; ++row) {
      for (int column = 0; column < world::kTagCells; ++column) {
        const int y = kSide_px / 2 + 20 * row - 70, x = kSide_px / 2 + 20 * column - 70;
        EXPECT_EQ(pixel(image, y, x).sum() > 300,
                  cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)])
            << "row " << row << ", column " << column;
      }
    }
  }
};

TEST_F(WorldPictureTest, ATagOnAWallIsReadTheRightWayRound) {
  Plant robot = plant(
      "start: {position_m: [-5, 0]}\nlights: [{sun: [1, 0.2, -0.5]}]\n"
      "tags: [{id: 397, size_m: 0.8, position_m: [2, 1, 1], yaw_deg: 180}]\n");
  Camera camera(robot, kSide_px, kSide_px);
  expect_tag(camera.render(robot.positions(), in_front({2.0, 1.0, 1.0}, 0.0, 0.0)), 397);
}

TEST_F(WorldPictureTest, ATagOnTheFloorIsReadByWhoLooksDownAtIt) {
  Plant robot = plant(
      "start: {position_m: [-5, 0]}\n"
      "tags: [{id: 502, size_m: 0.8, position_m: [2, 1, 0.002], yaw_deg: 180, pitch_deg: 90}]\n");
  Camera camera(robot, kSide_px, kSide_px);
  expect_tag(camera.render(robot.positions(), in_front({2.0, 1.0, 0.0}, 0.0, -90.0)), 502);
}

TEST_F(WorldPictureTest, SurfacesHaveTheirColours) {
  Plant robot = plant(
      "start: {position_m: [-5, 0]}\nsurfaces: {red: {plain: [1, 0, 0]}, green: {checker: [[0, 1, 0], [0, 0, "
      "1]], "
      "repeat_m: 0.4}}\nfloor: {surface: green}\nboxes: [{position_m: [2, 0], size_m: [0.4, 0.4, 0.1], "
      "surface: red}]\n");
  Camera camera(robot, kSide_px, kSide_px);
  const Image image = camera.render(
      robot.positions(), {.look_at_m = {2, 0, 0}, .distance_m = 3, .azimuth_deg = 90, .elevation_deg = -90});
  const Eigen::Vector3i middle = pixel(image, kSide_px / 2, kSide_px / 2);
  EXPECT_GT(middle[0], 4 * middle[1]);
  int green = 0, blue = 0;
  for (int x = 10; x < kSide_px - 10; x += 5) {
    const Eigen::Vector3i floor = pixel(image, 20, x);
    green += floor[1] > 2 * floor[2] ? 1 : 0;
    blue += floor[2] > 2 * floor[1] ? 1 : 0;
  }
  EXPECT_GT(green, 20);
  EXPECT_GT(blue, 20);
}

TEST_F(WorldPictureTest, AnImageThatIsNoneIsRefusedByTheWorldsName) {
  const std::filesystem::path image = file_.parent_path() / (file_.stem().string() + ".png");
  std::ofstream(image) << "no picture";
  EXPECT_THROW((void)plant("surfaces: {poster: {image: " + image.filename().string() +
                           "}}\nfloor: {surface: poster}\n"),
               std::runtime_error);
  std::filesystem::remove(image);
}

TEST_F(WorldPictureTest, AnImageFileIsSeen) {
  const std::filesystem::path image = file_.parent_path() / (file_.stem().string() + ".png");
  Image blue{.width_px = 8, .height_px = 8, .rgb = {}};
  for (int i = 0; i < 64; ++i) blue.rgb.insert(blue.rgb.end(), {0, 0, 255});
  write_film_strip(image.string(), std::vector{blue}, 1);
  Plant robot =
      plant("surfaces: {poster: {image: " + image.filename().string() + "}}\nfloor: {surface: poster}\n");
  Camera camera(robot, kSide_px, kSide_px);
  const Eigen::Vector3i floor =
      pixel(camera.render(robot.positions(),
                          {.look_at_m = {2, 0, 0}, .distance_m = 3, .azimuth_deg = 90, .elevation_deg = -90}),
            kSide_px / 2, kSide_px / 2);
  EXPECT_GT(floor[2], 4 * floor[0]);
  std::filesystem::remove(image);
}

// The usual place of the camera is behind the wall.
TEST_F(WorldPictureTest, TheCameraGoesAsideWhereAWallHidesTheRobot) {
  const Plant robot = plant(
      "surfaces: {red: {plain: [1, 0, 0]}}\n"
      "walls: [{from_m: [0.6, -2], to_m: [0.6, 2], height_m: 3, surface: red}]\n");
  Camera camera(robot, kSide_px, kSide_px);
  const auto red_in_the_middle = [](const Image& seen) {
    int count = 0;
    for (int row = kSide_px / 4; row < 3 * kSide_px / 4; ++row) {
      const Eigen::Vector3i at = pixel(seen, row, kSide_px / 2);
      count += at[0] > 3 * at[1] ? 1 : 0;
    }
    return count;
  };
  const View usual{
      .look_at_m = {0.0, 0.0, 0.4}, .distance_m = 1.5, .azimuth_deg = -125.0, .elevation_deg = -11.0};
  EXPECT_GT(red_in_the_middle(camera.render(robot.positions(), usual)), kSide_px / 2 - 5);
  EXPECT_LT(red_in_the_middle(camera.render(robot.positions())), 20);
}

}  // namespace
}  // namespace gaitway::simulator

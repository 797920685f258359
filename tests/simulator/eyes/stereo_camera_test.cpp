// Pairs come when the camera file says, the same for one seed, in forked copies too, and from nobody who does
// not want them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "eyes_fixture.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::simulator {
namespace {

using urdf::Side;

constexpr const char* kRoom =
    "surfaces: {boards: {noise: [[0.2, 0.2, 0.2], [0.8, 0.8, 0.8]], repeat_m: 0.9}}\nfloor: {surface: "
    "boards}\n"
    "boxes: [{position_m: [1.2, 0.1], size_m: [0.3, 0.3, 0.5], surface: boards}]\n";

class StereoCameraTest : public EyesTest {
 protected:
  [[nodiscard]] PicturePair first_pair(std::uint64_t seed) const {
    PlantOptions how = options(kRoom);
    how.seed = seed;
    const Plant robot(model_, how);
    const auto seeing = see(how);
    seeing->wait(robot, 60);
    return seeing->camera.newest();
  }
};

TEST_F(StereoCameraTest, PairsComeWithTheirStampsAfterTheLatency) {
  const PlantOptions how = options(kRoom);
  const Plant robot(model_, how);
  const auto seeing = see(how);
  auto reader = seeing->block.local_client("vision").read<StereoPictures>("stereo_pictures");
  auto seen = std::make_unique<StereoPictures>();
  std::uint64_t came = 0;
  for (int ms = 0; ms < 400; ++ms) {
    seeing->wait(robot, 1);
    const auto result = reader.read(*seen);
    if (!result || seen->number == came) continue;
    came = seen->number;
    const std::int64_t begins_ns = static_cast<std::int64_t>(came - 1) * 80'000'000;
    EXPECT_EQ(seen->stamp_ns, begins_ns + 8'000'000) << "half of 4 ms and 12 ms";
    EXPECT_EQ(ms * 1'000'000, seen->stamp_ns + 30'000'000) << "in the millisecond in which it is due";
    EXPECT_EQ(result.stamp_ns, ms * 1'000'000);
    EXPECT_EQ(seen->width, 320U);
    EXPECT_EQ(seen->height, 240U);
    EXPECT_EQ(seen->readout_ns, 12'000'000);
    EXPECT_LE(seen->exposure_ns, 4'000'000);
    EXPECT_TRUE(std::ranges::equal(seen->left, seeing->camera.newest().grey[0]));
    EXPECT_TRUE(std::ranges::equal(seen->right, seeing->camera.newest().grey[1]));
  }
  EXPECT_EQ(came, 5U);
}

TEST_F(StereoCameraTest, NothingIsDrawnForNobody) {
  const PlantOptions how = options(kRoom);
  const Plant robot(model_, how);
  const auto seeing = see(how);
  seeing->wait(robot, 500, false);
  EXPECT_EQ(seeing->camera.newest().number, 0U);
  seeing->wait(robot, 200, true);
  EXPECT_GT(seeing->camera.newest().number, 0U);
}

TEST_F(StereoCameraTest, OneSeedGivesTheSameBitsAndAnotherOneOthers) {
  const PicturePair pair = first_pair(5);
  EXPECT_EQ(first_pair(5).grey, pair.grey);
  EXPECT_NE(first_pair(6).grey, pair.grey);
  EXPECT_NE(pair.grey[0], pair.grey[1]);
}

TEST_F(StereoCameraTest, SomePairsAreLostAndTheirNumbersWithThem) {
  const PlantOptions how = options(kRoom);
  const Plant robot(model_, how);
  Seeing seeing(model_, file_of_camera_, {.shadow_px = 0, .lost_share = 0.3}, how);
  int came = 0;
  std::uint64_t last = 0;
  for (int pair = 0; pair < 40; ++pair) {
    seeing.wait(robot, 80);
    came += seeing.camera.newest().number != last ? 1 : 0;
    last = seeing.camera.newest().number;
  }
  EXPECT_GT(came, 16);
  EXPECT_LT(came, 36);
  EXPECT_GT(last, 35U) << "the numbers go on";
}

TEST_F(StereoCameraTest, ItsErrorsGrowWithTheMismatch) {
  const auto off = [this](std::uint64_t seed, double scale) {
    return draw_camera_mismatch(file_of_camera_, seed, scale);
  };
  const CameraMismatch none = off(3, 0.0);
  EXPECT_EQ(none.lens[0].fx_px, file_of_camera_.lens[0].fx_px);
  EXPECT_TRUE(none.in_link[1].isApprox(file_of_camera_.in_link(Side::right)));
  double focal = 0.0, turn = 0.0, between_deg = 0.0;
  constexpr int kRobots = 400;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    const CameraMismatch one = off(seed, 1.0), two = off(seed, 2.0);
    const double share = one.lens[0].fx_px / file_of_camera_.lens[0].fx_px - 1.0;
    EXPECT_NEAR(two.lens[0].fx_px / file_of_camera_.lens[0].fx_px - 1.0, 2.0 * share, 1e-9);
    focal += share * share;
    const Eigen::AngleAxisd mount((file_of_camera_.left_in_link.inverse() * one.in_link[0]).linear());
    turn += mount.angle() * mount.angle() / 3.0;
    const Eigen::AngleAxisd between(
        (file_of_camera_.right_in_left.inverse() * one.in_link[0].inverse() * one.in_link[1]).linear());
    between_deg += std::pow(between.angle() / facts::kRadPerDegree, 2) / 3.0;
  }
  EXPECT_NEAR(std::sqrt(focal / kRobots), 0.001, 0.0001);
  EXPECT_NEAR(std::sqrt(turn / kRobots) / facts::kRadPerDegree, 0.2, 0.02);
  EXPECT_NEAR(std::sqrt(between_deg / kRobots), 0.02, 0.002);
}

TEST_F(StereoCameraTest, ARobotThatIsFarOffHasALensThatStillSees) {
  PlantOptions how = options(kRoom);
  const Plant robot(model_, how);
  how.mismatch = 6.0;
  for (how.seed = 1; how.seed <= 5; ++how.seed) EXPECT_NO_THROW(see(how)->wait(robot, 60)) << how.seed;
}

// The file's own lens sees all of its picture; that of some robots which are a little off would not.
TEST_F(StereoCameraTest, ALensWithoutRoomForItsMismatchIsRefusedForEachSeed) {
  file_of_camera_.lens[0] = {.fx_px = 160, .fy_px = 160, .cx_px = 160, .cy_px = 120, .distortion = {-0.0945}};
  PlantOptions how = options(kRoom);
  const Plant robot(model_, how);
  see(how)->wait(robot, 60);  // a camera that is as its file says
  how.mismatch = 1.0;
  for (how.seed = 1; how.seed <= 12; ++how.seed) {
    try {
      see(how)->wait(robot, 60);
      ADD_FAILURE() << "taken with seed " << how.seed;
    } catch (const urdf::RobotError& error) {
      for (const char* const said : {"camera.yaml", "left.distortion", "-0.0945", "turn back"}) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr(said));
      }
    }
  }
}

TEST_F(StereoCameraTest, SeesWhatIsPutIntoItsWorldAndGoesOn) {
  const PlantOptions how = options(kBright);
  Plant robot(model_, how);
  const auto seeing = see(how);
  seeing->wait(robot, 85);  // a pair is being taken
  robot.put(ball("ball", {1.0, 0.0, 0.5}, 0.2), {0.0, 0.0, 0.0}, std::nullopt);
  seeing->wait(robot, 70);
  EXPECT_EQ(seeing->camera.newest().number, 1U) << "the pair during which the world changed is lost";
  seeing->wait(robot, 60);
  EXPECT_EQ(seeing->camera.newest().number, 3U);
  EXPECT_GT(
      dark_around(seeing->camera.newest(), Side::left, pixel_of(robot, {1.0, 0.0, 0.5}, Side::left), 30.0)
          .pixels,
      500);
}

// The next pair, drawn by the process itself and by copies of it, and by a copy of the copy.
TEST_F(StereoCameraTest, AForkedCopyDrawsOnTheSame) {
  const PlantOptions how = options(kRoom);
  const Plant robot(model_, how);
  const auto seeing = see(how);
  seeing->wait(robot, 60);
  const auto goes_on = [&](int copies, const auto& self) -> std::size_t {
    std::array<int, 2> ends{};
    if (copies > 0) {
      EXPECT_EQ(pipe(ends.data()), 0);
      const pid_t copy = fork();
      if (copy == 0) {
        alarm(20);  // a renderer whose threads are gone would wait for ever
        const std::size_t hash = self(copies - 1, self);
        _exit(write(ends[1], &hash, sizeof hash) == sizeof hash ? 0 : 1);
      }
      std::size_t hash = 0;
      close(ends[1]);
      EXPECT_EQ(read(ends[0], &hash, sizeof hash), static_cast<ssize_t>(sizeof hash))
          << "the copy drew nothing";
      close(ends[0]);
      int status = 0;
      waitpid(copy, &status, 0);
      return hash;
    }
    seeing->camera.begin({.how = CameraFault::How::dead, .camera = CameraFault::Camera::right},
                         seeing->now_ns);
    seeing->wait(robot, 100);
    const auto& grey = seeing->camera.newest().grey[0];
    return std::hash<std::string_view>{}({reinterpret_cast<const char*>(grey.data()), grey.size()});
  };
  const std::size_t by_copy = goes_on(1, goes_on), by_its_copy = goes_on(2, goes_on);
  const std::size_t by_itself = goes_on(0, goes_on);
  EXPECT_EQ(by_copy, by_itself);
  EXPECT_EQ(by_its_copy, by_itself);
  EXPECT_NE(by_itself, 0U);
}

}  // namespace
}  // namespace gaitway::simulator

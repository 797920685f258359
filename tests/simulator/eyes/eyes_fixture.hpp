// A robot with its camera, in a world of the test's own.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "../world_fixture.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/simulator/stereo_camera.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::simulator {

class EyesTest : public WorldTest {
 protected:
  // A light floor and light walls all around, so that what is black is a ball or a pole.
  static constexpr const char* kBright =
      "surfaces: {white: {plain: [0.9, 0.9, 0.9]}}\nfloor: {surface: white}\nlights: [{sun: [0.2, 0.1, -1], "
      "colour: [0.5, 0.5, 0.5]}]\n";

  struct Seeing {
    Seeing(const urdf::RobotModel& robot, const urdf::StereoCamera& file, const StereoCameraOptions& how,
           const PlantOptions& plant)
        : client(block.local_client("camera")), camera(client, robot, file, how, plant) {}
    msgclient::MemoryBlock block;
    msgclient::Client client;
    StereoCamera camera;
    std::int64_t now_ns = 0;

    // The robot stands still, as a statue does.
    void wait(const Plant& plant, int ms, bool wanted = true) {
      for (int i = 0; i < ms; ++i, now_ns += 1'000'000) camera.step(now_ns, plant, wanted);
    }
  };

  [[nodiscard]] std::unique_ptr<Seeing> see(const PlantOptions& plant, StereoCameraOptions how = {}) const {
    how.lost_share = 0.0;
    return std::make_unique<Seeing>(model_, file_of_camera_, how, plant);
  }

  // By the kinematics of the description alone.
  [[nodiscard]] Eigen::Isometry3d head_pose(const Plant& plant) const {
    urdf::ForwardKinematics kinematics(model_);
    kinematics.compute(plant.positions().subspan(7, model_.joints.size()));
    return plant.truth().base * kinematics.link_pose(model_.link_index("head"));
  }
  // Where a point is in the picture of the camera that its file describes.
  [[nodiscard]] Eigen::Vector2d pixel_of(const Plant& plant, const Eigen::Vector3d& point_m,
                                         urdf::Side side) const {
    const Eigen::Isometry3d optical = head_pose(plant) * file_of_camera_.in_link(side);
    return urdf::Lens(file_of_camera_.lens[urdf::index_of(side)])
        .project(optical.inverse() * point_m)
        .value();
  }

  struct Blob {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    int pixels = 0;
  };
  // Of what is darker than half of the light around it, no farther than that from a place.
  [[nodiscard]] static Blob dark_around(const PicturePair& pair, urdf::Side side,
                                        const Eigen::Vector2d& place, double reach_px) {
    const auto& grey = pair.grey[urdf::index_of(side)];
    Blob blob;
    double weight = 0.0;
    for (int row = 0; row < pair.height_px; ++row) {
      for (int column = 0; column < pair.width_px; ++column) {
        const Eigen::Vector2d pixel(column, row);
        const double dark = 60.0 - grey[static_cast<std::size_t>(row * pair.width_px + column)];
        if (dark <= 0.0 || (pixel - place).cwiseAbs().maxCoeff() > reach_px) continue;
        blob.centre += dark * pixel;
        weight += dark;
        ++blob.pixels;
      }
    }
    if (weight > 0.0) blob.centre /= weight;
    return blob;
  }
  static world::Solid ball(const std::string& name, const Eigen::Vector3d& place_m, double diameter_m) {
    world::Solid solid;
    solid.shape = world::Solid::Shape::sphere;
    solid.name = name;
    solid.pose = Eigen::Translation3d(place_m) * Eigen::Isometry3d::Identity();
    solid.size_m.setConstant(diameter_m);
    return solid;
  }
  static double mean(const std::vector<std::uint8_t>& grey) {
    double sum = 0.0;
    for (const std::uint8_t pixel : grey) sum += pixel;
    return sum / static_cast<double>(grey.size());
  }

  urdf::StereoCamera file_of_camera_ = urdf::stereo_camera_of(model_).value();
};

}  // namespace gaitway::simulator

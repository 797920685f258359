// The simulated robot's stereo camera: pairs of pictures of the world as the camera's lenses, shutter and
// sensors give them, and the topic on which they come. What it leaves out is in docs/simulator.md.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/simulator/camera_fault.hpp"
#include "gaitway/simulator/plant.hpp"
#include "gaitway/urdf/camera_file.hpp"

namespace gaitway::simulator {

struct StereoCameraOptions {
  bool always = false;  // take pictures even if no plug-in reads them
  int shadow_px = 512;  // side of the shadow map; 0: no shadows, in less than half of the time
  bool auto_exposure = true;
  double fixed_exposure = 1.0;  // otherwise: times the camera file's; above 1 it is gain; 0.1 to 8
  double lost_share = 0.002;    // pairs that never arrive, at random
};

// How the camera on this robot differs from its file: what was drawn for it, times the mismatch.
struct CameraMismatch {
  std::array<urdf::LensParameters, 2> lens;  // [Side]: the true ones
  std::array<Eigen::Isometry3d, 2> in_link;  // [Side]: the true ones
};
[[nodiscard]] CameraMismatch draw_camera_mismatch(const urdf::StereoCamera& camera, std::uint64_t seed,
                                                  double scale);

struct PicturePair {
  std::int64_t stamp_ns = 0;  // middle of the exposure of the middle row
  std::uint64_t number = 0;   // from 1
  int width_px = 0, height_px = 0;
  std::int64_t exposure_ns = 0, readout_ns = 0;
  std::array<std::vector<std::uint8_t>, 2> grey;  // [Side]
};

// Nothing is drawn, and no OpenGL asked for, before the first pair is wanted. Deterministic to the bit for
// one seed, as far as the machine's OpenGL is. The plant and the client outlive it.
class StereoCamera {
 public:
  // Throws msgclient::TopicError when somebody else writes the topic.
  StereoCamera(msgclient::Client& client, const urdf::RobotModel& robot, const urdf::StereoCamera& camera,
               const StereoCameraOptions& options, const PlantOptions& plant);
  ~StereoCamera();
  StereoCamera(const StereoCamera&) = delete;
  StereoCamera& operator=(const StereoCamera&) = delete;

  // Once a millisecond. `wanted`: somebody reads the pictures; looked at when a pair begins.
  void step(std::int64_t now_ns, const Plant& plant, bool wanted);
  void begin(const CameraFault& fault, std::int64_t now_ns);

  // The newest pair that has come, as it was published; number 0: none yet.
  [[nodiscard]] const PicturePair& newest() const noexcept;
  [[nodiscard]] std::string_view topic() const noexcept;
  // Why there are no pictures although they are wanted; empty: there are.
  [[nodiscard]] const std::string& failure() const noexcept;
  [[nodiscard]] const CameraMismatch& truth() const noexcept;  // for reports and tests alone

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// Both pictures side by side, the left one left, as a PNG. Throws std::runtime_error naming the file.
void write_pair(const std::string& file, const PicturePair& pair);

}  // namespace gaitway::simulator

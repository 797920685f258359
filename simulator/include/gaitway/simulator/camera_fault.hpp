// What goes wrong with a stereo camera, as a scenario has it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace gaitway::simulator {

struct CameraFault {
  enum class How : std::uint8_t {
    dead,          // black, without noise
    dark,          // a hundredth of the light reaches it
    over_exposed,  // forty times the light that its exposure is right for
    exchanged,     // left is right
    turned,        // a knock has turned it in its mount
    dropped,       // pairs are lost
    late,          // pairs come later
    frozen         // the same picture again and again
  };
  enum class Camera : std::uint8_t { left, right, both };

  How how = How::dead;
  Camera camera = Camera::both;  // of exchanged, dropped and late: always both
  double duration_s = 0.0;       // 0: for ever
  Eigen::Vector3d turn_deg{0.7, 0.7,
                           0.0};  // of turned: rotation vector in its optical frame; here by 1 degree
  double share = 1.0;             // of dropped: of the pairs
  double later_s = 0.3;           // of late
};

inline constexpr std::array<std::pair<std::string_view, CameraFault::How>, 8> kCameraFaultNames{
    {{"dead", CameraFault::How::dead},
     {"dark", CameraFault::How::dark},
     {"over_exposed", CameraFault::How::over_exposed},
     {"exchanged", CameraFault::How::exchanged},
     {"turned", CameraFault::How::turned},
     {"dropped", CameraFault::How::dropped},
     {"late", CameraFault::How::late},
     {"frozen", CameraFault::How::frozen}}};
inline constexpr std::array<std::pair<std::string_view, CameraFault::Camera>, 3> kCameraNames{
    {{"left", CameraFault::Camera::left},
     {"right", CameraFault::Camera::right},
     {"both", CameraFault::Camera::both}}};

}  // namespace gaitway::simulator

// The whole simulated robot as one object, for the tests of plug-ins: physics, joints, bus, controllers, and
// the plug-ins of the shipped configuration with the author's own among them. Needs no header but the
// topics'.
//
//   gaitway::SimulatedRobot robot({.with = {"build/libsway.so"}});
//   robot.walk(0.15);
//   robot.run_for(10.0);
//   EXPECT_TRUE(robot.is_upright());
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gaitway/msgclient/topics.hpp"

#define GAITWAY_SIMULATOR_EXPORT __attribute__((visibility("default")))

namespace gaitway {

struct SimulationOptions {
  std::vector<std::filesystem::path> with = {};  // plug-in libraries, put in as `gaitway run --with` does
  std::filesystem::path config = {};             // empty: the shipped one
  std::filesystem::path robot = {};              // empty: humanoid22
  std::uint64_t seed = 1;
  double mismatch = 1.0;   // how little the plug-ins know of the body's true masses and zeros
  std::string world = {};  // a file, or the name of a shipped one; empty: an endless floor
};

// Where the pelvis is, in the world; x, y and heading are 0 at the start.
struct Whereabouts {
  double x_m = 0.0, y_m = 0.0;
  double height_m = 0.0;
  double heading_rad = 0.0;  // counter-clockwise, whole turns counted
};

// Deterministic to the bit for one seed and one sequence of calls. Use from one thread, and while no other
// thread runs in the process. What throws throws std::exception with a text that names plug-in, place and
// remedy.
class GAITWAY_SIMULATOR_EXPORT SimulatedRobot {
 public:
  explicit SimulatedRobot(const SimulationOptions& options = {});
  ~SimulatedRobot();
  SimulatedRobot(SimulatedRobot&&) noexcept;
  SimulatedRobot& operator=(SimulatedRobot&&) noexcept;

  // The newest command counts. Both throw if a plug-in writes walk_command.
  void walk(double forward_m_per_s, double left_m_per_s = 0.0, double turn_rad_per_s = 0.0);
  void stand();
  // A force at a link's centre of mass, in the world frame, that gives the impulse in a tenth of a second.
  void push(std::string_view link, const std::array<double, 3>& impulse_Ns);
  // Lets virtual time go on; less when the robot falls.
  void run_for(double seconds);

  [[nodiscard]] double time_s() const;
  [[nodiscard]] bool is_upright() const;
  [[nodiscard]] Whereabouts whereabouts() const;
  // What the encoder says, and what the joint was told to do. Throws for a name that the robot does not have.
  [[nodiscard]] double joint_position(std::string_view joint) const;
  [[nodiscard]] double joint_reference(std::string_view joint) const;

  // The newest value of a topic. Throws while there is none.
  template <class T>
  [[nodiscard]] T topic(std::string_view name) const {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    read_topic(name, TopicType<T>::name, TopicType<T>::hash, sizeof(T), &value);
    return value;
  }

  // What plug-ins reported, and every fault: the newest 256 lines, "name: text".
  [[nodiscard]] std::vector<std::string> events() const;
  // How often the plug-in of that name threw or wrote nonsense. Throws if there is none of that name.
  [[nodiscard]] std::uint64_t faults(std::string_view plugin) const;
  // Batches that the message controller accepted; one each 80 ms while all is well.
  [[nodiscard]] std::uint64_t batches_accepted() const;

 private:
  void read_topic(std::string_view name, std::string_view type_name, std::uint64_t type_hash,
                  std::size_t size, void* value) const;

  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gaitway

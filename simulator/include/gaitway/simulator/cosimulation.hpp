// The whole chain in one process and in virtual time: physics, 22 local controllers, the CAN bus in its own
// microsecond events, the message controller, and the main controller with its plug-ins. Deterministic to the
// bit for one seed. Order inside one millisecond: physics, local controllers, message controller and main
// controller at their instants, bus.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "gaitway/can/simulated/simulated_bus.hpp"
#include "gaitway/can/simulated/station_transmitter.hpp"
#include "gaitway/core/main_controller.hpp"
#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/msgcontroller/command_arbiter.hpp"
#include "gaitway/msgcontroller/message_controller.hpp"
#include "gaitway/simulator/joint_network.hpp"
#include "gaitway/simulator/localization.hpp"
#include "gaitway/simulator/plant.hpp"
#include "gaitway/simulator/scenario.hpp"
#include "gaitway/simulator/sensor_faults.hpp"
#include "gaitway/simulator/stereo_camera.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

struct CosimulationOptions {
  PlantOptions plant;
  double largest_clock_drift_ppm = 50.0;
  core::MainControllerOptions main_controller;
  // People command the robot from outside, by the topics of requests: walk, way, motion and head events are
  // refused.
  bool people_outside = false;
  // To be shared with other processes; it outlives the run. nullptr: a block of its own.
  msgclient::MemoryBlock* memory_block = nullptr;
  LocalizationOptions localization;
  StereoCameraOptions camera;  // of a robot that has one; without a reader or `always` it takes no pictures
  // What the main controller's work is charged in virtual time: from a tick to its mails lying in the window.
  std::int64_t tick_cost_ns = 100'000;
  std::int64_t batch_cost_ns = 500'000;
  // Whether the message controller's frame that waits for the bus gives way to a more urgent one; not so on a
  // CAN interface of an operating system.
  bool message_port_takes_back = true;
};

// Sees everything that happens, in order; the run's recorder is one.
class CosimulationObserver {
 public:
  virtual ~CosimulationObserver() = default;
  virtual void on_frame(const can::SimulatedBus::Delivery& delivery) = 0;
  // After every millisecond.
  virtual void on_millisecond(std::int64_t now_ns) = 0;
  // What somebody outside has asked for has become the command, before the millisecond that begins at
  // `now_ns`.
  virtual void on_orders(const msgcontroller::PassedOrders&, std::int64_t /*now_ns*/) {}
};

class Cosimulation {
 public:
  Cosimulation(const urdf::RobotModel& robot, const CosimulationOptions& options);
  Cosimulation(const Cosimulation&) = delete;
  Cosimulation& operator=(const Cosimulation&) = delete;
  ~Cosimulation();

  void observe(CosimulationObserver* observer) noexcept { observer_ = observer; }
  void advance_millisecond();

  // From outside; all of it takes effect in the millisecond that comes next. Throws std::invalid_argument for
  // a walk or motion event when somebody else commands the robot, urdf::RobotError for a fault of a plug-in
  // that is not there.
  void apply(const ScenarioEvent& event);

  // For a copy of this process that fork() made: the run goes on in it without a trace in the process that it
  // came from, as long as that one waits. Not where plug-ins have processes or threads of their own, which
  // are not copied. Once; copies of the copy go on by themselves. Throws std::system_error.
  void keep_to_this_process() { memory_block_.keep_to_this_process(); }
  // From now on people command the robot, as with `people_outside` from the start: requests that lie in
  // the topics already do not count, and a walk that the scenario asked for ends soon, as that of somebody
  // who has gone; a way or motion goes on.
  void hand_to_people();

  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  [[nodiscard]] Plant& plant() noexcept { return plant_; }
  [[nodiscard]] const Plant& plant() const noexcept { return plant_; }
  [[nodiscard]] const JointNetwork& joints() const noexcept { return joints_; }
  [[nodiscard]] const can::SimulatedBus& bus() const noexcept { return bus_; }
  [[nodiscard]] const msgcontroller::MessageController& message_controller() const noexcept {
    return *message_controller_;
  }
  [[nodiscard]] const core::MainController& main_controller() const noexcept { return *main_controller_; }
  // nullptr: the robot has none.
  [[nodiscard]] const StereoCamera* camera() const noexcept { return camera_.get(); }
  // For changes between two milliseconds.
  [[nodiscard]] core::PluginManager& plugins() noexcept { return main_controller_->plugins(); }
  [[nodiscard]] msgclient::Client& client() noexcept { return observer_client_; }
  // From now on nobody's orders are obeyed any more, and the robot comes to a stand.
  void end_orders() { arbiter_->end(now_ns_); }
  [[nodiscard]] const msgcontroller::CommandArbiter& arbiter() const noexcept { return *arbiter_; }
  [[nodiscard]] bool people_outside() const noexcept { return options_.people_outside; }
  [[nodiscard]] const urdf::RobotModel& robot() const noexcept { return robot_; }

 private:
  void main_controller_tick();
  void start_message_controller();
  void start_main_controller();
  void finish_silence();
  [[nodiscard]] bool message_controller_works() const noexcept { return message_silent_until_ns_ == 0; }
  void inject(const MessageControllerSilentFault& fault);
  void exchange_frames(std::int64_t until_ns);
  void deliver(const can::SimulatedBus::Delivery& delivery);
  void offer_from_message_controller(std::int64_t now_ns);
  void offer_from_joint(int joint, std::int64_t now_ns);
  void ring_at(std::int64_t due_ns);
  void report_bus_states();
  void report_errors();
  void inject_losses();
  [[nodiscard]] int station_of(const std::string& node) const;
  void restart(const JointRestartsFault& fault);
  void finish_restarts();
  void inject(const PluginFault& fault);
  void ask(const msgclient::UserCommandMail& mail);
  void order(const WalkEvent& walk);
  void order(const MotionEvent& motion);
  void order(const WalkToEvent& way);
  void order(const HeadEvent& head);
  void demand_that_scenario_commands(const char* what) const;
  void change_world(const SpawnEvent& spawn);
  void inject(const CameraFault& fault);
  void inject(const MissesFramesFault& fault);
  void inject(const BatchFault& fault);
  void hand_over_wrongly(BatchFault::How how);
  [[nodiscard]] bool is_in_losses(const can::Frame& frame) const;

  urdf::RobotModel robot_;
  CosimulationOptions options_;
  std::int64_t now_ns_ = 0;
  std::optional<msgclient::MemoryBlock> own_block_;
  msgclient::MemoryBlock& memory_block_;
  msgclient::EmiAdapter adapter_;
  msgclient::Client message_client_, arbiter_client_, observer_client_, main_client_, localization_client_,
      camera_client_;
  Plant plant_;
  JointNetwork joints_;
  SensorFaults sensor_faults_;
  can::SimulatedBus bus_;
  // In one process, which may die and be started again.
  std::optional<msgcontroller::CommandArbiter> arbiter_;
  std::optional<msgcontroller::MessageController> message_controller_;
  core::PluginFaultTable plugin_faults_;
  std::unique_ptr<core::MainController> main_controller_;
  std::uint32_t motions_asked_ = 0, ways_asked_ = 0;
  std::optional<Localization> localization_;
  std::unique_ptr<StereoCamera> camera_;  // none: the robot has none
  CosimulationObserver* observer_ = nullptr;

  can::StationTransmitter message_transmitter_;
  std::vector<can::StationTransmitter> joint_transmitters_;
  int foreign_station_ = 0;                 // of nodes that do not belong there
  std::vector<can::Frame> foreign_frames_;  // one a millisecond
  struct Restart {
    int joint = 0;
    std::int64_t until_ns = 0;  // without power
  };
  std::vector<Restart> restarts_;
  std::int64_t disturbed_until_ns_ = 0;         // 0: it is not
  std::vector<std::int64_t> doorbells_due_ns_;  // host→message, in order of time
  std::int64_t silent_until_ns_ = 0;            // the main controller makes no tick before
  std::int64_t message_silent_until_ns_ = 0;    // 0: the message controller works
  std::int64_t silent_since_ns_ = 0;            // the message controller, last
  bool message_controller_restarts_ = false;    // after its silence
  std::int64_t busy_until_ns_ = 0;              // with a tick that injected faults made long
  std::int64_t losses_until_ns_ = 0;
  double loss_probability_ = 0.0;
  int losses_of_joint_ = -1;  // only frames of its batches are lost; -1: all frames
  std::uint32_t user_commands_ = 0;
  std::mt19937_64 fault_random_;
};

}  // namespace gaitway::simulator

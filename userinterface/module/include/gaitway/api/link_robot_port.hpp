// The robot as the sessions reach it: orders over the link, answers back, what it tells of itself out of the
// mirror.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gaitway/api/module_link.hpp"
#include "gaitway/api/robot_port.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

class Recorder;

// For one thread.
class LinkRobotPort final : public RobotPort {
 public:
  // Throws msgclient::TopicError. All references outlive it. `recorder`: nullptr: recording is refused.
  LinkRobotPort(ModuleLink& link, const urdf::RobotModel& robot, Recorder* recorder);

  // Tells it the time, by the link's clock; before whatever is asked of it.
  void observe(std::int64_t now_ns) noexcept;

  [[nodiscard]] std::int64_t now_ns() const override;
  [[nodiscard]] bool connected() const override { return connected_; }
  [[nodiscard]] std::string_view silent_part() const override {
    return link_.open() ? "message controller" : "main controller";
  }
  [[nodiscard]] bool emergency_stopped() const override;
  [[nodiscard]] std::string_view activity() const override;
  std::optional<std::uint32_t> walk(const Velocity& velocity, std::int64_t holds_ns,
                                    std::int64_t age_ns) override;
  void stand() override;
  std::optional<std::uint32_t> stop() override;
  std::optional<std::uint32_t> emergency_stop(bool soft) override;
  std::optional<std::uint32_t> release(std::int64_t age_ns) override;
  std::optional<std::uint32_t> move_joint(int joint, double position_rad, double duration_s,
                                          std::int64_t age_ns) override;
  std::optional<std::uint32_t> play_motion(std::string_view name, std::int64_t age_ns) override;
  std::optional<std::uint32_t> walk_to(const Goal& goal, std::int64_t age_ns) override;
  std::optional<std::uint32_t> leave_way(std::int64_t age_ns) override;
  std::optional<std::uint32_t> look(const Look& look, std::int64_t age_ns) override;
  std::optional<std::uint32_t> take_command(std::int64_t age_ns) override;
  std::optional<std::uint32_t> let_command_go(std::int64_t age_ns) override;
  std::optional<std::uint32_t> mission(MissionVerb verb, std::string_view mission,
                                       std::int64_t age_ns) override;
  std::optional<std::uint32_t> order(const PluginOrder& order) override;
  std::optional<OrderResult> take_result() override;
  [[nodiscard]] const std::vector<JointLimits>& joints() const override { return joints_; }
  [[nodiscard]] std::vector<PluginStatus> plugins() const override;
  std::uint32_t start_recording(std::string_view name) override;
  std::uint32_t stop_recording() override;
  std::uint32_t list_recordings(std::size_t most) override;

 private:
  [[nodiscard]] Recorder& recorder() const;

  ModuleLink& link_;
  Recorder* recorder_;
  msgclient::Client client_;
  std::vector<JointLimits> joints_;
  mutable msgclient::Reader<PluginStatistics> statistics_;
  mutable msgclient::Reader<NetworkState> network_;
  mutable msgclient::Reader<MotionState> motion_states_;
  mutable msgclient::Reader<Estimate> estimates_;
  mutable msgclient::Reader<PlannedState> planned_;
  std::int64_t now_ns_ = 0;  // by the link's clock
  std::int64_t heartbeat_ns_ = 0, heard_ns_ = 0;
  bool connected_ = false;
};

}  // namespace gaitway::api

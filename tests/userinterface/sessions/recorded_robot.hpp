// A robot that writes down what it is told, and answers orders when the test says so.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gaitway/api/robot_port.hpp"

namespace gaitway::api {

class RecordedRobot : public RobotPort {
 public:
  std::vector<std::string> told;  // "walk", "stand", "stop", ... in their order
  std::vector<Velocity> velocities;
  std::vector<std::int64_t> validities_ns, ages_ns;  // of velocities
  std::vector<Look> looks;
  std::vector<PluginOrder> orders;
  std::string moved_joint;  // "2 0.5 1.5": joint, position, duration
  std::deque<OrderResult> results;
  std::vector<PluginStatus> plugin_list{
      {.name = "stability", .state = "works", .steps = 7, .worst_step_us = 12.5}};
  std::vector<JointLimits> joint_list{{"neck_yaw", -1.0, 1.0}, {"left_knee", 0.0, 2.0}};
  std::int64_t time_ns = 0;
  bool is_connected = true;
  std::string silent = "message controller";
  bool is_blocked = false;  // takes no orders
  bool is_emergency_stopped = false;
  std::string does = "stands";
  bool walking = false;  // told to walk, and not told to stop since
  bool recording = false;
  std::vector<RecordingStatus> recording_list;
  std::uint32_t last_number = 0;
  std::uint32_t last_velocity = 1'000'000;  // its number

  [[nodiscard]] std::int64_t now_ns() const override { return time_ns; }
  [[nodiscard]] bool connected() const override { return is_connected; }
  [[nodiscard]] std::string_view silent_part() const override { return silent; }
  [[nodiscard]] bool emergency_stopped() const override { return is_emergency_stopped; }
  [[nodiscard]] std::string_view activity() const override { return does; }

  std::optional<std::uint32_t> walk(const Velocity& velocity, std::int64_t valid_ns,
                                    std::int64_t age_ns) override {
    ages_ns.push_back(age_ns);
    told.emplace_back("walk");
    velocities.push_back(velocity);
    validities_ns.push_back(valid_ns);
    walking = true;
    return is_blocked ? std::nullopt : std::optional(++last_velocity);
  }
  void stand() override {
    told.emplace_back("stand");
    walking = false;
  }
  std::optional<std::uint32_t> stop() override { return note("stop"); }
  std::optional<std::uint32_t> emergency_stop(bool soft) override {
    return note(soft ? "emergency_stop soft" : "emergency_stop hold");
  }
  std::optional<std::uint32_t> release(std::int64_t) override { return note("release"); }
  std::optional<std::uint32_t> move_joint(int joint, double position_rad, double duration_s,
                                          std::int64_t) override {
    moved_joint =
        std::to_string(joint) + " " + std::to_string(position_rad) + " " + std::to_string(duration_s);
    return note("move_joint");
  }
  std::optional<std::uint32_t> play_motion(std::string_view name, std::int64_t) override {
    if (name.empty()) {
      return std::nullopt;  // what a stand means, too, and nobody waits for
    }
    return note("play_motion " + std::string(name));
  }
  std::optional<std::uint32_t> walk_to(const Goal& goal, std::int64_t) override {
    return note("walk_to " + std::to_string(goal.x_m) + " " + std::to_string(goal.y_m) + " " +
                std::to_string(goal.yaw_rad));
  }
  std::optional<std::uint32_t> leave_way(std::int64_t) override { return note("leave_way"); }
  std::optional<std::uint32_t> look(const Look& look, std::int64_t) override {
    looks.push_back(look);
    return note("look");
  }
  std::optional<std::uint32_t> take_command(std::int64_t) override { return note("take_command"); }
  std::optional<std::uint32_t> let_command_go(std::int64_t) override {
    if (!is_blocked) walking = false;
    return note("let_command_go");
  }
  std::optional<std::uint32_t> mission(MissionVerb verb, std::string_view mission, std::int64_t) override {
    return note("mission " + std::to_string(static_cast<int>(verb)) + " " + std::string(mission));
  }
  std::optional<std::uint32_t> order(const PluginOrder& order) override {
    orders.push_back(order);
    return note("order");
  }
  std::optional<OrderResult> take_result() override {
    if (results.empty()) {
      return std::nullopt;
    }
    OrderResult result = results.front();
    results.pop_front();
    return result;
  }

  [[nodiscard]] const std::vector<JointLimits>& joints() const override { return joint_list; }
  [[nodiscard]] std::vector<PluginStatus> plugins() const override { return plugin_list; }

  std::uint32_t start_recording(std::string_view name) override {
    const bool was = std::exchange(recording, true);
    return finish(!was, was ? "a recording is under way" : "/recordings/" + std::string(name) + ".mcap");
  }
  std::uint32_t stop_recording() override {
    const bool was = std::exchange(recording, false);
    return finish(was, was ? "/recordings/walk.mcap" : "no recording is under way");
  }
  std::uint32_t list_recordings(std::size_t most) override {
    RecordingList list{recording_list, recording_list.size()};
    list.newest.resize(std::min(most, list.count));
    return finish(true, "", std::move(list));
  }

 private:
  std::uint32_t finish(bool done, std::string text, RecordingList recordings = {}) {
    results.push_back({++last_number, done, std::move(text), std::move(recordings)});
    return last_number;
  }
  std::optional<std::uint32_t> note(std::string_view what) {
    told.emplace_back(what);
    return is_blocked ? std::nullopt : std::optional(++last_number);
  }
};

}  // namespace gaitway::api

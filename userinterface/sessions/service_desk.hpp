// Where calls of services are answered: at once, or when the robot has said what became of an order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "gait_bounds.hpp"
#include "gaitway/api/limits.hpp"
#include "gaitway/api/robot_port.hpp"
#include "gaitway/api/service_table.hpp"
#include "gaitway/api/simulation_port.hpp"
#include "orders.hpp"
#include "robot_commands.hpp"
#include "rosapi.hpp"
#include "service_call.hpp"
#include "simulation_services.hpp"
#include "stand_waits.hpp"

namespace gaitway::api {

inline constexpr std::string_view kWayIsFull = "the robot takes no order now, since too many wait: try again";

class ServiceDesk {
 public:
  // Takes an answer to its client, if that is still there.
  using Send = std::function<void(const ServiceCall& call, Frame frame)>;

  ServiceDesk(RobotPort& robot, const SimulationPorts& simulation, RobotCommands& commands,
              const Limits& limits, ParameterValues parameters, const ClientOffers& offers, Send send);
  ServiceDesk(const ServiceDesk&) = delete;
  ServiceDesk& operator=(const ServiceDesk&) = delete;

  // Answers by `send`, now or later; never throws for what a client wrote. `arguments`: an object or a list.
  void call(const ServiceCall& call, const nlohmann::json& arguments, Claimant& claimant,
            std::int64_t now_ns);
  // An order that its client waits for no answer of: `refused` is called if it is not carried out, while the
  // client is there.
  void watch(std::uint32_t order, const Claimant& claimant, std::int64_t now_ns,
             std::function<void(const std::string& why)> refused);
  // Takes what the robot says, and ends what has waited for too long.
  void step(std::int64_t now_ns) {
    orders_.step(now_ns);
    if (simulation_) {
      simulation_->step(now_ns);
    }
    stands_.step(now_ns);
    gait_.step(now_ns);
    commands_.keep_to(gait_.bounds());
  }
  // The link to the robot was lost, or is there again.
  void robot_lost() {
    stands_.robot_lost();
    gait_.robot_lost();
  }
  // As last heard, since it was last taken; nothing, too, where there is no simulation.
  [[nodiscard]] std::optional<ros::SimulationState> take_simulation_state() {
    return simulation_ ? simulation_->take_state() : std::nullopt;
  }
  [[nodiscard]] std::optional<ros::TwinState> take_twin_state() {
    return simulation_ ? simulation_->take_twin() : std::nullopt;
  }
  // The connection has ended: its orders are answered to nobody.
  void leave(const Claimant& claimant);

 private:
  struct Caller {
    const ServiceCall& call;
    const nlohmann::json& arguments;  // not kept with the call, since they may be large
    Claimant& claimant;
    std::int64_t now_ns;
  };
  struct Answers;
  struct ParameterReading;  // of a plug-in's parameters: one order each

  void answer(const ServiceRow& row, const Caller& caller);

  void stand(const Caller& caller);
  void answer_stand(const ServiceCall& call, StandWaits::Outcome outcome, const std::string& text);
  void stop(const Caller& caller);
  void emergency_stop(const Caller& caller);
  void release(const Caller& caller);
  void tell_walk_limits(const Caller& caller);
  void move_joint(const Caller& caller);
  void play_motion(const Caller& caller);
  void walk_to(const Caller& caller);
  void leave_way(const Caller& caller);
  void look(const Caller& caller);
  void take_command(const Caller& caller);
  void let_command_go(const Caller& caller);
  template <MissionVerb verb>
  void change_mission(const Caller& caller) {
    change_mission(verb, caller);
  }
  void start_mission(const Caller& caller);
  void change_mission(MissionVerb verb, const Caller& caller);
  void simulate(const Caller& caller);
  void start_recording(const Caller& caller);
  void stop_recording(const Caller& caller);
  void list_recordings(const Caller& caller);
  void list_plugins(const Caller& caller);
  template <PluginVerb verb>
  void change_plugin(const Caller& caller) {
    change_plugin(verb, caller);
  }
  void change_plugin(PluginVerb verb, const Caller& caller);
  void set_parameter(const Caller& caller);
  void get_parameters(const Caller& caller);
  void get_parameter_names(const Caller& caller);
  // One plug-in after the other, from the last one of `plugins` on; then `done`, with what the last one told.
  void read_parameters(const Caller& caller, std::vector<std::string> plugins,
                       std::function<void(const ros::GetParameters::Response&)> done);
  void read_parameter(const ServiceCall& call, ParameterReading reading);
  bool keep_parameter(ParameterReading& reading, const OrderResult& result);
  void set_rosapi_parameter(const Caller& caller);
  void refuse_deletion(const Caller& caller);
  void acquire_command(const Caller& caller);
  void keep_alive(const Caller& caller);
  void release_command(const Caller& caller);
  void require_plugin(const std::string& name) const;
  // A recording is ended by who began it, by who commands, and by anybody once its beginner has gone.
  void require_own_recording(const Claimant& claimant) const;
  void deny(const ServiceRow& row, const ServiceCall& call, std::string_view why) const;

  template <class S>
  [[nodiscard]] static typename S::Request request(const Caller& caller) {
    return request_of<typename S::Request>(caller.arguments);
  }
  template <Message M>
  void reply(const ServiceCall& call, const M& response) const {
    send_(call, service_response(call, response));
  }
  // S is a service of rosapi.
  template <class S>
  void reply_rosapi(const Caller& caller) {
    reply(caller.call, rosapi_.answer(request<S>(caller)));
  }
  // When the caller has waited long enough.
  [[nodiscard]] std::int64_t end_of_wait(const Caller& caller) const noexcept {
    return caller.now_ns + std::min(caller.call.timeout_ns, limits_.answer_ns);
  }
  // `respond`: when the robot has said what became of the order.
  void await_result(const Caller& caller, std::uint32_t order,
                    std::function<void(const ServiceCall& call, const OrderResult& result)> respond);
  // Makes S's response out of the order's result. `done`: called before, when it was carried out.
  template <class S>
  void await(const Caller& caller, std::optional<std::uint32_t> order, std::function<void()> done = {}) {
    if (!order) {
      return reply(caller.call, typename S::Response{false, std::string(kWayIsFull)});
    }
    await_result(caller, *order, [this, done = std::move(done)](const auto& call, const auto& result) {
      if (result.done && done) {
        done();
      }
      this->reply(call, typename S::Response{result.done, result.text});
    });
  }

  RobotPort& robot_;
  RobotCommands& commands_;
  Limits limits_;
  ParameterValues parameters_;
  std::set<std::string> read_plugins_;  // whose parameters are all in parameters_
  Send send_;
  Rosapi rosapi_;
  Orders orders_;
  std::optional<SimulationServices> simulation_;  // nothing: the robot is none
  StandWaits stands_;
  GaitWatch gait_;
  std::optional<Claimant> records_;  // who began the recording, while it is connected
};

}  // namespace gaitway::api

// Which service is answered by whom.
#include "service_desk.hpp"

#include <array>
#include <utility>

#include "client_message.hpp"
#include "gaitway/api/authority.hpp"

namespace gaitway::api {

ServiceDesk::ServiceDesk(RobotPort& robot, const SimulationPorts& simulation, RobotCommands& commands,
                         const Limits& limits, ParameterValues parameters, const ClientOffers& offers,
                         Send send)
    : robot_(robot),
      commands_(commands),
      limits_(limits),
      parameters_(std::move(parameters)),
      send_(std::move(send)),
      rosapi_(robot_, simulation.simulation != nullptr, parameters_, offers),
      orders_([&robot] { return robot.take_result(); }),
      stands_(robot_, commands_,
              [this](const ServiceCall& call, StandWaits::Outcome outcome, const std::string& text) {
                answer_stand(call, outcome, text);
              }),
      gait_(robot_, orders_) {
  if (simulation.simulation != nullptr) {
    simulation_.emplace(*simulation.simulation, simulation.twin, limits_, send_);
  }
}

void ServiceDesk::watch(std::uint32_t order, const Claimant& claimant, std::int64_t now_ns,
                        std::function<void(const std::string& why)> refused) {
  orders_.wait(
      order, claimant.number, now_ns + limits_.answer_ns,
      [refused = std::move(refused)](const OrderResult* result) {
        if (result != nullptr && !result->done) {
          refused(result->text);
        }
      },
      false);
}

void ServiceDesk::leave(const Claimant& claimant) {
  orders_.forget(claimant.number);
  stands_.forget(claimant.number);
  if (simulation_) {
    simulation_->leave(claimant.number);
  }
  if (records_ && records_->number == claimant.number) {
    records_.reset();
  }
}

void ServiceDesk::call(const ServiceCall& call, const nlohmann::json& arguments, Claimant& claimant,
                       std::int64_t now_ns) {
  const ServiceRow* const row = find_service(call.service);
  if (row == nullptr) {
    send_(call, service_failure(call, "service is " + shown(call.service) +
                                          ", but must be one that /rosapi/services lists"));
    return;
  }
  try {
    answer(*row, {call, arguments, claimant, now_ns});
  } catch (const CommandDenied& denied) {
    deny(*row, call, denied.what());
  } catch (const std::exception& error) {
    send_(call, service_failure(call, error.what()));
  }
}

void ServiceDesk::deny(const ServiceRow& row, const ServiceCall& call, std::string_view why) const {
  if (row.type == ros::SetParam::kName || row.type == ros::DeleteParam::kName) {
    return reply(call, ros::SetParam::Response{false, std::string(why)});
  }
  if (row.type.starts_with("simulation_interfaces/")) {  // which has no code for it
    return send_(call, service_failure(call, why));
  }
  if (row.type == ros::AcquireCommand::kName) {
    return reply(call, ros::AcquireCommand::Response{false, std::string(why), "", 0.0});
  }
  reply(call, ros::Trigger::Response{false, std::string(why)});
}

// Which member answers which service: an entry for each row of the table.
struct ServiceDesk::Answers {
  using Answer = void (ServiceDesk::*)(const Caller& caller);

  constexpr Answers& add(std::string_view name, Answer answer) {
    set(find_service(name), answer);
    return *this;
  }
  constexpr Answers& add_simulation() {
    for (const ServiceRow& row : kServices) {
      if (row.of_simulation) {
        set(&row, &ServiceDesk::simulate);
      }
    }
    return *this;
  }
  // Those of rosapi that are answered at once.
  template <class... S>
  constexpr Answers& add_rosapi() {
    const auto row_of = [](std::string_view type) {
      return std::ranges::find_if(kServices, [type](const ServiceRow& row) {
        return row.type == type && row.name.starts_with("/rosapi/");
      });
    };
    (set(row_of(S::kName), &ServiceDesk::reply_rosapi<S>), ...);
    return *this;
  }
  static constexpr std::size_t place(const ServiceRow* row) {
    return static_cast<std::size_t>(row - kServices.data());
  }
  constexpr void set(const ServiceRow* row, Answer answer) {
    members[place(row)] = answer;
    is_set[place(row)] = true;
  }

  std::array<Answer, kServices.size()> members{};
  std::array<bool, kServices.size()>
      is_set{};  // gcc's sanitizers compare no members' addresses while they compile
};

void ServiceDesk::answer(const ServiceRow& row, const Caller& caller) {
  static constexpr Answers kAnswers =
      Answers()
          .add("/stand", &ServiceDesk::stand)
          .add("/stop", &ServiceDesk::stop)
          .add("/emergency_stop", &ServiceDesk::emergency_stop)
          .add("/release", &ServiceDesk::release)
          .add("/walk/limits", &ServiceDesk::tell_walk_limits)
          .add("/move_joint", &ServiceDesk::move_joint)
          .add("/play_motion", &ServiceDesk::play_motion)
          .add("/walk_to", &ServiceDesk::walk_to)
          .add("/walk_to/cancel", &ServiceDesk::leave_way)
          .add("/head/look", &ServiceDesk::look)
          .add("/command/take", &ServiceDesk::take_command)
          .add("/command/let_go", &ServiceDesk::let_command_go)
          .add("/behaviour/start", &ServiceDesk::start_mission)
          .add("/behaviour/end", &ServiceDesk::change_mission<MissionVerb::end>)
          .add("/behaviour/change", &ServiceDesk::change_mission<MissionVerb::change>)
          .add("/plugins/list", &ServiceDesk::list_plugins)
          .add("/plugins/get_parameters", &ServiceDesk::get_parameters)
          .add("/plugins/set_parameter", &ServiceDesk::set_parameter)
          .add("/plugins/reload", &ServiceDesk::change_plugin<PluginVerb::reload>)
          .add("/plugins/unload", &ServiceDesk::change_plugin<PluginVerb::unload>)
          .add("/plugins/load", &ServiceDesk::change_plugin<PluginVerb::load>)
          .add_simulation()
          .add("/recording/start", &ServiceDesk::start_recording)
          .add("/recording/stop", &ServiceDesk::stop_recording)
          .add("/recording/list", &ServiceDesk::list_recordings)
          .add("/command/acquire", &ServiceDesk::acquire_command)
          .add("/command/keep_alive", &ServiceDesk::keep_alive)
          .add("/command/release", &ServiceDesk::release_command)
          .add("/rosapi/get_param_names", &ServiceDesk::get_parameter_names)
          .add("/rosapi/set_param", &ServiceDesk::set_rosapi_parameter)
          .add("/rosapi/delete_param", &ServiceDesk::refuse_deletion)
          .add_rosapi<ros::Topics, ros::TopicType, ros::TopicsForType, ros::TopicsAndRawTypes,
                      ros::Publishers, ros::Subscribers, ros::Interfaces, ros::Services, ros::ServiceType,
                      ros::ServicesForType, ros::ServiceNode, ros::ServiceProviders,
                      ros::ServiceRequestDetails, ros::ServiceResponseDetails, ros::MessageDetails,
                      ros::Nodes, ros::NodeDetails, ros::GetActionServers, ros::GetTime, ros::GetROSVersion,
                      ros::GetParam, ros::HasParam>();
  static_assert(std::ranges::count(kAnswers.is_set, false) == 0, "every service has its answer");
  (this->*kAnswers.members[Answers::place(&row)])(caller);
}

void ServiceDesk::simulate(const Caller& caller) {
  if (!simulation_) {
    throw CommandDenied(
        "this robot is no simulation: nobody can push it from here, or change its time or world");
  }
  simulation_->call(*find_service(caller.call.service), caller.call, caller.arguments, caller.now_ns);
}

void ServiceDesk::acquire_command(const Caller& caller) {
  constexpr double kKeepAlivesInLease = 3.0;
  const auto asked = request<ros::AcquireCommand>(caller);
  if (asked.name.size() > kMostNameBytes) {
    throw Refused("name is " + shown(asked.name) + ", but must be a text of at most " +
                  std::to_string(kMostNameBytes) + " bytes");
  }
  caller.claimant.name = asked.name.empty() ? caller.claimant.name : asked.name;
  const std::string lease = commands_.acquire(caller.claimant, caller.now_ns);
  const double period_s = static_cast<double>(limits_.lease_ns) * 1e-9 / kKeepAlivesInLease;
  reply(caller.call, ros::AcquireCommand::Response{true, "you have the command", lease, period_s});
}

void ServiceDesk::keep_alive(const Caller& caller) {
  commands_.keep_alive(caller.claimant, request<ros::Lease>(caller).lease, caller.now_ns);
  reply(caller.call, ros::Lease::Response{true, "you have the command"});
}

void ServiceDesk::release_command(const Caller& caller) {
  commands_.release(caller.claimant, request<ros::Lease>(caller).lease, caller.now_ns);
  reply(caller.call, ros::Lease::Response{true, "nobody has the command"});
}

void ServiceDesk::refuse_deletion(const Caller&) {
  throw CommandDenied("parameters cannot be deleted: they belong to their plug-ins");
}

}  // namespace gaitway::api

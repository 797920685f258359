// Which service is answered by whom; orders whose answers are waited for.
#include "service_desk.hpp"

#include <array>
#include <utility>

#include "client_message.hpp"
#include "gaitway/api/authority.hpp"

namespace gaitway::api {

void Orders::require_room(std::uint64_t client) const {
  const auto count = std::ranges::count_if(
      waiting_, [client](const auto& order) { return order.second.client == client && order.second.counts; });
  if (static_cast<std::size_t>(count) >= kMostOfOneClient) {
    throw CommandDenied("this connection waits for " + std::to_string(count) +
                        " answers already: wait for one of them first");
  }
}

void Orders::wait(std::uint32_t number, std::uint64_t client, std::int64_t ends_ns, Finish finish,
                  bool counts) {
  waiting_.insert_or_assign(number, Waiting{client, ends_ns, std::move(finish), counts});
}

void Orders::step(std::int64_t now_ns) {
  // What is finished may give the next order, so it is taken out first.
  while (const auto result = take_result_()) {
    if (const auto order = waiting_.extract(result->number)) {
      order.mapped().finish(&*result);
    }
  }
  std::vector<Finish> late;
  std::erase_if(waiting_, [&](auto& order) {
    const bool over = now_ns >= order.second.ends_ns;
    if (over) {
      late.push_back(std::move(order.second.finish));
    }
    return over;
  });
  for (const Finish& finish : late) {
    finish(nullptr);
  }
}

void Orders::forget(std::uint64_t client) {
  std::erase_if(waiting_, [client](const auto& order) { return order.second.client == client; });
}

ServiceDesk::ServiceDesk(RobotPort& robot, SimulationPort* simulation, RobotCommands& commands,
                         const Limits& limits, ParameterValues parameters, const ClientOffers& offers,
                         Send send)
    : robot_(robot),
      simulation_(simulation),
      commands_(commands),
      limits_(limits),
      parameters_(std::move(parameters)),
      send_(std::move(send)),
      rosapi_(robot_, simulation_ != nullptr, parameters_, offers),
      orders_([&robot] { return robot.take_result(); }),
      simulation_orders_(
          [simulation] { return simulation == nullptr ? std::nullopt : simulation->take_result(); }),
      stands_(robot_, commands_,
              [this](const ServiceCall& call, StandWaits::Outcome outcome, const std::string& text) {
                answer_stand(call, outcome, text);
              }),
      gait_(robot_, orders_) {}

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
  simulation_orders_.forget(claimant.number);
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
          .add("/plugins/list", &ServiceDesk::list_plugins)
          .add("/plugins/get_parameters", &ServiceDesk::get_parameters)
          .add("/plugins/set_parameter", &ServiceDesk::set_parameter)
          .add("/plugins/reload", &ServiceDesk::change_plugin<PluginVerb::reload>)
          .add("/plugins/unload", &ServiceDesk::change_plugin<PluginVerb::unload>)
          .add("/plugins/load", &ServiceDesk::change_plugin<PluginVerb::load>)
          .add("/simulation/push", &ServiceDesk::push_link)
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

void ServiceDesk::push_link(const Caller& caller) {
  if (simulation_ == nullptr) {
    throw CommandDenied("this robot is no simulation: nobody can push it from here");
  }
  const auto asked = request<ros::PushLink>(caller);
  const bool along_heading = asked.frame == "heading";
  if (!along_heading && asked.frame != "world" && !asked.frame.empty()) {
    throw Refused("frame is " + shown(asked.frame) + ", but must be \"world\" or \"heading\"");
  }
  simulation_orders_.require_room(caller.call.client);
  const std::uint32_t order = simulation_->push({.link = asked.link,
                                                 .force_N = {asked.force.x, asked.force.y, asked.force.z},
                                                 .along_heading = along_heading,
                                                 .duration_s = asked.duration});
  await_result(simulation_orders_, caller, order, [this](const auto& call, const auto& result) {
    reply(call, ros::PushLink::Response{result.done, result.text});
  });
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

#include "service_desk.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "client_message.hpp"

namespace gaitway::api {

const ServiceRow* find_service(std::string_view name) noexcept {
  for (const ServiceRow& row : kServices) {
    if (row.name == name || row.name.substr(1) == name) {
      return &row;
    }
  }
  return nullptr;
}

ServiceDesk::ServiceDesk(RobotPort& robot, RobotCommands& commands, const Limits& limits,
                         ParameterValues parameters, Send send)
    : robot_(robot),
      commands_(commands),
      limits_(limits),
      parameters_(std::move(parameters)),
      send_(std::move(send)),
      rosapi_(robot_, parameters_),
      orders_(robot_) {}

void ServiceDesk::call(const ServiceCall& call, Claimant& claimant, std::int64_t now_ns) {
  const ServiceRow* const row = find_service(call.service);
  if (row == nullptr) {
    send_(call, service_failure(call, "service is " + shown(call.service) +
                                          ", but must be one that /rosapi/services lists"));
    return;
  }
  try {
    answer(row->service, {call, claimant, now_ns});
  } catch (const CommandDenied& denied) {
    deny(row->service, call, denied.what());
  } catch (const std::exception& error) {
    send_(call, service_failure(call, error.what()));
  }
}

void ServiceDesk::deny(Service service, const ServiceCall& call, std::string_view why) const {
  switch (service) {
    case Service::rosapi_set_param:
    case Service::rosapi_delete_param:
      return reply(call, ros::SetParam::Response{false, std::string(why)});
    case Service::acquire_command:
      return reply(call, ros::AcquireCommand::Response{false, std::string(why), "", 0.0});
    default:
      return reply(call, ros::Trigger::Response{false, std::string(why)});
  }
}

// Which member answers which service.
struct ServiceDesk::Row {
  Service service;
  void (ServiceDesk::*answer)(const Caller& caller);
};

void ServiceDesk::answer(Service service, const Caller& caller) {
  static constexpr std::array kRows{
      Row{Service::stand, &ServiceDesk::stand},
      Row{Service::stop, &ServiceDesk::stop},
      Row{Service::emergency_stop, &ServiceDesk::emergency_stop},
      Row{Service::release, &ServiceDesk::release},
      Row{Service::move_joint, &ServiceDesk::move_joint},
      Row{Service::play_motion, &ServiceDesk::play_motion},
      Row{Service::list_plugins, &ServiceDesk::list_plugins},
      Row{Service::get_parameters, &ServiceDesk::get_parameters},
      Row{Service::set_parameter, &ServiceDesk::set_parameter},
      Row{Service::reload_plugin, &ServiceDesk::change_plugin<PluginVerb::reload>},
      Row{Service::unload_plugin, &ServiceDesk::change_plugin<PluginVerb::unload>},
      Row{Service::load_plugin, &ServiceDesk::change_plugin<PluginVerb::load>},
      Row{Service::start_recording, &ServiceDesk::start_recording},
      Row{Service::stop_recording, &ServiceDesk::stop_recording},
      Row{Service::acquire_command, &ServiceDesk::acquire_command},
      Row{Service::keep_alive, &ServiceDesk::keep_alive},
      Row{Service::release_command, &ServiceDesk::release_command},
      Row{Service::rosapi_topics, &ServiceDesk::reply_rosapi<Service::rosapi_topics, ros::Topics>},
      Row{Service::rosapi_topic_type, &ServiceDesk::reply_rosapi<Service::rosapi_topic_type, ros::TopicType>},
      Row{Service::rosapi_topics_for_type,
          &ServiceDesk::reply_rosapi<Service::rosapi_topics_for_type, ros::TopicsForType>},
      Row{Service::rosapi_topics_and_raw_types,
          &ServiceDesk::reply_rosapi<Service::rosapi_topics_and_raw_types, ros::TopicsAndRawTypes>},
      Row{Service::rosapi_publishers,
          &ServiceDesk::reply_rosapi<Service::rosapi_publishers, ros::Publishers>},
      Row{Service::rosapi_subscribers,
          &ServiceDesk::reply_rosapi<Service::rosapi_subscribers, ros::Subscribers>},
      Row{Service::rosapi_interfaces,
          &ServiceDesk::reply_rosapi<Service::rosapi_interfaces, ros::Interfaces>},
      Row{Service::rosapi_services, &ServiceDesk::reply_rosapi<Service::rosapi_services, ros::Services>},
      Row{Service::rosapi_service_type,
          &ServiceDesk::reply_rosapi<Service::rosapi_service_type, ros::ServiceType>},
      Row{Service::rosapi_services_for_type,
          &ServiceDesk::reply_rosapi<Service::rosapi_services_for_type, ros::ServicesForType>},
      Row{Service::rosapi_service_node,
          &ServiceDesk::reply_rosapi<Service::rosapi_service_node, ros::ServiceNode>},
      Row{Service::rosapi_service_providers,
          &ServiceDesk::reply_rosapi<Service::rosapi_service_providers, ros::ServiceProviders>},
      Row{Service::rosapi_service_request_details,
          &ServiceDesk::reply_rosapi<Service::rosapi_service_request_details, ros::ServiceRequestDetails>},
      Row{Service::rosapi_service_response_details,
          &ServiceDesk::reply_rosapi<Service::rosapi_service_response_details, ros::ServiceResponseDetails>},
      Row{Service::rosapi_message_details,
          &ServiceDesk::reply_rosapi<Service::rosapi_message_details, ros::MessageDetails>},
      Row{Service::rosapi_nodes, &ServiceDesk::reply_rosapi<Service::rosapi_nodes, ros::Nodes>},
      Row{Service::rosapi_node_details,
          &ServiceDesk::reply_rosapi<Service::rosapi_node_details, ros::NodeDetails>},
      Row{Service::rosapi_action_servers,
          &ServiceDesk::reply_rosapi<Service::rosapi_action_servers, ros::GetActionServers>},
      Row{Service::rosapi_get_time, &ServiceDesk::reply_rosapi<Service::rosapi_get_time, ros::GetTime>},
      Row{Service::rosapi_get_ros_version,
          &ServiceDesk::reply_rosapi<Service::rosapi_get_ros_version, ros::GetROSVersion>},
      Row{Service::rosapi_get_param_names, &ServiceDesk::get_parameter_names},
      Row{Service::rosapi_get_param, &ServiceDesk::reply_rosapi<Service::rosapi_get_param, ros::GetParam>},
      Row{Service::rosapi_set_param, &ServiceDesk::set_rosapi_parameter},
      Row{Service::rosapi_has_param, &ServiceDesk::reply_rosapi<Service::rosapi_has_param, ros::HasParam>},
      Row{Service::rosapi_delete_param, &ServiceDesk::refuse_deletion},
  };
  static_assert(kRows.size() == kServiceCount);
  static_assert(std::ranges::is_sorted(kRows, {}, &Row::service), "in the order of the services");
  (this->*kRows[static_cast<std::size_t>(service)].answer)(caller);
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

#include "service_desk.hpp"

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

void ServiceDesk::answer(Service service, const Caller& caller) {
  switch (service) {
    case Service::stand:
      return stand(caller);
    case Service::stop:
      return stop(caller);
    case Service::emergency_stop:
      return emergency_stop(caller);
    case Service::move_joint:
      return move_joint(caller);
    case Service::play_motion:
      return play_motion(caller);
    case Service::start_recording:
      return start_recording(caller);
    case Service::stop_recording:
      return stop_recording(caller);
    default:
      return answer_of_plugins(service, caller);
  }
}

void ServiceDesk::answer_of_plugins(Service service, const Caller& caller) {
  switch (service) {
    case Service::list_plugins:
      return list_plugins(caller);
    case Service::load_plugin:
      return change_plugin(PluginVerb::load, caller);
    case Service::reload_plugin:
      return change_plugin(PluginVerb::reload, caller);
    case Service::unload_plugin:
      return change_plugin(PluginVerb::unload, caller);
    case Service::get_parameters:
      return get_parameters(caller);
    case Service::set_parameter:
      return set_parameter(caller);
    default:
      return answer_of_command(service, caller);
  }
}

void ServiceDesk::answer_of_command(Service service, const Caller& caller) {
  constexpr double kKeepAlivesInLease = 3.0;
  const auto& [call, claimant, now_ns] = caller;
  switch (service) {
    case Service::acquire_command: {
      const auto asked = request<ros::AcquireCommand>(caller);
      if (asked.name.size() > kMostNameBytes) {
        throw Refused("name is " + shown(asked.name) + ", but must be a text of at most " +
                      std::to_string(kMostNameBytes) + " bytes");
      }
      claimant.name = asked.name.empty() ? claimant.name : asked.name;
      const std::string lease = commands_.acquire(claimant, now_ns);
      const double period_s = static_cast<double>(limits_.lease_ns) * 1e-9 / kKeepAlivesInLease;
      return reply(call, ros::AcquireCommand::Response{true, "you have the command", lease, period_s});
    }
    case Service::keep_alive:
      commands_.keep_alive(claimant, request<ros::Lease>(caller).lease, now_ns);
      return reply(call, ros::Lease::Response{true, "you have the command"});
    case Service::release_command:
      commands_.release(claimant, request<ros::Lease>(caller).lease, now_ns);
      return reply(call, ros::Lease::Response{true, "nobody has the command"});
    default:
      return answer_of_topics(service, caller);
  }
}

void ServiceDesk::answer_of_topics(Service service, const Caller& caller) {
  switch (service) {
    case Service::rosapi_topics:
      return reply_rosapi<Service::rosapi_topics, ros::Topics>(caller);
    case Service::rosapi_topic_type:
      return reply_rosapi<Service::rosapi_topic_type, ros::TopicType>(caller);
    case Service::rosapi_topics_for_type:
      return reply_rosapi<Service::rosapi_topics_for_type, ros::TopicsForType>(caller);
    case Service::rosapi_topics_and_raw_types:
      return reply_rosapi<Service::rosapi_topics_and_raw_types, ros::TopicsAndRawTypes>(caller);
    case Service::rosapi_publishers:
      return reply_rosapi<Service::rosapi_publishers, ros::Publishers>(caller);
    case Service::rosapi_subscribers:
      return reply_rosapi<Service::rosapi_subscribers, ros::Subscribers>(caller);
    case Service::rosapi_nodes:
      return reply_rosapi<Service::rosapi_nodes, ros::Nodes>(caller);
    case Service::rosapi_node_details:
      return reply_rosapi<Service::rosapi_node_details, ros::NodeDetails>(caller);
    case Service::rosapi_action_servers:
      return reply_rosapi<Service::rosapi_action_servers, ros::GetActionServers>(caller);
    case Service::rosapi_get_time:
      return reply_rosapi<Service::rosapi_get_time, ros::GetTime>(caller);
    case Service::rosapi_get_ros_version:
      return reply_rosapi<Service::rosapi_get_ros_version, ros::GetROSVersion>(caller);
    default:
      return answer_of_types(service, caller);
  }
}

void ServiceDesk::answer_of_types(Service service, const Caller& caller) {
  switch (service) {
    case Service::rosapi_interfaces:
      return reply_rosapi<Service::rosapi_interfaces, ros::Interfaces>(caller);
    case Service::rosapi_services:
      return reply_rosapi<Service::rosapi_services, ros::Services>(caller);
    case Service::rosapi_service_type:
      return reply_rosapi<Service::rosapi_service_type, ros::ServiceType>(caller);
    case Service::rosapi_services_for_type:
      return reply_rosapi<Service::rosapi_services_for_type, ros::ServicesForType>(caller);
    case Service::rosapi_service_node:
      return reply_rosapi<Service::rosapi_service_node, ros::ServiceNode>(caller);
    case Service::rosapi_service_providers:
      return reply_rosapi<Service::rosapi_service_providers, ros::ServiceProviders>(caller);
    case Service::rosapi_service_request_details:
      return reply_rosapi<Service::rosapi_service_request_details, ros::ServiceRequestDetails>(caller);
    case Service::rosapi_service_response_details:
      return reply_rosapi<Service::rosapi_service_response_details, ros::ServiceResponseDetails>(caller);
    case Service::rosapi_message_details:
      return reply_rosapi<Service::rosapi_message_details, ros::MessageDetails>(caller);
    default:
      return answer_of_parameters(service, caller);
  }
}

void ServiceDesk::answer_of_parameters(Service service, const Caller& caller) {
  switch (service) {
    case Service::rosapi_get_param_names:
      return get_parameter_names(caller);
    case Service::rosapi_get_param:
      return reply_rosapi<Service::rosapi_get_param, ros::GetParam>(caller);
    case Service::rosapi_has_param:
      return reply_rosapi<Service::rosapi_has_param, ros::HasParam>(caller);
    case Service::rosapi_set_param:
      return set_rosapi_parameter(caller);
    case Service::rosapi_delete_param:
      throw CommandDenied("parameters cannot be deleted: they belong to their plug-ins");
    default:
      throw Refused("service is " + shown(caller.call.service) + ", which this robot does not answer");
  }
}

}  // namespace gaitway::api

// What rosapi's services answer: a node for the robot, with the topics and services of the tables, and one
// for each client that has topics or services of its own.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "client_services.hpp"
#include "client_topics.hpp"
#include "gaitway/api/robot_port.hpp"
#include "gaitway/api/rosapi_types.hpp"
#include "gaitway/api/service_table.hpp"

namespace gaitway::api {

// The one topic that the robot takes from clients.
inline constexpr std::string_view kVelocityTopic = "/cmd_vel";
inline constexpr std::string_view kNode = "/gaitway";

// Name -> value, as in a configuration.
using ParameterValues = std::map<std::string, std::string, std::less<>>;

// What clients have among themselves.
struct ClientOffers {
  const ClientTopics& topics;
  const ClientServices& services;
};

class Rosapi {
 public:
  Rosapi(const RobotPort& robot, bool simulated, const ParameterValues& parameters,
         const ClientOffers& offers);

  // Each throws std::invalid_argument for an unknown type, as the definitions do.
  [[nodiscard]] ros::Topics::Response answer(const ros::Topics::Request& request) const;
  [[nodiscard]] ros::TopicType::Response answer(const ros::TopicType::Request& request) const;
  [[nodiscard]] ros::TopicsForType::Response answer(const ros::TopicsForType::Request& request) const;
  [[nodiscard]] ros::TopicsAndRawTypes::Response answer(const ros::TopicsAndRawTypes::Request& request) const;
  [[nodiscard]] ros::Publishers::Response answer(const ros::Publishers::Request& request) const;
  [[nodiscard]] ros::Subscribers::Response answer(const ros::Subscribers::Request& request) const;
  [[nodiscard]] ros::Interfaces::Response answer(const ros::Interfaces::Request& request) const;
  [[nodiscard]] ros::Services::Response answer(const ros::Services::Request& request) const;
  [[nodiscard]] ros::ServiceType::Response answer(const ros::ServiceType::Request& request) const;
  [[nodiscard]] ros::ServicesForType::Response answer(const ros::ServicesForType::Request& request) const;
  [[nodiscard]] ros::ServiceNode::Response answer(const ros::ServiceNode::Request& request) const;
  [[nodiscard]] ros::ServiceProviders::Response answer(const ros::ServiceProviders::Request& request) const;
  [[nodiscard]] ros::ServiceRequestDetails::Response answer(
      const ros::ServiceRequestDetails::Request& request) const;
  [[nodiscard]] ros::ServiceResponseDetails::Response answer(
      const ros::ServiceResponseDetails::Request& request) const;
  [[nodiscard]] ros::MessageDetails::Response answer(const ros::MessageDetails::Request& request) const;
  [[nodiscard]] ros::Nodes::Response answer(const ros::Nodes::Request& request) const;
  [[nodiscard]] ros::NodeDetails::Response answer(const ros::NodeDetails::Request& request) const;
  [[nodiscard]] ros::GetActionServers::Response answer(const ros::GetActionServers::Request& request) const;
  [[nodiscard]] ros::GetTime::Response answer(const ros::GetTime::Request& request) const;
  [[nodiscard]] ros::GetROSVersion::Response answer(const ros::GetROSVersion::Request& request) const;
  [[nodiscard]] ros::GetParamNames::Response answer(const ros::GetParamNames::Request& request) const;
  [[nodiscard]] ros::GetParam::Response answer(const ros::GetParam::Request& request) const;
  [[nodiscard]] ros::HasParam::Response answer(const ros::HasParam::Request& request) const;

 private:
  struct NamedType {
    std::string_view name, type;
  };
  [[nodiscard]] std::vector<std::string> published() const;

  const RobotPort& robot_;
  std::vector<ServiceRow> services_;  // those that this robot offers
  std::vector<NamedType> topics_;     // likewise; the last one it takes, the others it publishes
  const ParameterValues& parameters_;
  ClientOffers offers_;
};

}  // namespace gaitway::api

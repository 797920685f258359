// The services with which rosbridge clients ask about topics, services, types and parameters: the types of
// the package rosapi_msgs, in the style of service_types.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gaitway/api/service_types.hpp"

namespace gaitway::api::ros {

// A message's fields, one entry each in the first four arrays. `fieldarraylen`: -1 no array, 0 any length.
struct TypeDef {
  std::string type;
  std::vector<std::string> fieldnames;
  std::vector<std::string> fieldtypes;
  std::vector<std::int32_t> fieldarraylen;
  std::vector<std::string> examples;
  std::vector<std::string> constnames;
  std::vector<std::string> constvalues;
  GAITWAY_ROS_MESSAGE("rosapi_msgs/msg/TypeDef", type, fieldnames, fieldtypes, fieldarraylen, examples,
                      constnames, constvalues);
};

// A time with the names of its parts that ROS 2 clients look for, and those that ROS 1 clients do.
struct TimeReading {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  std::int32_t secs = 0;
  std::uint32_t nsecs = 0;
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/TimeReading", sec, nanosec, secs, nsecs);
};

// What is asked for.
GAITWAY_ONE_FIELD(OfTopic, std::string, topic);
GAITWAY_ONE_FIELD(OfType, std::string, type);
GAITWAY_ONE_FIELD(OfService, std::string, service);
GAITWAY_ONE_FIELD(OfNode, std::string, node);
GAITWAY_ONE_FIELD(OfName, std::string, name);

GAITWAY_ONE_FIELD(TopicNames, std::vector<std::string>, topics);
struct TopicsAndTypes {
  std::vector<std::string> topics;
  std::vector<std::string> types;
  GAITWAY_FIELDS(topics, types)
};
struct TopicsAndTexts {
  std::vector<std::string> topics;
  std::vector<std::string> types;
  std::vector<std::string> typedefs_full_text;
  GAITWAY_FIELDS(topics, types, typedefs_full_text)
};
GAITWAY_ONE_FIELD(PublisherNames, std::vector<std::string>, publishers);
GAITWAY_ONE_FIELD(SubscriberNames, std::vector<std::string>, subscribers);
GAITWAY_ONE_FIELD(InterfaceNames, std::vector<std::string>, interfaces);
using Topics = RosService<"rosapi_msgs/srv/Topics", Nothing, TopicsAndTypes>;
using TopicType = RosService<"rosapi_msgs/srv/TopicType", OfTopic, OfType>;
using TopicsForType = RosService<"rosapi_msgs/srv/TopicsForType", OfType, TopicNames>;
using TopicsAndRawTypes = RosService<"rosapi_msgs/srv/TopicsAndRawTypes", Nothing, TopicsAndTexts>;
using Publishers = RosService<"rosapi_msgs/srv/Publishers", OfTopic, PublisherNames>;
using Subscribers = RosService<"rosapi_msgs/srv/Subscribers", OfTopic, SubscriberNames>;
using Interfaces = RosService<"rosapi_msgs/srv/Interfaces", Nothing, InterfaceNames>;

GAITWAY_ONE_FIELD(ServiceNames, std::vector<std::string>, services);
GAITWAY_ONE_FIELD(ProviderNames, std::vector<std::string>, providers);
using Services = RosService<"rosapi_msgs/srv/Services", Nothing, ServiceNames>;
using ServiceType = RosService<"rosapi_msgs/srv/ServiceType", OfService, OfType>;
using ServicesForType = RosService<"rosapi_msgs/srv/ServicesForType", OfType, ServiceNames>;
using ServiceNode = RosService<"rosapi_msgs/srv/ServiceNode", OfService, OfNode>;
using ServiceProviders = RosService<"rosapi_msgs/srv/ServiceProviders", OfService, ProviderNames>;

GAITWAY_ONE_FIELD(TypeDefs, std::vector<TypeDef>, typedefs);
using ServiceRequestDetails = RosService<"rosapi_msgs/srv/ServiceRequestDetails", OfType, TypeDefs>;
using ServiceResponseDetails = RosService<"rosapi_msgs/srv/ServiceResponseDetails", OfType, TypeDefs>;
using MessageDetails = RosService<"rosapi_msgs/srv/MessageDetails", OfType, TypeDefs>;

GAITWAY_ONE_FIELD(NodeNames, std::vector<std::string>, nodes);
struct NodeParts {
  std::vector<std::string> subscribing;
  std::vector<std::string> publishing;
  std::vector<std::string> services;
  GAITWAY_FIELDS(subscribing, publishing, services)
};
GAITWAY_ONE_FIELD(ActionServerNames, std::vector<std::string>, action_servers);
using Nodes = RosService<"rosapi_msgs/srv/Nodes", Nothing, NodeNames>;
using NodeDetails = RosService<"rosapi_msgs/srv/NodeDetails", OfNode, NodeParts>;
using GetActionServers = RosService<"rosapi_msgs/srv/GetActionServers", Nothing, ActionServerNames>;

GAITWAY_ONE_FIELD(Now, TimeReading, time);
struct RosVersion {
  std::uint8_t version = 0;
  std::string distro;
  GAITWAY_FIELDS(version, distro)
};
using GetTime = RosService<"rosapi_msgs/srv/GetTime", Nothing, Now>;
using GetROSVersion = RosService<"rosapi_msgs/srv/GetROSVersion", Nothing, RosVersion>;

// A parameter's `value` is JSON text.
GAITWAY_ONE_FIELD(ParameterNames, std::vector<std::string>, names);
struct ParameterReading {
  std::string value;
  bool successful = false;
  std::string reason;
  GAITWAY_FIELDS(value, successful, reason)
};
struct ParameterSetting {
  std::string name;
  std::string value;
  GAITWAY_FIELDS(name, value)
};
struct ParameterOutcome {
  bool successful = false;
  std::string reason;
  GAITWAY_FIELDS(successful, reason)
};
GAITWAY_ONE_FIELD(Existence, bool, exists);
using GetParamNames = RosService<"rosapi_msgs/srv/GetParamNames", Nothing, ParameterNames>;
using GetParam = RosService<"rosapi_msgs/srv/GetParam", OfName, ParameterReading>;
using SetParam = RosService<"rosapi_msgs/srv/SetParam", ParameterSetting, ParameterOutcome>;
using HasParam = RosService<"rosapi_msgs/srv/HasParam", OfName, Existence>;
using DeleteParam = RosService<"rosapi_msgs/srv/DeleteParam", OfName, ParameterOutcome>;

}  // namespace gaitway::api::ros

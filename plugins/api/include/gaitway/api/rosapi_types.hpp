// The services with which rosbridge clients ask about topics, services, types and parameters: the types of
// the package rosapi_msgs, as plain structs in the style of ros_messages.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/ros_messages.hpp"

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
  GAITWAY_ROS_MESSAGE("rosapi_msgs/msg/TypeDef") {
    visit("type", self.type);
    visit("fieldnames", self.fieldnames);
    visit("fieldtypes", self.fieldtypes);
    visit("fieldarraylen", self.fieldarraylen);
    visit("examples", self.examples);
    visit("constnames", self.constnames);
    visit("constvalues", self.constvalues);
  }
};

// A time with the names of its parts that ROS 2 clients look for, and those that ROS 1 clients do.
struct TimeReading {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  std::int32_t secs = 0;
  std::uint32_t nsecs = 0;
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/TimeReading") {
    visit("sec", self.sec);
    visit("nanosec", self.nanosec);
    visit("secs", self.secs);
    visit("nsecs", self.nsecs);
  }
};

struct Topics {
  static constexpr std::string_view kName = "rosapi_msgs/srv/Topics";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Topics_Request") {}
  };
  struct Response {
    std::vector<std::string> topics;
    std::vector<std::string> types;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Topics_Response") {
      visit("topics", self.topics);
      visit("types", self.types);
    }
  };
};

struct TopicType {
  static constexpr std::string_view kName = "rosapi_msgs/srv/TopicType";
  struct Request {
    std::string topic;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/TopicType_Request") { visit("topic", self.topic); }
  };
  struct Response {
    std::string type;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/TopicType_Response") { visit("type", self.type); }
  };
};

struct TopicsForType {
  static constexpr std::string_view kName = "rosapi_msgs/srv/TopicsForType";
  struct Request {
    std::string type;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/TopicsForType_Request") { visit("type", self.type); }
  };
  struct Response {
    std::vector<std::string> topics;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/TopicsForType_Response") { visit("topics", self.topics); }
  };
};

struct TopicsAndRawTypes {
  static constexpr std::string_view kName = "rosapi_msgs/srv/TopicsAndRawTypes";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/TopicsAndRawTypes_Request") {}
  };
  struct Response {
    std::vector<std::string> topics;
    std::vector<std::string> types;
    std::vector<std::string> typedefs_full_text;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/TopicsAndRawTypes_Response") {
      visit("topics", self.topics);
      visit("types", self.types);
      visit("typedefs_full_text", self.typedefs_full_text);
    }
  };
};

struct Publishers {
  static constexpr std::string_view kName = "rosapi_msgs/srv/Publishers";
  struct Request {
    std::string topic;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Publishers_Request") { visit("topic", self.topic); }
  };
  struct Response {
    std::vector<std::string> publishers;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Publishers_Response") { visit("publishers", self.publishers); }
  };
};

struct Subscribers {
  static constexpr std::string_view kName = "rosapi_msgs/srv/Subscribers";
  struct Request {
    std::string topic;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Subscribers_Request") { visit("topic", self.topic); }
  };
  struct Response {
    std::vector<std::string> subscribers;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Subscribers_Response") { visit("subscribers", self.subscribers); }
  };
};

struct Interfaces {
  static constexpr std::string_view kName = "rosapi_msgs/srv/Interfaces";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Interfaces_Request") {}
  };
  struct Response {
    std::vector<std::string> interfaces;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Interfaces_Response") { visit("interfaces", self.interfaces); }
  };
};

struct Services {
  static constexpr std::string_view kName = "rosapi_msgs/srv/Services";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Services_Request") {}
  };
  struct Response {
    std::vector<std::string> services;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Services_Response") { visit("services", self.services); }
  };
};

struct ServiceType {
  static constexpr std::string_view kName = "rosapi_msgs/srv/ServiceType";
  struct Request {
    std::string service;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceType_Request") { visit("service", self.service); }
  };
  struct Response {
    std::string type;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceType_Response") { visit("type", self.type); }
  };
};

struct ServicesForType {
  static constexpr std::string_view kName = "rosapi_msgs/srv/ServicesForType";
  struct Request {
    std::string type;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServicesForType_Request") { visit("type", self.type); }
  };
  struct Response {
    std::vector<std::string> services;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServicesForType_Response") { visit("services", self.services); }
  };
};

struct ServiceNode {
  static constexpr std::string_view kName = "rosapi_msgs/srv/ServiceNode";
  struct Request {
    std::string service;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceNode_Request") { visit("service", self.service); }
  };
  struct Response {
    std::string node;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceNode_Response") { visit("node", self.node); }
  };
};

struct ServiceProviders {
  static constexpr std::string_view kName = "rosapi_msgs/srv/ServiceProviders";
  struct Request {
    std::string service;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceProviders_Request") { visit("service", self.service); }
  };
  struct Response {
    std::vector<std::string> providers;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceProviders_Response") { visit("providers", self.providers); }
  };
};

struct ServiceRequestDetails {
  static constexpr std::string_view kName = "rosapi_msgs/srv/ServiceRequestDetails";
  struct Request {
    std::string type;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceRequestDetails_Request") { visit("type", self.type); }
  };
  struct Response {
    std::vector<TypeDef> typedefs;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceRequestDetails_Response") {
      visit("typedefs", self.typedefs);
    }
  };
};

struct ServiceResponseDetails {
  static constexpr std::string_view kName = "rosapi_msgs/srv/ServiceResponseDetails";
  struct Request {
    std::string type;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceResponseDetails_Request") { visit("type", self.type); }
  };
  struct Response {
    std::vector<TypeDef> typedefs;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/ServiceResponseDetails_Response") {
      visit("typedefs", self.typedefs);
    }
  };
};

struct MessageDetails {
  static constexpr std::string_view kName = "rosapi_msgs/srv/MessageDetails";
  struct Request {
    std::string type;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/MessageDetails_Request") { visit("type", self.type); }
  };
  struct Response {
    std::vector<TypeDef> typedefs;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/MessageDetails_Response") { visit("typedefs", self.typedefs); }
  };
};

struct Nodes {
  static constexpr std::string_view kName = "rosapi_msgs/srv/Nodes";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Nodes_Request") {}
  };
  struct Response {
    std::vector<std::string> nodes;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/Nodes_Response") { visit("nodes", self.nodes); }
  };
};

struct NodeDetails {
  static constexpr std::string_view kName = "rosapi_msgs/srv/NodeDetails";
  struct Request {
    std::string node;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/NodeDetails_Request") { visit("node", self.node); }
  };
  struct Response {
    std::vector<std::string> subscribing;
    std::vector<std::string> publishing;
    std::vector<std::string> services;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/NodeDetails_Response") {
      visit("subscribing", self.subscribing);
      visit("publishing", self.publishing);
      visit("services", self.services);
    }
  };
};

struct GetActionServers {
  static constexpr std::string_view kName = "rosapi_msgs/srv/GetActionServers";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetActionServers_Request") {}
  };
  struct Response {
    std::vector<std::string> action_servers;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetActionServers_Response") {
      visit("action_servers", self.action_servers);
    }
  };
};

struct GetTime {
  static constexpr std::string_view kName = "rosapi_msgs/srv/GetTime";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetTime_Request") {}
  };
  struct Response {
    TimeReading time;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetTime_Response") { visit("time", self.time); }
  };
};

struct GetROSVersion {
  static constexpr std::string_view kName = "rosapi_msgs/srv/GetROSVersion";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetROSVersion_Request") {}
  };
  struct Response {
    std::uint8_t version = 0;
    std::string distro;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetROSVersion_Response") {
      visit("version", self.version);
      visit("distro", self.distro);
    }
  };
};

struct GetParamNames {
  static constexpr std::string_view kName = "rosapi_msgs/srv/GetParamNames";
  struct Request {
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetParamNames_Request") {}
  };
  struct Response {
    std::vector<std::string> names;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetParamNames_Response") { visit("names", self.names); }
  };
};

// `value`: JSON text.
struct GetParam {
  static constexpr std::string_view kName = "rosapi_msgs/srv/GetParam";
  struct Request {
    std::string name;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetParam_Request") { visit("name", self.name); }
  };
  struct Response {
    std::string value;
    bool successful = false;
    std::string reason;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/GetParam_Response") {
      visit("value", self.value);
      visit("successful", self.successful);
      visit("reason", self.reason);
    }
  };
};

// `value`: JSON text.
struct SetParam {
  static constexpr std::string_view kName = "rosapi_msgs/srv/SetParam";
  struct Request {
    std::string name;
    std::string value;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/SetParam_Request") {
      visit("name", self.name);
      visit("value", self.value);
    }
  };
  struct Response {
    bool successful = false;
    std::string reason;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/SetParam_Response") {
      visit("successful", self.successful);
      visit("reason", self.reason);
    }
  };
};

struct HasParam {
  static constexpr std::string_view kName = "rosapi_msgs/srv/HasParam";
  struct Request {
    std::string name;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/HasParam_Request") { visit("name", self.name); }
  };
  struct Response {
    bool exists = false;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/HasParam_Response") { visit("exists", self.exists); }
  };
};

struct DeleteParam {
  static constexpr std::string_view kName = "rosapi_msgs/srv/DeleteParam";
  struct Request {
    std::string name;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/DeleteParam_Request") { visit("name", self.name); }
  };
  struct Response {
    bool successful = false;
    std::string reason;
    GAITWAY_ROS_MESSAGE("rosapi_msgs/srv/DeleteParam_Response") {
      visit("successful", self.successful);
      visit("reason", self.reason);
    }
  };
};

}  // namespace gaitway::api::ros

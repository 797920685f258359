// Definitions of types: as ROS tools write them, for every type, in whichever spelling it is asked for.
#include "gaitway/api/message_definition.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "gaitway/api/publication.hpp"
#include "gaitway/api/service_table.hpp"

namespace gaitway::api {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

TEST(CanonicalType, AcceptsBothSpellingsOfMessagesAndServices) {
  EXPECT_EQ(canonical_type("sensor_msgs/JointState"), "sensor_msgs/msg/JointState");
  EXPECT_EQ(canonical_type("sensor_msgs/msg/JointState"), "sensor_msgs/msg/JointState");
  EXPECT_EQ(canonical_type("std_srvs/Trigger"), "std_srvs/srv/Trigger");
  EXPECT_EQ(canonical_type("std_srvs/srv/Trigger"), "std_srvs/srv/Trigger");
  EXPECT_EQ(canonical_type("std_srvs/SetBool_Request"), "std_srvs/srv/SetBool_Request");
}

TEST(CanonicalType, KnowsTheServicesOfRosapiInThePackageOfRos1) {
  EXPECT_EQ(canonical_type("rosapi/Topics"), "rosapi_msgs/srv/Topics");
  EXPECT_EQ(canonical_type("rosapi_msgs/srv/Topics"), "rosapi_msgs/srv/Topics");
  EXPECT_EQ(canonical_type("rosapi/TypeDef"), "rosapi_msgs/msg/TypeDef");
}

TEST(CanonicalType, IsEmptyForWhatDoesNotExist) {
  for (const std::string_view type :
       {"", "/", "//", "///", "JointState", "sensor_msgs", "sensor_msgs/", "sensor_msgs/srv/JointState",
        "std_srvs/msg/Trigger", "sensor_msgs//JointState", "sensor_msgs/msg/x/JointState",
        "sensor_msgs/Image"}) {
    EXPECT_EQ(canonical_type(type), "") << type;
  }
}

TEST(MessageDefinition, IsTheTextOfTheMsgFile) {
  EXPECT_EQ(
      message_definition("sensor_msgs/JointState"),
      "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n");
  EXPECT_EQ(message_definition("geometry_msgs/msg/TwistWithCovariance"),
            "geometry_msgs/Twist twist\nfloat64[36] covariance\n");
  EXPECT_EQ(
      message_definition("diagnostic_msgs/DiagnosticStatus"),
      "byte level\nstring name\nstring message\nstring hardware_id\ndiagnostic_msgs/KeyValue[] values\n");
  EXPECT_EQ(message_definition("std_srvs/srv/SetBool_Response"), "bool success\nstring message\n");
  EXPECT_EQ(message_definition("std_srvs/srv/Trigger_Request"), "");
}

TEST(MessageDefinition, HasTheConstantsOfTheMsgFile) {
  EXPECT_EQ(message_definition("simulation_interfaces/Result"),
            "uint8 RESULT_FEATURE_UNSUPPORTED=0\nuint8 RESULT_OK=1\nuint8 RESULT_NOT_FOUND=2\n"
            "uint8 RESULT_INCORRECT_STATE=3\nuint8 RESULT_OPERATION_FAILED=4\n"
            "uint8 result\nstring error_message\n");
  EXPECT_EQ(message_definition("simulation_interfaces/srv/ResetSimulation_Request"),
            "uint8 SCOPE_DEFAULT=0\nuint8 SCOPE_TIME=1\nuint8 SCOPE_STATE=2\nuint8 SCOPE_SPAWNED=4\n"
            "uint8 SCOPE_ALL=255\nuint8 scope\n");
  const auto definition = type_definitions("simulation_interfaces/msg/EntityCategory").at(0);
  EXPECT_THAT(definition.constnames, ElementsAre("CATEGORY_OBJECT", "CATEGORY_ROBOT", "CATEGORY_HUMAN",
                                                 "CATEGORY_DYNAMIC_OBJECT", "CATEGORY_STATIC_OBJECT"));
  EXPECT_THAT(definition.constvalues, ElementsAre("0", "1", "2", "4", "5"));
  EXPECT_THAT(type_definitions("simulation_interfaces/srv/StepSimulation_Request").at(0).examples,
              ElementsAre("1"));
}

TEST(MessageDefinition, InFullHoldsEveryInnerTypeOnce) {
  const std::string line(80, '=');
  EXPECT_EQ(full_message_definition("geometry_msgs/PointStamped"),
            "std_msgs/Header header\ngeometry_msgs/Point point\n" +  //
                line + "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + line +
                "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" +  //
                line + "\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n");
  const std::string odometry = full_message_definition("nav_msgs/msg/Odometry");
  EXPECT_EQ(odometry.find("MSG: geometry_msgs/Vector3"), odometry.rfind("MSG: geometry_msgs/Vector3"));
}

TEST(MessageDefinition, RefusesAnUnknownTypeByName) {
  EXPECT_THROW(
      {
        try {
          static_cast<void>(message_definition("sensor_msgs/Image"));
        } catch (const std::invalid_argument& error) {
          EXPECT_THAT(error.what(), ::testing::HasSubstr("'sensor_msgs/Image'"));
          throw;
        }
      },
      std::invalid_argument);
  EXPECT_THROW(static_cast<void>(message_definition("std_srvs/srv/Trigger")), std::invalid_argument)
      << "a service has no definition but that of its request and response";
}

TEST(TypeDefinitions, AreWhatRosapiAnswers) {
  const auto definitions = type_definitions("sensor_msgs/msg/Imu");
  ASSERT_EQ(definitions.size(), 5U);
  EXPECT_EQ(definitions[0].type, "sensor_msgs/Imu");
  EXPECT_THAT(
      definitions[0].fieldnames,
      ElementsAre("header", "orientation", "orientation_covariance", "angular_velocity",
                  "angular_velocity_covariance", "linear_acceleration", "linear_acceleration_covariance"));
  EXPECT_THAT(definitions[0].fieldtypes,
              ElementsAre("std_msgs/Header", "geometry_msgs/Quaternion", "float64", "geometry_msgs/Vector3",
                          "float64", "geometry_msgs/Vector3", "float64"));
  EXPECT_THAT(definitions[0].fieldarraylen, ElementsAre(-1, -1, 9, -1, 9, -1, 9));
  EXPECT_THAT(definitions[0].examples, ElementsAre("{}", "{}", "[]", "{}", "[]", "{}", "[]"));
  EXPECT_EQ(definitions[3].type, "geometry_msgs/Quaternion");
  EXPECT_THAT(definitions[3].examples, ElementsAre("0.0", "0.0", "0.0", "1.0"));
  EXPECT_THAT(type_definitions("sensor_msgs/JointState")[0].fieldarraylen, ElementsAre(-1, 0, 0, 0, 0));
}

TEST(TypeDefinitions, OfEveryTypeNameOnlyTypesThatAreAmongThem) {
  for (const std::string_view type : message_types()) {
    std::set<std::string> known;
    const auto definitions = type_definitions(type);
    for (const auto& definition : definitions) {
      EXPECT_TRUE(known.insert(definition.type).second) << definition.type << " twice in " << type;
      EXPECT_EQ(definition.fieldnames.size(), definition.fieldtypes.size());
      EXPECT_EQ(definition.fieldnames.size(), definition.fieldarraylen.size());
      EXPECT_EQ(definition.fieldnames.size(), definition.examples.size());
    }
    for (const auto& definition : definitions) {
      for (const std::string& field : definition.fieldtypes) {
        EXPECT_TRUE(field.find('/') == std::string::npos || known.contains(field)) << field << " in " << type;
      }
    }
  }
}

TEST(TypeRegistry, HoldsTheTypeOfEveryTopicAndService) {
  for (const TopicRow& topic : kTopics) {
    EXPECT_THAT(message_types(), Contains(topic.type)) << topic.name;
  }
  for (const ServiceRow& service : kServices) {
    EXPECT_THAT(service_types(), Contains(service.type)) << service.name;
    EXPECT_NO_THROW(static_cast<void>(type_definitions(std::string(service.type) + "_Request")));
    EXPECT_NO_THROW(static_cast<void>(type_definitions(std::string(service.type) + "_Response")));
  }
  EXPECT_THAT(message_types(), Not(Contains("std_srvs/srv/Trigger")));
  const auto messages = message_types();
  EXPECT_TRUE(std::is_sorted(messages.begin(), messages.end()));
}

}  // namespace
}  // namespace gaitway::api

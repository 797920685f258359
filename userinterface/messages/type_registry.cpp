// The list of all types is here; the rest follows from their fields.
#include "type_registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <stdexcept>

#include "gaitway/api/command_messages.hpp"
#include "gaitway/api/message_definition.hpp"
#include "gaitway/api/service_types.hpp"
#include "gaitway/api/simulation_interfaces_types.hpp"
#include "gaitway/api/simulation_types.hpp"

namespace gaitway::api {
namespace {

template <class T>
constexpr std::string_view type_name() {
  if constexpr (Message<T>) {
    return T::kName;
  } else if constexpr (std::same_as<T, bool>) {
    return "bool";
  } else if constexpr (std::same_as<T, double>) {
    return "float64";
  } else if constexpr (std::same_as<T, float>) {
    return "float32";
  } else if constexpr (std::same_as<T, std::string>) {
    return "string";
  } else {
    static_assert(Integer<T>, "a field is a message, bool, number or string, or an array of these");
    constexpr std::array kSigned{"int8", "int16", "int32", "int64"};
    constexpr std::array kUnsigned{"uint8", "uint16", "uint32", "uint64"};
    constexpr auto kSizeLog = static_cast<std::size_t>(std::countr_zero(sizeof(T)));
    return std::signed_integral<T> ? kSigned[kSizeLog] : kUnsigned[kSizeLog];
  }
}

template <class T>
std::string python_text(const T& value) {
  if constexpr (std::same_as<T, bool>) {
    return value ? "True" : "False";
  } else if constexpr (std::floating_point<T>) {
    return fmt::format("{:.1f}", value);
  } else if constexpr (Integer<T>) {
    return fmt::format("{}", value);
  } else if constexpr (std::same_as<T, std::string>) {
    return value;
  } else {
    return Array<T> ? "[]" : "{}";
  }
}

// The published definition calls this one a byte, which is the same in every encoding.
template <Message M>
constexpr bool is_byte(std::string_view field) {
  return M::kName == ros::DiagnosticStatus::kName && field == "level";
}

template <Message M>
void add(TypeRegistry& registry) {
  if (registry.types.contains(M::kName)) {
    return;
  }
  TypeDescription& description = registry.types[M::kName];
  description.name = M::kName;
  if constexpr (requires { M::kConstants; }) {
    description.constants.assign(M::kConstants.begin(), M::kConstants.end());
  }
  M{}.fields([&]<class T>(std::string_view name, const T& value) {
    using Element = typename FieldShape<T>::Element;
    description.fields.push_back({name, is_byte<M>(name) ? "byte" : type_name<Element>(),
                                  FieldShape<T>::kLength, Message<Element>, python_text(value)});
    if constexpr (Message<Element>) {
      add<Element>(registry);
    }
  });
}

template <Message... M>
void add_messages(TypeRegistry& registry) {
  (add<M>(registry), ...);
}

template <class... S>
void add_services(TypeRegistry& registry) {
  ((add<typename S::Request>(registry), add<typename S::Response>(registry),
    registry.services.push_back(S::kName)),
   ...);
}

void add_all_messages(TypeRegistry& registry) {
  using namespace ros;
  add_messages<BusSlot, Clock, DiagnosticArray, Imu, JointState, LinkState, Log, MotionState, Odometry,
               WayState, PointStamped, PoseArray, RobotState, SimulationState, String, TFMessage, TwinState,
               Twist, TwistStamped, WrenchStamped, CommandState, BehaviourState, BehaviourNodes>(registry);
}

void add_all_services(TypeRegistry& registry) {
  using namespace ros;
  add_services<Trigger, SetBool, MoveJoint, PlayMotion, WalkTo, Look, StartMission, ListPlugins, ChangePlugin,
               GetParameters, SetParameter, WalkLimits, StartRecording, ListRecordings, AcquireCommand,
               Lease>(registry);
  add_services<Topics, TopicType, TopicsForType, TopicsAndRawTypes, Publishers, Subscribers, Interfaces,
               Services, ServiceType, ServicesForType, ServiceNode, ServiceProviders, ServiceRequestDetails,
               ServiceResponseDetails, MessageDetails, Nodes, NodeDetails, GetActionServers, GetTime,
               GetROSVersion, GetParamNames, GetParam, SetParam, HasParam, DeleteParam>(registry);
}

void add_simulation_services(TypeRegistry& registry) {
  using namespace ros;
  add_services<PushLink, SetSpeed, SeekTime, ApplyEvent, PlanFootsteps, GetGeometry, SendToRobot, GetPicture>(
      registry);
  using namespace ros::simulation;
  add_services<GetSimulatorFeatures, GetSimulationState, SetSimulationState, StepSimulation, ResetSimulation,
               SpawnEntity, DeleteEntity, GetEntities, GetEntityState, SetEntityState, GetEntitiesStates,
               GetEntityInfo, GetSpawnables, GetCurrentWorld>(registry);
}

TypeRegistry make_registry() {
  TypeRegistry registry;
  add_all_messages(registry);
  add_all_services(registry);
  add_simulation_services(registry);
  for (const auto& [name, description] : registry.types) {
    if (name.find("/msg/") != std::string_view::npos) {
      registry.messages.push_back(name);
    }
  }
  std::ranges::sort(registry.services);
  return registry;
}

void add_inner(const TypeDescription& type, std::vector<const TypeDescription*>& found) {
  if (std::ranges::find(found, &type) != found.end()) {
    return;
  }
  found.push_back(&type);
  for (const FieldDescription& field : type.fields) {
    if (field.is_message) {
      add_inner(type_description(field.type), found);
    }
  }
}

}  // namespace

const TypeRegistry& type_registry() {
  static const TypeRegistry registry = make_registry();
  return registry;
}

const TypeDescription& type_description(std::string_view type) {
  const auto& types = type_registry().types;
  const auto found = types.find(canonical_type(type));
  if (found == types.end()) {
    throw std::invalid_argument(
        fmt::format("'{}' is no message type of this robot's; /rosapi/interfaces lists them", type));
  }
  return found->second;
}

std::vector<const TypeDescription*> with_inner_types(const TypeDescription& type) {
  std::vector<const TypeDescription*> found;
  add_inner(type, found);
  return found;
}

std::string short_name(std::string_view type) {
  const std::size_t first = type.find('/'), last = type.rfind('/');
  return std::string(type.substr(0, first)) + std::string(type.substr(last));
}

}  // namespace gaitway::api

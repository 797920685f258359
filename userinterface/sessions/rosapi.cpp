#include "rosapi.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "client_message.hpp"
#include "gaitway/api/message_definition.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/service_table.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

// Of the types of clients' topics: an answer is to fit into what may wait for one client.
constexpr std::size_t kMostDefinitionBytes = std::size_t{128} * 1024;

// "/client_7".
std::string node_of(std::uint64_t client) {
  return "/client_" + std::to_string(client);
}

// What clients have comes behind the robot's own.
template <class Rows, class Own>
std::string type_of(const Rows& rows, const Own& own, std::string_view name) {
  if (const auto found = std::ranges::find(rows, name, &Rows::value_type::name); found != rows.end()) {
    return std::string(found->type);
  }
  const auto found = own.find(name);
  return found == own.end() ? std::string() : found->second.type;
}

template <class Rows, class Own>
std::vector<std::string> names_of(const Rows& rows, const Own& own, std::string_view type) {
  const std::string_view known = canonical_type(type);
  std::vector<std::string> names;
  for (const auto& row : rows) {
    if (row.type == known) {
      names.emplace_back(row.name);
    }
  }
  for (const auto& [name, one] : own) {
    if (one.type == (known.empty() ? type : known)) {
      names.push_back(name);
    }
  }
  return names;
}

template <class Rows>
std::vector<std::string> all_names(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    names.emplace_back(row.name);
  }
  return names;
}

std::vector<std::string> node_if(bool so) {
  return so ? std::vector<std::string>{std::string(kNode)} : std::vector<std::string>{};
}

std::set<std::uint64_t> listeners_of(const ClientTopic& topic) {
  std::set<std::uint64_t> clients;
  for (const TopicListener& listener : topic.listeners) {
    clients.insert(listener.client->number());
  }
  return clients;
}

std::vector<ros::TypeDef> details(const std::string& type, std::string_view part) {
  const std::string_view known = canonical_type(type);
  if (known.empty()) {
    throw std::invalid_argument("type is " + shown(type) + ", but must be one that /rosapi/interfaces lists");
  }
  return type_definitions(std::string(known) + std::string(part));
}

// A parameter's value as JSON: a number or truth value where it is one, otherwise a text.
std::string as_json(const std::string& value) {
  const auto parsed = nlohmann::json::parse(value, nullptr, false);
  return parsed.is_number() || parsed.is_boolean()
             ? value
             : nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

Rosapi::Rosapi(const RobotPort& robot, bool simulated, const ParameterValues& parameters,
               const ClientOffers& offers)
    : robot_(robot), parameters_(parameters), offers_(offers) {
  std::ranges::copy_if(kServices, std::back_inserter(services_),
                       [simulated](const ServiceRow& row) { return simulated || !row.of_simulation; });
  for (const TopicRow& row : kTopics) {
    if (simulated || !row.of_simulation) {
      topics_.push_back({row.name, row.type});
    }
  }
  topics_.push_back({kVelocityTopic, ros::Twist::kName});
}

std::vector<std::string> Rosapi::published() const {
  auto names = all_names(topics_);
  names.pop_back();
  return names;
}

ros::Topics::Response Rosapi::answer(const ros::Topics::Request&) const {
  ros::Topics::Response response;
  for (const NamedType& topic : topics_) {
    response.topics.emplace_back(topic.name);
    response.types.emplace_back(topic.type);
  }
  for (const auto& [name, topic] : offers_.topics.all()) {
    response.topics.push_back(name);
    response.types.push_back(topic.type);
  }
  return response;
}

ros::TopicType::Response Rosapi::answer(const ros::TopicType::Request& request) const {
  return {type_of(topics_, offers_.topics.all(), request.topic)};
}

ros::TopicsForType::Response Rosapi::answer(const ros::TopicsForType::Request& request) const {
  return {names_of(topics_, offers_.topics.all(), request.type)};
}

ros::TopicsAndRawTypes::Response Rosapi::answer(const ros::TopicsAndRawTypes::Request&) const {
  ros::TopicsAndRawTypes::Response response;
  for (const NamedType& topic : topics_) {
    response.topics.emplace_back(topic.name);
    response.types.emplace_back(topic.type);
    response.typedefs_full_text.push_back(full_message_definition(topic.type));
  }
  std::size_t room_bytes = kMostDefinitionBytes;
  for (const auto& [name, topic] : offers_.topics.all()) {
    std::string definition;
    if (!canonical_type(topic.type).empty()) {
      definition = full_message_definition(topic.type);
    }
    definition.resize(definition.size() <= room_bytes ? definition.size() : 0);
    room_bytes -= definition.size();
    response.topics.push_back(name);
    response.types.push_back(topic.type);
    response.typedefs_full_text.push_back(std::move(definition));
  }
  return response;
}

ros::Publishers::Response Rosapi::answer(const ros::Publishers::Request& request) const {
  const std::vector<std::string> published = this->published();
  auto nodes = node_if(std::ranges::find(published, request.topic) != published.end());
  if (const ClientTopic* const topic = offers_.topics.find(request.topic)) {
    for (const auto& [client, publisher] : topic->publishers) {
      nodes.push_back(node_of(client));
    }
  }
  return {nodes};
}

ros::Subscribers::Response Rosapi::answer(const ros::Subscribers::Request& request) const {
  auto nodes = node_if(request.topic == kVelocityTopic);
  if (const ClientTopic* const topic = offers_.topics.find(request.topic)) {
    for (const std::uint64_t client : listeners_of(*topic)) {
      nodes.push_back(node_of(client));
    }
  }
  return {nodes};
}

ros::Interfaces::Response Rosapi::answer(const ros::Interfaces::Request&) const {
  ros::Interfaces::Response response;
  for (const auto& types : {message_types(), service_types()}) {
    response.interfaces.insert(response.interfaces.end(), types.begin(), types.end());
  }
  return response;
}

ros::Services::Response Rosapi::answer(const ros::Services::Request&) const {
  auto names = all_names(services_);
  for (const auto& [name, service] : offers_.services.all()) {
    names.push_back(name);
  }
  return {names};
}

ros::ServiceType::Response Rosapi::answer(const ros::ServiceType::Request& request) const {
  return {type_of(services_, offers_.services.all(), request.service)};
}

ros::ServicesForType::Response Rosapi::answer(const ros::ServicesForType::Request& request) const {
  return {names_of(services_, offers_.services.all(), request.type)};
}

ros::ServiceNode::Response Rosapi::answer(const ros::ServiceNode::Request& request) const {
  if (const auto own = offers_.services.all().find(request.service); own != offers_.services.all().end()) {
    return {node_of(own->second.provider)};
  }
  const ServiceRow* const row = find_service(request.service);
  const bool offered =
      row != nullptr && std::ranges::find(services_, row->name, &ServiceRow::name) != services_.end();
  return {std::string(offered ? kNode : std::string_view())};
}

// The request's field is called `service`, but holds a type.
ros::ServiceProviders::Response Rosapi::answer(const ros::ServiceProviders::Request& request) const {
  const std::string_view known = canonical_type(request.service);
  auto nodes = node_if(std::ranges::find(services_, known, &ServiceRow::type) != services_.end());
  std::set<std::uint64_t> clients;
  for (const auto& [name, service] : offers_.services.all()) {
    if (service.type == (known.empty() ? std::string_view(request.service) : known)) {
      clients.insert(service.provider);
    }
  }
  for (const std::uint64_t client : clients) {
    nodes.push_back(node_of(client));
  }
  return {nodes};
}

ros::ServiceRequestDetails::Response Rosapi::answer(
    const ros::ServiceRequestDetails::Request& request) const {
  return {details(request.type, "_Request")};
}

ros::ServiceResponseDetails::Response Rosapi::answer(
    const ros::ServiceResponseDetails::Request& request) const {
  return {details(request.type, "_Response")};
}

ros::MessageDetails::Response Rosapi::answer(const ros::MessageDetails::Request& request) const {
  return {details(request.type, "")};
}

ros::Nodes::Response Rosapi::answer(const ros::Nodes::Request&) const {
  std::set<std::uint64_t> clients;
  for (const auto& [name, topic] : offers_.topics.all()) {
    clients.merge(listeners_of(topic));
    for (const auto& [client, publisher] : topic.publishers) {
      clients.insert(client);
    }
  }
  for (const auto& [name, service] : offers_.services.all()) {
    clients.insert(service.provider);
  }
  auto nodes = node_if(true);
  for (const std::uint64_t client : clients) {
    nodes.push_back(node_of(client));
  }
  return {nodes};
}

ros::NodeDetails::Response Rosapi::answer(const ros::NodeDetails::Request& request) const {
  if (request.node == kNode) {
    return {{{std::string(kVelocityTopic)}, published(), all_names(services_)}};
  }
  ros::NodeDetails::Response response;
  for (const auto& [name, topic] : offers_.topics.all()) {
    for (const std::uint64_t client : listeners_of(topic)) {
      if (node_of(client) == request.node) {
        response.subscribing.push_back(name);
      }
    }
    for (const auto& [client, publisher] : topic.publishers) {
      if (node_of(client) == request.node) {
        response.publishing.push_back(name);
      }
    }
  }
  for (const auto& [name, service] : offers_.services.all()) {
    if (node_of(service.provider) == request.node) {
      response.services.push_back(name);
    }
  }
  return response;
}

ros::GetActionServers::Response Rosapi::answer(const ros::GetActionServers::Request&) const {
  return {};
}

ros::GetTime::Response Rosapi::answer(const ros::GetTime::Request&) const {
  using facts::kSecond_ns;
  const std::int64_t now_ns = robot_.now_ns();
  const auto sec = static_cast<std::int32_t>(now_ns / kSecond_ns);
  const auto nanosec = static_cast<std::uint32_t>(now_ns % kSecond_ns);
  return {{sec, nanosec, sec, nanosec}};
}

ros::GetROSVersion::Response Rosapi::answer(const ros::GetROSVersion::Request&) const {
  return {2, "gaitway"};
}

ros::GetParamNames::Response Rosapi::answer(const ros::GetParamNames::Request&) const {
  ros::GetParamNames::Response response;
  for (const auto& [name, value] : parameters_) {
    response.names.push_back(name);
  }
  return response;
}

ros::GetParam::Response Rosapi::answer(const ros::GetParam::Request& request) const {
  const auto found = parameters_.find(request.name);
  if (found == parameters_.end()) {
    return {"null", false,  // clients parse it before they look whether there is one
            "name is " + shown(request.name) + ", but must be one that /rosapi/get_param_names lists"};
  }
  return {as_json(found->second), true, ""};
}

ros::HasParam::Response Rosapi::answer(const ros::HasParam::Request& request) const {
  return {parameters_.contains(request.name)};
}

}  // namespace gaitway::api

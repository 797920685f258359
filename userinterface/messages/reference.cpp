// Tables and examples of docs/api.md and the two files beside it.
#include "gaitway/api/reference.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <type_traits>

#include "gaitway/api/limits.hpp"
#include "gaitway/api/message_definition.hpp"
#include "gaitway/api/operation_table.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/service_table.hpp"
#include "reference_text.hpp"

namespace gaitway::api {
namespace {

using Json = nlohmann::ordered_json;

// In an order in which they are spoken: objects on one line, with spaces.
std::string one_line(const Json& value) {
  if (!value.is_structured()) {
    return value.dump();
  }
  std::string text;
  for (const auto& [name, element] : value.items()) {
    text += text.empty() ? "" : ", ";
    text += value.is_object() ? Json(name).dump() + ": " : "";
    text += one_line(element);
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

std::string example_block(const Json& message) {
  return "```json\n" + one_line(message) + "\n```\n\n";
}

bool is_rosapi(const ServiceRow& service) {
  return service.name.starts_with("/rosapi/");
}

Json call_of(const ServiceRow& service) {
  return {{"op", "call_service"},
          {"id", service.name.substr(1)},
          {"service", service.name},
          {"args", Json::parse(service.example)}};
}

Json answer_of(const ServiceRow& service) {
  return {{"op", "service_response"},
          {"id", service.name.substr(1)},
          {"service", service.name},
          {"result", true}};
}

// "float64 position, string[] name" of a type.
std::string fields_of(std::string_view type) {
  std::string text = message_definition(type);
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    result += (result.empty() ? "`" : ", `") + text.substr(begin, end - begin) + "`";
    begin = end + 1;
  }
  return result.empty() ? "nothing" : result;
}

std::string operation_fields(std::string_view rows) {
  if (rows.empty()) {
    return "";
  }
  std::string text = "| field | type | meaning |\n|---|---|---|\n";
  while (!rows.empty()) {
    std::string line(rows.substr(0, rows.find('\n')));
    rows.remove_prefix(line.size() + 1);
    const std::size_t first = line.find('|'), second = line.find('|', first + 1);
    text += fmt::format("| `{}` | {} | {} |\n", line.substr(0, first),
                        line.substr(first + 1, second - first - 1), line.substr(second + 1));
  }
  return text + "\n";
}

std::string operations() {
  std::string text{reference_text::kOperations};
  for (const OperationRow& operation : kOperations) {
    text += fmt::format("### `{}` ({})\n\n{}\n\n{}{}", operation.name,
                        operation.sender == Sender::client ? "to the robot" : "from the robot", operation.doc,
                        operation_fields(operation.fields), example_block(Json::parse(operation.example)));
  }
  return text;
}

std::string topics() {
  std::string text{reference_text::kTopics};
  text += "| topic | type | rate | latched | frame | what |\n|---|---|---|---|---|---|\n";
  for (const TopicRow& topic : kTopics) {
    text += fmt::format("| `{}` | `{}` | {} | {} | {} | {} |\n", topic.name, topic.type,
                        topic.rate_hz > 0.0 ? fmt::format("{} Hz", topic.rate_hz) : "0",
                        topic.latched ? "yes" : "", topic.frame, topic.doc);
  }
  const Limits limits;
  text += reference_text::kAccepted;
  text += fmt::format(
      "| topic | type | what |\n|---|---|---|\n"
      "| `/cmd_vel` | `{}` | Walk: `linear.x` forward and `linear.y` left [m/s, at most {} in size], "
      "`angular.z` turning left [rad/s, at most {}], none beyond what `/walk/limits` tells. The other fields "
      "must "
      "be 0. Holds for {} s. Needs the command. |\n",
      ros::Twist::kName, limits.forward_m_per_s, limits.turn_rad_per_s,
      static_cast<double>(limits.velocity_ns) * 1e-9);
  return text;
}

std::string services() {
  std::string text{reference_text::kServices};
  for (const ServiceRow& service : kServices) {
    if (is_rosapi(service)) {
      continue;
    }
    const std::string type(service.type);
    text += fmt::format("### `{}`\n\n{}.\n\n`{}`. Request: {}. Response: {}.{}\n\n{}", service.name,
                        service.doc, type, fields_of(type + "_Request"), fields_of(type + "_Response"),
                        service.needs_command ? " Needs the command." : "", example_block(call_of(service)));
  }
  return text;
}

std::string rosapi_services() {
  std::string text{reference_text::kRosapi};
  text += "| service | type | what | request, e.g. | response |\n|---|---|---|---|---|\n";
  for (const ServiceRow& service : kServices) {
    if (is_rosapi(service)) {
      text += fmt::format("| `{}` | `{}` | {} | `{}` | {} |\n", service.name, service.type, service.doc,
                          service.example, fields_of(std::string(service.type) + "_Response"));
    }
  }
  return text;
}

std::string types() {
  std::string text{reference_text::kTypes};
  text += "| type | fields |\n|---|---|\n";
  for (const std::string_view type : message_types()) {
    text += fmt::format("| `{}` | {} |\n", type, fields_of(type));
  }
  return text;
}

template <class T>
std::string limit_value(const T& value) {
  if constexpr (std::is_same_v<T, std::int64_t>) {
    return fmt::format("{}", static_cast<double>(value) * 1e-9);
  } else {
    return fmt::format("{}", value);
  }
}

std::string limits() {
  std::string text{reference_text::kLimits};
  text += "| parameter | default | at most so much, or so many |\n|---|---|---|\n";
  const Limits standard;
  visit_limits(standard, [&text](const LimitRow& row, const auto& value) {
    text += fmt::format("| `{}` | {}{}{} | {} |\n", row.name, limit_value(value), row.unit.empty() ? "" : " ",
                        row.unit, row.doc);
  });
  return text;
}

// Calls add(name, schema) for every message that crosses the network.
template <class Add>
void for_each_schema(const Add& add) {
  for (const TopicRow& topic : kTopics) {
    add(fmt::format("message {}", topic.name), json_schema(topic.type, Sender::robot));
  }
  add("publish /cmd_vel", json_schema(ros::Twist::kName, Sender::client));
  for (const ServiceRow& service : kServices) {
    const std::string type(service.type);
    add(fmt::format("call {}", service.name), json_schema(type + "_Request", Sender::client));
    add(fmt::format("answer {}", service.name), json_schema(type + "_Response", Sender::robot));
  }
}

}  // namespace

std::string api_reference() {
  return std::string(reference_text::kBeginning) + operations() + topics() + services() + rosapi_services() +
         types() + limits() + std::string(reference_text::kSchemas) + "```json\n" +
         Json::parse(json_schema(ros::Twist::kName, Sender::client)).dump(2) + "\n```\n";
}

std::string api_examples() {
  std::string text;
  const auto add = [&text](std::string_view name, const Json& message, const Json& answer) {
    text += text.empty() ? "[\n" : ",\n";
    text += "  " + one_line({{"name", name}, {"send", message}, {"answer", answer}});
  };
  for (const OperationRow& operation : kOperations) {
    if (operation.sender == Sender::client) {
      add(operation.name, Json::parse(operation.example),
          operation.answer.empty() ? Json() : Json::parse(operation.answer));
    }
  }
  const auto add_service = [&add](const ServiceRow& service) {
    add(service.name, call_of(service), answer_of(service));
  };
  for (const ServiceRow& one : kServices) {
    if (one.name != "/emergency_stop" && one.name != "/release") {
      add_service(one);
    }
  }
  add_service(*find_service("/emergency_stop"));  // nothing moves after it,
  add_service(*find_service("/release"));         // until this
  return text + "\n]\n";
}

std::string api_schemas() {
  std::string text;
  for_each_schema([&text](const std::string& name, const std::string& schema) {
    text += (text.empty() ? "{\n  " : ",\n  ") + Json(name).dump() + ": " + schema;
  });
  return text + "\n}\n";
}

}  // namespace gaitway::api

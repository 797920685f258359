// Declarations are handed on as if they had been made in this process.
#include "start_up.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <utility>
#include <vector>

#include "plugin_declarations.hpp"

namespace gaitway::core {

void StartUp::require(State state, ChildMessage message) const {
  if (state_ != state) {
    throw PluginError(fmt::format("its process sent message {} at the wrong time in its start",
                                  static_cast<std::uint32_t>(message)));
  }
}

StartUp::Next StartUp::take(std::span<const std::byte> message) {
  PacketReader packet(message);
  const auto kind = packet.number<ChildMessage>();
  switch (kind) {
    case ChildMessage::open_topic:
      require(State::constructing, kind);
      return grant([&] { take_topic(packet); });
    case ChildMessage::parameter:
      require(State::constructing, kind);
      return grant([&] { take_parameter(packet); });
    case ChildMessage::set_period:
      require(State::constructing, kind);
      return grant([&] {
        const auto period = packet.number<gaitway_period>();
        check_period(period);
        declarations_.set_period(period);
      });
    case ChildMessage::report: {
      const auto severity = packet.number<gaitway_severity>();
      const std::string text = packet.text();
      declarations_.report(severity, std::string_view(text).substr(0, kLongestReport));
      return Next::wait;
    }
    case ChildMessage::created:
      require(State::constructing, kind);
      library_ = {packet.text(), packet.text(), packet.text(), packet.text()};
      state_ = State::attaching;
      return Next::attach;
    case ChildMessage::attached:
      require(State::attaching, kind);
      state_ = State::attached;
      return Next::done;
    case ChildMessage::constructor_failed:
      require(State::constructing, kind);
      text_ = packet.text();
      state_ = State::failed;
      return Next::failed;
    case ChildMessage::library_failed:
      state_ = State::failed;
      throw PluginError(packet.text());
    default:
      throw PluginError("its process sent a message that no plug-in's process sends");
  }
}

template <class Function>
StartUp::Next StartUp::grant(const Function& function) {
  if (++declared_ > kMostDeclarations) {
    throw PluginError(fmt::format("declares more than {} topics and parameters", kMostDeclarations));
  }
  answer_ = PacketWriter(ChildMessage::granted);
  std::string problem;
  try {
    function();
    return Next::answer;
  } catch (const std::runtime_error& error) {  // PluginError or ConfigurationError
    problem = error.what();
  }
  answer_ = PacketWriter(ChildMessage::refused);
  answer_.text(problem);
  return Next::answer;
}

void StartUp::take_topic(PacketReader& packet) {
  const std::string name = packet.text(), type_name = packet.text();
  gaitway_topic topic{name.c_str(), type_name.c_str(), packet.number<std::uint64_t>(), 0, 0, nullptr};
  topic.size = packet.number<std::uint32_t>();
  const auto access = packet.number<gaitway_access>();
  topic.float_field_count = packet.number<std::uint32_t>();
  std::list<std::string> names;
  std::vector<gaitway_float_field> fields;
  for (std::uint32_t i = 0; i < topic.float_field_count; ++i) {
    gaitway_float_field field{};
    field.name = names.emplace_back(packet.text()).c_str();
    field.offset = packet.number<std::uint32_t>();
    field.count = packet.number<std::uint32_t>();
    field.bytes = packet.number<std::uint32_t>();
    field.rows = packet.number<std::uint32_t>();
    field.lowest = packet.number<double>();
    field.highest = packet.number<double>();
    fields.push_back(field);
  }
  topic.float_fields = fields.data();
  check_topic(&topic, access);
  declarations_.open_topic(topic, access);
}

void StartUp::take_parameter(PacketReader& packet) {
  const std::string name = packet.text(), unit = packet.text(), doc = packet.text();
  std::string text;
  gaitway_parameter wanted{};
  wanted.name = name.c_str();
  wanted.unit = unit.c_str();
  wanted.doc = doc.c_str();
  wanted.fallback = packet.value(text);
  wanted.lowest = packet.number<double>();
  wanted.highest = packet.number<double>();
  wanted.live = packet.number<std::uint32_t>();
  check_parameter(&wanted);
  answer_.value(declarations_.declare_parameter(wanted));
}

}  // namespace gaitway::core

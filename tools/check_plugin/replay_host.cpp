// The host's side of the plug-in interface over plain buffers.
#include "tools/check_plugin/replay_host.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "gaitway/instance/topic_port.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/detail/plugin_border.hpp"

namespace gaitway::plugin_check {
namespace {

ReplayHost& host_of(void* context) noexcept {
  return *static_cast<ReplayHost*>(context);
}

void fill_with_nan(const TypeDescriptor& type, std::vector<std::byte>& value) noexcept {
  for (const FieldDescriptor& field : type.fields) {
    for (std::uint32_t i = 0; i < field.elements(); ++i) {
      std::byte* const at = value.data() + field.offset + i * scalar_size(field.type);
      if (field.type == ScalarType::float64_value) {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        std::memcpy(at, &kNan, sizeof kNan);
      } else if (field.type == ScalarType::float32_value) {
        constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
        std::memcpy(at, &kNan, sizeof kNan);
      }
    }
  }
}

void set_joint_count(const TypeDescriptor& type, std::uint32_t count,
                     std::vector<std::byte>& value) noexcept {
  for (const FieldDescriptor& field : type.fields) {
    if (field.name == "joint_count") {
      std::memcpy(value.data() + field.offset, &count, sizeof count);
    }
  }
}

}  // namespace

ReplayHost::ReplayHost(const Job& job, const NominalRecord* record)
    : robot_(job.robot.string()),
      record_(record),
      parameters_(job.configuration, job.plugin.filename().string(), job.parameters, job.robot),
      table_{.context = this,
             .open_topic = &open_topic,
             .parameter = &parameter,
             .set_period = &set_period,
             .robot_directory = &robot_directory,
             .read = &read,
             .publish = &publish,
             .report = &report,
             .get_extension = &get_extension} {}

template <class Function>
gaitway_status ReplayHost::set_up(void* context, const gaitway_text* error,
                                  const Function& function) noexcept {
  ReplayHost& host = host_of(context);
  try {
    if (host.phase_ != Phase::creating) {
      throw std::logic_error("topics, parameters and period are declared in the constructor only");
    }
    if (host.refused_call_ == host.calls_++) {
      throw std::runtime_error("this declaration is refused, to see what the plug-in does then");
    }
    function(host);
    return GAITWAY_OK;
  } catch (const std::exception& problem) {
    detail::write_text(error, problem.what());
  }
  return GAITWAY_FAILED;
}

gaitway_status ReplayHost::open_topic(void* context, const gaitway_topic* topic, gaitway_access access,
                                      gaitway_port** port, const gaitway_text* error) noexcept {
  return set_up(context, error, [&](ReplayHost& host) {
    if (topic == nullptr || topic->name == nullptr || topic->type_name == nullptr || topic->size == 0 ||
        access >= core::kAccesses.size()) {
      throw std::invalid_argument("a topic needs a name, a type, a size and a known access");
    }
    host.add_port(*topic, access);
    *port = reinterpret_cast<gaitway_port*>(&host.ports_.back());
  });
}

void ReplayHost::add_port(const gaitway_topic& topic, gaitway_access access) {
  Port& port = ports_.emplace_back();
  port.topic = topic.name;
  port.access = access;
  port.type_name = topic.type_name;
  port.type_hash = topic.type_hash;
  port.value.resize(topic.size);
  const auto same = [&topic](const TypeDescriptor* type) { return type->hash == topic.type_hash; };
  const auto standard = std::ranges::find_if(kStandardTypes, same);
  port.standard_type =
      standard == kStandardTypes.end() || (*standard)->size != topic.size ? nullptr : *standard;
  for (std::uint32_t i = 0; topic.float_fields != nullptr && i < topic.float_field_count; ++i) {
    gaitway_float_field field = topic.float_fields[i];
    if (field.bytes != 4 && field.bytes != 8) {
      throw std::invalid_argument(fmt::format("topic '{}': numbers of {} bytes", topic.name, field.bytes));
    }
    if (std::uint64_t{field.offset} + std::uint64_t{field.count} * field.bytes > topic.size) {
      throw std::invalid_argument(fmt::format("topic '{}': a field lies outside of its value", topic.name));
    }
    port.field_names.push_back(std::make_unique<std::string>(field.name == nullptr ? "" : field.name));
    field.name = port.field_names.back()->c_str();
    port.float_fields.push_back(field);
  }
  const RecordedTopic* const recorded = record_ == nullptr ? nullptr : record_->find(topic.name);
  if (recorded != nullptr && recorded->type == port.standard_type && !port.is_output()) {
    port.recorded = recorded;
  }
}

gaitway_status ReplayHost::parameter(void* context, const gaitway_parameter* parameter, gaitway_value* value,
                                     const gaitway_text* error) noexcept {
  return set_up(context, error, [&](ReplayHost& host) {
    if (parameter == nullptr || parameter->name == nullptr || parameter->name[0] == '\0' ||
        parameter->fallback.kind > GAITWAY_TEXT ||
        (parameter->fallback.kind == GAITWAY_TEXT && parameter->fallback.text == nullptr)) {
      throw std::invalid_argument("a parameter needs a name and a default");
    }
    const gaitway_kind kind = parameter->fallback.kind;
    if ((kind == GAITWAY_NUMBER || kind == GAITWAY_INTEGER) &&
        (parameter->unit == nullptr || parameter->unit[0] == '\0')) {
      host.complaints_.push_back(fmt::format("parameter '{}' has no unit", parameter->name));
    }
    *value = host.parameters_.declare(*parameter);
  });
}

gaitway_status ReplayHost::set_period(void* context, gaitway_period period,
                                      const gaitway_text* error) noexcept {
  return set_up(context, error, [&](ReplayHost& host) {
    if (period > GAITWAY_EVERY_BATCH) {
      throw std::invalid_argument("sets an unknown period");
    }
    host.period_ = static_cast<Period>(period);
  });
}

const void* ReplayHost::get_extension(void*, const char*) noexcept {
  return nullptr;
}

const char* ReplayHost::robot_directory(void* context) noexcept {
  return host_of(context).robot_.c_str();
}

gaitway_status ReplayHost::read(void*, gaitway_port* port, void* value, gaitway_sample* sample) noexcept {
  if (port == nullptr) {
    return GAITWAY_FAILED;
  }
  const Port& topic = *reinterpret_cast<const Port*>(port);
  if (topic.is_output()) {
    return GAITWAY_FAILED;
  }
  if (topic.sample.sequence != 0 && topic.sample.sequence != sample->sequence) {
    std::memcpy(value, topic.value.data(), topic.value.size());
    *sample = topic.sample;
  }
  return sample->sequence == 0 ? GAITWAY_NO_VALUE : GAITWAY_OK;
}

gaitway_status ReplayHost::publish(void* context, gaitway_port* port, const void* value) noexcept {
  if (port == nullptr || host_of(context).phase_ != Phase::stepping) {
    return GAITWAY_FAILED;
  }
  Port& topic = *reinterpret_cast<Port*>(port);
  if (!topic.is_output()) {
    return GAITWAY_FAILED;
  }
  std::memcpy(topic.value.data(), value, topic.value.size());
  topic.published = true;
  return GAITWAY_OK;
}

void ReplayHost::report(void*, gaitway_severity, const char*) noexcept {
  // An event is no value: nothing here depends on it.
}

void ReplayHost::feed(const RecordPosition& position, const InputFault& fault) noexcept {
  for (Port& port : ports_) {
    if (port.recorded != nullptr) {
      const bool faulty = fault.topic.empty() || fault.topic == port.topic;
      feed(port, position, faulty ? fault : InputFault{});
    }
  }
}

void ReplayHost::feed(Port& port, const RecordPosition& position, const InputFault& fault) noexcept {
  using Kind = InputFault::Kind;
  if (fault.kind == Kind::frozen) {
    return;
  }
  if (fault.kind == Kind::missing) {
    port.sample = {};
    return;
  }
  const RecordedTopic& topic = *port.recorded;
  // The value of the tick before is that of the pass before at a pass's first tick: there is none, then.
  const bool previous = core::is_of_tick_before(core::Access{port.access});
  const std::uint32_t tick = previous && position.tick > 0 ? position.tick - 1 : position.tick;
  const std::uint32_t newest = previous && position.tick == 0 ? 0 : topic.newest_at[tick];
  if (newest == 0) {
    return;
  }
  const std::uint64_t sequence = newest + std::uint64_t{position.pass} * topic.stamp_ns.size();
  if (sequence == port.sample.sequence && fault.kind == Kind::none) {
    return;
  }
  record_->copy(topic, newest - 1, position.pass, port.value);
  port.sample = {sequence, topic.stamp_ns[newest - 1] + record_->shift_ns(position.pass)};
  if (fault.kind == Kind::not_a_number) {
    fill_with_nan(*port.standard_type, port.value);
  } else if (fault.kind == Kind::joint_count) {
    set_joint_count(*port.standard_type, fault.joint_count, port.value);
  }
}

}  // namespace gaitway::plugin_check

// A declaration is a question to the manager; reading and publishing are copies.
#include "child_functions.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <thread>

#include "gaitway/plugin/detail/plugin_border.hpp"
#include "plugin_declarations.hpp"

namespace gaitway::core {
namespace {

ChildProgram& child_of(void* context) noexcept {
  return *static_cast<ChildProgram*>(context);
}

PacketWriter describe(const gaitway_topic& topic, gaitway_access access) {
  PacketWriter packet(ChildMessage::open_topic);
  packet.text(topic.name).text(topic.type_name).number(topic.type_hash).number(topic.size).number(access);
  packet.number(topic.float_field_count);
  for (std::uint32_t i = 0; i < topic.float_field_count; ++i) {
    const gaitway_float_field& field = topic.float_fields[i];
    packet.text(field.name).number(field.offset).number(field.count).number(field.bytes).number(field.rows);
    packet.number(field.lowest).number(field.highest);
  }
  return packet;
}

}  // namespace

gaitway_host ChildProgram::Functions::table(ChildProgram& child) noexcept {
  return {.context = &child,
          .open_topic = &open_topic,
          .parameter = &parameter,
          .set_period = &set_period,
          .robot_directory = &robot_directory,
          .read = &read,
          .publish = &publish,
          .report = &report,
          .get_extension = &get_extension};
}

std::vector<std::byte> ChildProgram::Functions::ask(ChildProgram& child, const PacketWriter& question) {
  if (!child.tell(question)) {
    throw PluginError("declares more than a message to its manager holds");
  }
  std::vector<std::byte> answer;
  if (receive_packet(child.socket_, answer, Wait::yes) != Receipt::packet) {
    _exit(0);  // the manager is gone
  }
  PacketReader packet(answer);
  if (packet.number<ChildMessage>() == ChildMessage::refused) {
    throw PluginError(packet.text());
  }
  return answer;
}

template <class Function>
gaitway_status ChildProgram::Functions::in_create(void* context, const gaitway_text* error,
                                                  const Function& function) noexcept {
  try {
    if (child_of(context).phase_ != ChildProgram::Phase::creating) {
      throw PluginError(kConstructorOnly);
    }
    function(child_of(context));
    return GAITWAY_OK;
  } catch (const std::exception& problem) {
    detail::write_text(error, problem.what());
  }
  return GAITWAY_FAILED;
}

gaitway_status ChildProgram::Functions::open_topic(void* context, const gaitway_topic* topic,
                                                   gaitway_access access, gaitway_port** port,
                                                   const gaitway_text* error) noexcept {
  return in_create(context, error, [&](ChildProgram& child) {
    check_topic(topic, access);
    static_cast<void>(ask(child, describe(*topic, access)));
    child.ports_.push_back({static_cast<Access>(access), topic->size, nullptr});
    *port = reinterpret_cast<gaitway_port*>(&child.ports_.back());
  });
}

gaitway_status ChildProgram::Functions::parameter(void* context, const gaitway_parameter* parameter,
                                                  gaitway_value* value, const gaitway_text* error) noexcept {
  return in_create(context, error, [&](ChildProgram& child) {
    check_parameter(parameter);
    PacketWriter question(ChildMessage::parameter);
    question.text(parameter->name).text(parameter->unit).text(parameter->doc).value(parameter->fallback);
    question.number(parameter->lowest).number(parameter->highest).number(parameter->live);
    const std::vector<std::byte> answer = ask(child, question);
    PacketReader packet(answer);
    packet.number<ChildMessage>();
    *value = packet.value(child.texts_.emplace_back());
  });
}

gaitway_status ChildProgram::Functions::set_period(void* context, gaitway_period period,
                                                   const gaitway_text* error) noexcept {
  return in_create(context, error, [&](ChildProgram& child) {
    check_period(period);
    static_cast<void>(ask(child, PacketWriter(ChildMessage::set_period).number(period)));
  });
}

const char* ChildProgram::Functions::robot_directory(void* context) noexcept {
  return child_of(context).robot_directory_.c_str();
}

const char* ChildProgram::Functions::memory_socket(void* context) noexcept {
  return child_of(context).memory_socket_.c_str();
}

const char* ChildProgram::Functions::write_folder(void* context) noexcept {
  return child_of(context).write_folder_.c_str();
}

gaitway_status ChildProgram::Functions::read(void*, gaitway_port* port, void* value,
                                             gaitway_sample* sample) noexcept {
  const auto* const from = reinterpret_cast<const Port*>(port);
  if (from == nullptr || from->area == nullptr || from->access == Access::write) {
    return GAITWAY_FAILED;
  }
  if (from->area->sequence != sample->sequence) {
    std::memcpy(value, from->value(), from->size);
    *sample = {from->area->sequence, from->area->stamp_ns};
  }
  return sample->sequence == 0 ? GAITWAY_NO_VALUE : GAITWAY_OK;
}

gaitway_status ChildProgram::Functions::publish(void* context, gaitway_port* port,
                                                const void* value) noexcept {
  const auto* const to = reinterpret_cast<const Port*>(port);
  if (to == nullptr || to->access != Access::write ||
      child_of(context).phase_ != ChildProgram::Phase::stepping) {
    return GAITWAY_FAILED;
  }
  std::memcpy(to->value(), value, to->size);
  to->area->staged = 1;
  return GAITWAY_OK;
}

const void* ChildProgram::Functions::get_extension(void*, const char* name) noexcept {
  static constexpr gaitway_network kNetwork{&memory_socket, &write_folder};
  return std::strcmp(name, GAITWAY_NETWORK_EXTENSION) == 0 ? &kNetwork : nullptr;
}

void ChildProgram::Functions::report(void* context, gaitway_severity severity, const char* text) noexcept {
  ChildProgram& child = child_of(context);
  const std::size_t length = text == nullptr ? 0 : strnlen(text, kLongestReport);
  if (std::this_thread::get_id() != child.caller_) {  // goes out with the next answer
    child.posts_.post(static_cast<EventKind>(severity), {}, {text, length});
    return;
  }
  if (child.exchange_ == nullptr) {
    PacketWriter packet(ChildMessage::report);
    child.tell(packet.number(severity).text(std::string_view(text == nullptr ? "" : text, length)));
    return;
  }
  child.put_report(severity, {text, length});
}

}  // namespace gaitway::core

// Hosts one plug-in with the least that it needs, as the measure of what the manager adds: buffers by name.
#include "direct_host.hpp"

#include <cstring>
#include <stdexcept>
#include <utility>

namespace gaitway::core {

DirectPlugin::DirectPlugin(const gaitway_plugin& plugin, DirectTopics& topics, std::string robot_directory,
                           std::map<std::string, std::string> texts)
    : topics_(topics), robot_directory_(std::move(robot_directory)), texts_(std::move(texts)) {
  host_.context = this;
  host_.open_topic = &open_topic;
  host_.parameter = &parameter;
  host_.set_period = [](void*, gaitway_period, const gaitway_text*) -> gaitway_status { return GAITWAY_OK; };
  host_.robot_directory = [](void* context) {
    return static_cast<DirectPlugin*>(context)->robot_directory_.c_str();
  };
  host_.read = &read;
  host_.publish = &publish;
  host_.report = [](void*, gaitway_severity, const char*) {};
  host_.get_extension = [](void*, const char*) -> const void* { return nullptr; };
  require(plugin.create(&host_, &instance_, &error_));
}

DirectPlugin::~DirectPlugin() {
  instance_.destroy(instance_.context);
}

void DirectPlugin::activate() {
  require(instance_.activate(instance_.context, &error_));
}

void DirectPlugin::require(gaitway_status status) const {
  if (status != GAITWAY_OK) {
    throw std::runtime_error(error_bytes_);
  }
}

gaitway_status DirectPlugin::open_topic(void* context, const gaitway_topic* topic, gaitway_access,
                                        gaitway_port** port, const gaitway_text*) noexcept {
  DirectTopic& opened = static_cast<DirectPlugin*>(context)->topics_[topic->name];
  opened.value.resize(topic->size);
  *port = reinterpret_cast<gaitway_port*>(&opened);
  return GAITWAY_OK;
}

gaitway_status DirectPlugin::parameter(void* context, const gaitway_parameter* parameter,
                                       gaitway_value* value, const gaitway_text*) noexcept {
  const auto& texts = static_cast<DirectPlugin*>(context)->texts_;
  *value = parameter->fallback;
  if (const auto given = texts.find(parameter->name); given != texts.end()) {
    value->text = given->second.c_str();
  }
  return GAITWAY_OK;
}

gaitway_status DirectPlugin::read(void*, gaitway_port* port, void* value, gaitway_sample* sample) noexcept {
  const DirectTopic& topic = *reinterpret_cast<const DirectTopic*>(port);
  if (topic.sequence != sample->sequence) {
    std::memcpy(value, topic.value.data(), topic.value.size());
    *sample = {topic.sequence, topic.stamp_ns};
  }
  return topic.sequence == 0 ? GAITWAY_NO_VALUE : GAITWAY_OK;
}

gaitway_status DirectPlugin::publish(void*, gaitway_port* port, const void* value) noexcept {
  DirectTopic& topic = *reinterpret_cast<DirectTopic*>(port);
  std::memcpy(topic.value.data(), value, topic.value.size());
  ++topic.sequence;
  return GAITWAY_OK;
}

}  // namespace gaitway::core

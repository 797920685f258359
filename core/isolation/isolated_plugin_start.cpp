// An isolated plug-in's set-up: what the child asks while it constructs the plug-in, and how a new child
// takes the place of one that was lost.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "child_link.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/isolation/isolated_plugin.hpp"
#include "gaitway/isolation/settings.hpp"
#include "gaitway/process/real_time.hpp"
#include "plugin_declarations.hpp"

namespace gaitway::core {
namespace {

using facts::kMillisecond_ns;
constexpr std::uint32_t kProven = 8;  // steps after which a restored state is not to blame for the next end

std::string binary_for(const std::string& place) {
  try {
    return find_plugin_child().string();
  } catch (const PluginError& error) {
    throw PluginError(fmt::format("{}: {}", place, error.what()));
  }
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code problem;
  if (!folder.empty()) {
    std::filesystem::create_directories(folder, problem);
  }
  if (problem) {
    throw PluginError(
        fmt::format("its folder '{}' cannot be made: {}. Correct the key 'writes', or its rights",
                    folder.string(), problem.message()));
  }
}

EventKind kind_of(std::uint32_t severity) noexcept {
  return severity == GAITWAY_INFO      ? EventKind::info
         : severity == GAITWAY_WARNING ? EventKind::warning
                                       : EventKind::error;
}

}  // namespace

IsolatedPlugin::IsolatedPlugin(const PluginEntry& entry, const PluginSource& source,
                               const IsolationOptions& options, EventLog& events)
    : ManagedPlugin(entry, source.configuration_file, events),
      settings_(entry.child),
      options_(options_for(entry.child, options)),
      containment_(entry.containment),
      library_(entry.library),
      base_(source.configuration_file.parent_path().string()),
      robot_directory_(source.robot_directory.string()),
      memory_socket_(source.memory_socket.string()),
      host_binary_(binary_for(place_)),
      search_path_(source.search_path) {
  try {
    make_folder(settings_.writes);
    start();
    while (!attend_start(options_.start_limit_ns)) {
    }
  } catch (const PluginError& error) {
    throw PluginError(fmt::format("{}: {}", place_, error.what()));
  }
  parameters_.require_all_declared();
  condition_ = Condition::idle;
}

void IsolatedPlugin::start() {
  link_.reset();
  declared_ports_ = 0;
  parameter_error_.reset();
  start_began_ns_ = process::monotonic_ns();
  link_ =
      std::make_unique<ChildLink>(host_binary_, ChildBounds{.memory_limit_bytes = options_.memory_limit_bytes,
                                                            .descriptor_limit = options_.descriptor_limit,
                                                            .serves_network = settings_.serves_network});
  PacketWriter packet(ChildMessage::create);
  packet.text(library_).text(base_).text(robot_directory_).text(memory_socket_);
  packet.text(settings_.writes.native());
  packet.number(static_cast<std::uint32_t>(search_path_.size()));
  for (const std::filesystem::path& folder : search_path_) {
    packet.text(folder.native());
  }
  send_packet(link_->socket, packet.bytes());
}

// Answers what the child asks, for at most so long. Throws PluginError or ConfigurationError.
bool IsolatedPlugin::attend_start(std::int64_t wait_ns) {
  const std::int64_t end_ns = process::monotonic_ns() + wait_ns;
  for (;;) {
    const bool ended = link_->process.has_ended();  // before the look for messages: none comes after it
    process::FileDescriptor unwanted;
    const Receipt receipt = receive_packet(link_->socket, link_->packet, false, unwanted);
    if (receipt == Receipt::packet && take_message()) {
      return true;
    }
    if (ended && receipt != Receipt::packet) {
      throw PluginError(fmt::format("its process {} while it constructed the plug-in", link_->process.end()));
    }
    const std::int64_t now_ns = process::monotonic_ns();
    if (now_ns - start_began_ns_ > options_.start_limit_ns) {
      throw PluginError(fmt::format(
          "its process has not constructed the plug-in within {:g} s. Look for a loop or a wait in its "
          "constructor",
          static_cast<double>(options_.start_limit_ns) * 1e-9));
    }
    if (now_ns >= end_ns) {
      return false;  // also when one message follows the other: there are ticks to keep
    }
    if (receipt == Receipt::packet) {
      continue;
    }
    link_->wait_for_message(static_cast<int>((end_ns - now_ns) / kMillisecond_ns + 1));
  }
}

bool IsolatedPlugin::take_message() {
  PacketReader packet(link_->packet);
  switch (packet.number<ChildMessage>()) {
    case ChildMessage::open_topic:
      grant([&] { take_topic(packet); });
      return false;
    case ChildMessage::parameter:
      grant([&] { take_parameter(packet); });
      return false;
    case ChildMessage::set_period:
      grant([&] {
        const auto period = packet.number<gaitway_period>();
        check_period(period);
        period_ = static_cast<Period>(period);
        send_packet(link_->socket, PacketWriter(ChildMessage::granted).bytes());
      });
      return false;
    case ChildMessage::report: {
      const auto severity = packet.number<std::uint32_t>();
      events_.post(kind_of(severity), name_, packet.text());
      return false;
    }
    case ChildMessage::created:
      version_ = packet.text();
      attach();
      return false;
    case ChildMessage::attached:
      return true;
    case ChildMessage::constructor_failed:
      set_fault(packet.text());
      if (parameter_error_ && std::string_view(parameter_error_->what()) == fault()) {
        throw ConfigurationError(*parameter_error_);
      }
      throw PluginError(
          fmt::format("its constructor failed: {}", fault().empty() ? "it did not say why" : fault()));
    case ChildMessage::library_failed:
      throw PluginError(packet.text());
    default:
      throw PluginError("its process sent a message that plug-in processes do not send");
  }
}

template <class Function>
void IsolatedPlugin::grant(const Function& function) {
  std::string problem;
  try {
    return function();
  } catch (const ConfigurationError& error) {
    problem = error.what();
    parameter_error_ = std::make_unique<ConfigurationError>(error);
  } catch (const PluginError& error) {
    problem = error.what();
  }
  send_packet(link_->socket, PacketWriter(ChildMessage::refused).text(problem).bytes());
}

void IsolatedPlugin::take_topic(PacketReader& packet) {
  const std::string name = packet.text(), type_name = packet.text();
  gaitway_topic topic{name.c_str(), type_name.c_str(), packet.number<std::uint64_t>(), 0, 0, nullptr};
  topic.size = packet.number<std::uint32_t>();
  const auto access = packet.number<gaitway_access>();
  const auto count = packet.number<std::uint32_t>();
  std::list<std::string> names;
  std::vector<gaitway_float_field> fields;
  for (std::uint32_t i = 0; i < count; ++i) {
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
  topic.float_field_count = count;
  topic.float_fields = fields.data();
  if (replaced_ == 0) {
    declare_topic(&topic, access);
  } else {
    const auto port = declared_ports_ < ports_.size()
                          ? std::next(ports_.begin(), static_cast<std::ptrdiff_t>(declared_ports_))
                          : ports_.end();
    if (port == ports_.end() || port->use().topic != name || port->use().type_hash != topic.type_hash ||
        port->use().size != topic.size || port->use().access != static_cast<Access>(access)) {
      throw PluginError(fmt::format("opens topic '{}', unlike when it was first started", name));
    }
  }
  ++declared_ports_;
  send_packet(link_->socket, PacketWriter(ChildMessage::granted).bytes());
}

void IsolatedPlugin::take_parameter(PacketReader& packet) {
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
  const auto& known = parameters_.declared();
  if (replaced_ > 0 && std::none_of(known.begin(), known.end(),
                                    [&name](const Parameter& other) { return other.name == name; })) {
    throw PluginError(fmt::format("declares parameter '{}', unlike when it was first started", name));
  }
  const gaitway_value value = parameters_.declare(wanted);
  send_packet(link_->socket, PacketWriter(ChildMessage::granted).value(value).bytes());
}

void IsolatedPlugin::attach() {
  if (declared_ports_ != ports_.size()) {
    throw PluginError("opens fewer topics than when it was first started");
  }
  std::vector<std::uint32_t> sizes;
  for (const TopicPort& port : ports_) {
    sizes.push_back(port.use().size);
  }
  samples_.assign(ports_.size(), {});
  link_->attach(sizes);
}

void IsolatedPlugin::maintain(std::int64_t now_ns) noexcept {
  const bool runs = condition_ == Condition::active || condition_ == Condition::late;
  if (runs && !options_.lock_step && link_->process.has_ended()) {
    set_fault("");
    describe_end(ChildCall::end);
    lose(std::string(fault()), now_ns);
  } else if (condition_ == Condition::late && now_ns - late_ns_ > options_.hang_ns) {
    lose(fmt::format("has not answered for {} ms: its process was ended",
                     (now_ns - late_ns_) / kMillisecond_ns),
         now_ns);
  }
  try {
    // Real time: a process that the kernel still keeps is not waited for.
    const bool gone = options_.lock_step || !link_ || link_->process.has_ended();
    if (condition_ == Condition::lost && now_ns >= restart_ns_ && gone) {
      live_values_.clear();
      for (const Parameter& parameter : parameters_.declared()) {
        if (parameter.live) {
          live_values_.emplace_back(parameter.name, parameter.value);
        }
      }
      replaced_ns_[replaced_++ % replaced_ns_.size()] = now_ns;
      condition_ = Condition::creating;
      start();
    }
    const bool starts = condition_ == Condition::creating || condition_ == Condition::restoring ||
                        condition_ == Condition::activating;
    while (starts && condition_ != Condition::active && condition_ != Condition::lost &&
           advance(now_ns, options_.lock_step ? options_.start_limit_ns : kMillisecond_ns)) {
    }
  } catch (const std::exception& error) {
    lose(fmt::format("its process cannot be replaced: {}", error.what()), now_ns);
    events_.add(now_ns, tick_.tick, EventKind::error, name_, fault());
  }
}

// The next part of a start, if it comes within `wait_ns`.
bool IsolatedPlugin::advance(std::int64_t now_ns, std::int64_t wait_ns) {
  if (condition_ == Condition::creating) {
    if (!attend_start(wait_ns)) {
      return false;
    }
    begin_activation(now_ns);
    return true;
  }
  const Outcome outcome = await(wait_ns);
  if (outcome == Outcome::pending) {
    if (process::monotonic_ns() - start_began_ns_ > options_.start_limit_ns) {
      throw PluginError("it was not activated in time");
    }
    return false;
  }
  if (outcome == Outcome::ended || !take_reply() || status_ != GAITWAY_OK) {
    if (outcome == Outcome::ended) {
      describe_end(link_->calling);
    }
    throw PluginError(std::string(fault()));
  }
  if (condition_ == Condition::activating && restored_) {
    restore();
  } else {
    come_back(now_ns);
  }
  return true;
}

void IsolatedPlugin::begin_activation(std::int64_t now_ns) {
  const bool recent = state_->version != 0 && now_ns - state_ns_ < facts::kCycle_ns;
  restored_ = recent && !(restored_ && steps_since_start_ < kProven);
  steps_since_start_ = 0;
  copy_inputs();
  condition_ = Condition::activating;
  begin(ChildCall::activate);
}

void IsolatedPlugin::restore() {
  std::copy_n(state_->bytes.begin(), state_->size, link_->exchange().state);
  link_->exchange().request.state_size = state_->size;
  link_->exchange().request.state_version = state_->version;
  condition_ = Condition::restoring;
  begin(ChildCall::restore_state);
}

// What was changed while it ran is not in the configuration.
void IsolatedPlugin::reapply_parameters() {
  for (const auto& [name, text] : live_values_) {
    const auto& all = parameters_.declared();
    const auto now =
        std::find_if(all.begin(), all.end(), [&n = name](const Parameter& p) { return p.name == n; });
    if (now == all.end() || now->value == text) {
      continue;
    }
    const gaitway_value value = parameters_.read_change(name, text);
    if (!set_parameter(name.c_str(), value)) {
      throw PluginError(fmt::format("parameter '{}': {}", name, fault()));
    }
    parameters_.keep(name, value);
  }
}

void IsolatedPlugin::come_back(std::int64_t now_ns) {
  condition_ = Condition::active;
  came_back_ns_ = now_ns;
  reapply_parameters();
  events_.add(now_ns, tick_.tick, EventKind::info, name_,
              fmt::format("runs in a new process, {}, after {} ms",
                          restored_ ? "from the state of its last good step" : "started afresh",
                          (now_ns - lost_ns_) / kMillisecond_ns));
}

}  // namespace gaitway::core

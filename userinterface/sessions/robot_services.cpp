// The services of the robot itself, of the recording and of the plug-ins.
#include <algorithm>
#include <exception>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "client_message.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/facts/parameter_line.hpp"
#include "service_desk.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

constexpr const char* kPlainName = "at most 64 letters, digits, '-', '_' and '.', and not begin with '.'";

std::string seconds(std::int64_t ns) {
  return shown_json(json(static_cast<double>(ns) * 1e-9)) + " s";
}

bool is_plain_name(std::string_view name) {
  constexpr std::size_t kMost = 64;
  return name.size() <= kMost && !name.starts_with('.') && std::ranges::all_of(name, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                  c == '_' || c == '-';
         });
}

// As far as the manager's requests hold it.
void require_fit(const PluginOrder& order) {
  constexpr std::size_t kMostNameBytesOfPlugin = 47, kMostLibraryBytes = 399, kMostValueBytes = 95;
  require_short("the plug-in's name", order.plugin, kMostNameBytesOfPlugin);
  require_short("library", order.library, kMostLibraryBytes);
  require_short("parameter", order.parameter, kMostNameBytesOfPlugin);
  require_short("value", order.value, kMostValueBytes);
}

ros::ListRecordings::Response response_of(const OrderResult& result) {
  const RecordingList& found = result.recordings;
  ros::ListRecordings::Response response{result.done, result.text, {}};
  if (result.done && found.count == 0) {
    response.message = "there are no recordings";
  } else if (found.count != found.newest.size()) {
    response.message = "the newest " + std::to_string(found.newest.size()) + " of " +
                       std::to_string(found.count) + " recordings";
  }
  if (!found.complete) {
    response.message += "; the folder holds more, which are not looked at";
  }
  for (const RecordingStatus& recording : found.newest) {
    response.recordings.push_back({recording.file, recording.bytes, ros_time(recording.start_ns)});
  }
  return response;
}

}  // namespace

struct ServiceDesk::ParameterReading {
  ros::GetParameters::Response response;  // of the plug-in that is being read
  PluginOrder order;
  std::int64_t ends_ns = 0;
  std::vector<std::string> remaining;                             // plug-ins to be read after it
  std::function<void(const ros::GetParameters::Response&)> done;  // of the last one
};

void ServiceDesk::await_result(const Caller& caller, std::uint32_t order,
                               std::function<void(const ServiceCall&, const OrderResult&)> respond) {
  orders_.wait(order, caller.call.client, end_of_wait(caller),
               [this, call = caller.call, respond = std::move(respond)](const OrderResult* result) {
                 if (result == nullptr) {
                   const std::int64_t waited_ns = std::min(call.timeout_ns, limits_.answer_ns);
                   return send_(call, service_failure(
                                          call, "the robot has not answered within " + seconds(waited_ns)));
                 }
                 respond(call, *result);
               });
}

void ServiceDesk::stand(const Caller& caller) {
  static_cast<void>(request<ros::Trigger>(caller));
  stands_.require_room(caller.call.client);
  commands_.stand(caller.claimant, caller.now_ns);
  stands_.wait(caller.call, caller.now_ns, std::min(caller.call.timeout_ns, limits_.answer_ns));
  stands_.step(caller.now_ns);
}

void ServiceDesk::answer_stand(const ServiceCall& call, StandWaits::Outcome outcome,
                               const std::string& text) {
  if (outcome == StandWaits::Outcome::late) {
    return send_(call, service_failure(call, text));
  }
  reply(call, ros::Trigger::Response{outcome == StandWaits::Outcome::stands, text});
}

// A stop is carried out whatever is wrong with its arguments, and however many answers are waited for.
void ServiceDesk::stop(const Caller& caller) {
  const auto order = commands_.stop(caller.claimant);
  if (robot_.emergency_stopped()) {
    return reply(caller.call, ros::Trigger::Response{false, kEmergencyStopped});
  }
  await<ros::Trigger>(caller, order);
}

void ServiceDesk::emergency_stop(const Caller& caller) {
  bool soft = false;
  try {
    soft = request<ros::SetBool>(caller).data;
  } catch (const std::exception&) {
    // Hold, then.
  }
  await<ros::SetBool>(caller, commands_.emergency_stop(caller.claimant, soft));
}

void ServiceDesk::release(const Caller& caller) {
  static_cast<void>(request<ros::Trigger>(caller));
  orders_.require_room(caller.call.client);
  await<ros::Trigger>(caller, commands_.end_emergency_stop(caller.claimant, caller.now_ns));
}

void ServiceDesk::tell_walk_limits(const Caller& caller) {
  static_cast<void>(request<ros::WalkLimits>(caller));
  const double most = limits_.forward_m_per_s, turn = limits_.turn_rad_per_s;
  const std::optional<GaitBounds>& known = gait_.bounds();
  const GaitBounds gait = known.value_or(GaitBounds{most, most, most, turn});
  reply(caller.call,
        ros::WalkLimits::Response{
            known.has_value(),
            known ? "" : "the robot has not told what its gait walks: these are the API's limits",
            std::min(most, gait.forward_m_per_s), std::min(most, gait.backward_m_per_s),
            std::min(most, gait.left_m_per_s), std::min(turn, gait.turn_rad_per_s)});
}

void ServiceDesk::move_joint(const Caller& caller) {
  constexpr double kMost_s = 60.0;
  const auto asked = request<ros::MoveJoint>(caller);
  const auto& joints = robot_.joints();
  const auto joint = std::ranges::find(joints, asked.joint, &JointLimits::name);
  if (joint == joints.end()) {
    throw Refused("joint is " + shown(asked.joint) + ", but must be one of those in /joint_states");
  }
  if (!(asked.position >= joint->lower_rad && asked.position <= joint->upper_rad)) {
    throw Refused("position is " + shown_json(json(asked.position)) + ", but must be from " +
                  shown_json(json(joint->lower_rad)) + " to " + shown_json(json(joint->upper_rad)) +
                  " rad for " + shown(asked.joint));
  }
  if (!(asked.duration > 0.0 && asked.duration <= kMost_s)) {
    throw Refused("duration is " + shown_json(json(asked.duration)) + ", but must be above 0 and at most " +
                  shown_json(json(kMost_s)) + " s");
  }
  orders_.require_room(caller.call.client);
  await<ros::MoveJoint>(
      caller, commands_.move_joint(caller.claimant, static_cast<int>(joint - joints.begin()), asked.position,
                                   asked.duration, caller.now_ns));
}

void ServiceDesk::play_motion(const Caller& caller) {
  constexpr std::size_t kMostNameBytesOfMotion = 47;
  const auto asked = request<ros::PlayMotion>(caller);
  require_short("motion", asked.motion, kMostNameBytesOfMotion);
  if (asked.motion.empty()) {
    throw Refused("motion is empty, but must be the name of one; /stand leaves the one that plays");
  }
  orders_.require_room(caller.call.client);
  await<ros::PlayMotion>(caller, commands_.play_motion(caller.claimant, asked.motion, caller.now_ns));
}

void ServiceDesk::walk_to(const Caller& caller) {
  constexpr double kFarthest_m = 1000.0, kMostTurn_rad = 100.0;
  const auto asked = request<ros::WalkTo>(caller);
  const auto require = [](const char* name, double value, double most, const char* unit) {
    if (!(value >= -most && value <= most)) {
      throw Refused(std::string(name) + " is " + shown_json(json(value)) + ", but must be from " +
                    shown_json(json(-most)) + " to " + shown_json(json(most)) + " " + unit);
    }
  };
  require("x", asked.x, kFarthest_m, "m");
  require("y", asked.y, kFarthest_m, "m");
  require("yaw", asked.yaw, kMostTurn_rad, "rad");
  orders_.require_room(caller.call.client);
  await<ros::WalkTo>(caller,
                     commands_.walk_to(caller.claimant, {asked.x, asked.y, asked.yaw}, caller.now_ns));
}

void ServiceDesk::leave_way(const Caller& caller) {
  static_cast<void>(request<ros::Trigger>(caller));
  orders_.require_room(caller.call.client);
  await<ros::Trigger>(caller, commands_.leave_way(caller.claimant, caller.now_ns));
}

void ServiceDesk::start_recording(const Caller& caller) {
  const auto asked = request<ros::StartRecording>(caller);
  if (!is_plain_name(asked.name)) {
    throw Refused("name is " + shown(asked.name) + ", but must be " + kPlainName);
  }
  orders_.require_room(caller.call.client);
  try {
    const auto begun = [this, by = caller.claimant](const auto& call, const auto& result) {
      records_ = result.done ? std::optional(by) : records_;
      reply(call, result.done
                      ? ros::StartRecording::Response{true, "records into " + result.text, result.text}
                      : ros::StartRecording::Response{false, result.text, ""});
    };
    await_result(caller, robot_.start_recording(asked.name), begun);
  } catch (const std::runtime_error& error) {
    reply(caller.call, ros::StartRecording::Response{false, error.what(), ""});
  }
}

void ServiceDesk::require_own_recording(const Claimant& claimant) const {
  if (records_ && records_->number != claimant.number && !commands_.authority().held_by(claimant)) {
    throw CommandDenied("the recording is of \"" + records_->name +
                        "\": it is ended there, by who has the command, or once that client has gone");
  }
}

void ServiceDesk::stop_recording(const Caller& caller) {
  static_cast<void>(request<ros::Trigger>(caller));
  require_own_recording(caller.claimant);
  orders_.require_room(caller.call.client);
  try {
    await<ros::Trigger>(caller, robot_.stop_recording(), [this] { records_.reset(); });
  } catch (const std::runtime_error& error) {
    reply(caller.call, ros::Trigger::Response{false, error.what()});
  }
}

void ServiceDesk::list_recordings(const Caller& caller) {
  constexpr std::size_t kMostListed = 100;
  static_cast<void>(request<ros::ListRecordings>(caller));
  orders_.require_room(caller.call.client);
  try {
    await_result(caller, robot_.list_recordings(kMostListed),
                 [this](const auto& call, const auto& result) { reply(call, response_of(result)); });
  } catch (const std::runtime_error& error) {
    reply(caller.call, ros::ListRecordings::Response{false, error.what(), {}});
  }
}

void ServiceDesk::list_plugins(const Caller& caller) {
  static_cast<void>(request<ros::ListPlugins>(caller));
  ros::ListPlugins::Response response{true, "", {}};
  for (const PluginStatus& plugin : robot_.plugins()) {
    response.plugins.push_back({plugin.name, plugin.state, plugin.steps, plugin.faults, plugin.overruns,
                                plugin.p50_step_us, plugin.p99_step_us, plugin.worst_step_us});
  }
  reply(caller.call, response);
}

void ServiceDesk::require_plugin(const std::string& name) const {
  const auto plugins = robot_.plugins();
  if (std::ranges::none_of(plugins, [&name](const PluginStatus& plugin) { return plugin.name == name; })) {
    throw Refused("the plug-in is " + shown(name) + ", but must be one that /plugins/list lists");
  }
}

void ServiceDesk::change_plugin(PluginVerb verb, const Caller& caller) {
  const auto asked = request<ros::ChangePlugin>(caller);
  if (verb != PluginVerb::load) {
    require_plugin(asked.name);
  } else if (!is_plain_name(asked.name) || asked.name.empty()) {
    throw Refused("name is " + shown(asked.name) + ", but must be " + kPlainName);
  }
  orders_.require_room(caller.call.client);
  PluginOrder order;
  order.verb = verb;
  order.plugin = asked.name;
  order.library = asked.library;
  require_fit(order);
  await<ros::ChangePlugin>(caller, commands_.order(caller.claimant, order, caller.now_ns),
                           [this, name = asked.name] {
                             read_plugins_.erase(name);
                             gait_.read_again(name);
                           });
}

void ServiceDesk::set_parameter(const Caller& caller) {
  const auto asked = request<ros::SetParameter>(caller);
  require_plugin(asked.plugin);
  orders_.require_room(caller.call.client);
  PluginOrder order;
  order.verb = PluginVerb::set_parameter;
  order.plugin = asked.plugin;
  order.parameter = asked.parameter;
  order.value = asked.value;
  require_fit(order);
  await<ros::SetParameter>(caller, commands_.order(caller.claimant, order, caller.now_ns), [this, asked] {
    parameters_[asked.plugin + ":" + asked.parameter] = asked.value;
    gait_.read_again(asked.plugin);
  });
}

void ServiceDesk::set_rosapi_parameter(const Caller& caller) {
  const auto asked = request<ros::SetParam>(caller);
  const std::size_t colon = asked.name.find(':');
  if (colon == std::string::npos) {
    throw Refused("name is " + shown(asked.name) + ", but must be plug-in:parameter");
  }
  const json value = json::parse(asked.value, nullptr, false);
  if (!value.is_string() && !value.is_number() && !value.is_boolean()) {
    throw Refused("value is " + shown(asked.value) + ", but must be a JSON text, number or truth value");
  }
  PluginOrder order;
  order.verb = PluginVerb::set_parameter;
  order.plugin = asked.name.substr(0, colon);
  order.parameter = asked.name.substr(colon + 1);
  order.value = value.is_string() ? value.get<std::string>() : value.dump();
  require_fit(order);
  require_plugin(order.plugin);
  orders_.require_room(caller.call.client);
  await<ros::SetParam>(caller, commands_.order(caller.claimant, order, caller.now_ns),
                       [this, name = asked.name, order] {
                         parameters_[name] = order.value;
                         gait_.read_again(order.plugin);
                       });
}

void ServiceDesk::get_parameters(const Caller& caller) {
  const auto asked = request<ros::GetParameters>(caller);
  require_plugin(asked.plugin);
  read_parameters(caller, {asked.plugin},
                  [this, call = caller.call](const auto& response) { reply(call, response); });
}

void ServiceDesk::get_parameter_names(const Caller& caller) {
  const auto asked = request<ros::GetParamNames>(caller);
  std::vector<std::string> unread;
  for (const PluginStatus& plugin : robot_.plugins()) {
    if (!read_plugins_.contains(plugin.name)) unread.push_back(plugin.name);
  }
  const auto answer = [this, call = caller.call, asked](const auto&) { reply(call, rosapi_.answer(asked)); };
  if (unread.empty()) return answer(ros::GetParameters::Response{});
  read_parameters(caller, std::move(unread), answer);
}

void ServiceDesk::read_parameters(const Caller& caller, std::vector<std::string> plugins,
                                  std::function<void(const ros::GetParameters::Response&)> done) {
  orders_.require_room(caller.call.client);
  ParameterReading reading;
  reading.order.verb = PluginVerb::describe_parameter;
  reading.order.plugin = std::move(plugins.back());
  plugins.pop_back();
  reading.ends_ns = end_of_wait(caller);
  reading.remaining = std::move(plugins);
  reading.done = std::move(done);
  read_parameter(caller.call, std::move(reading));
}

// Asks for the parameter of the reading's index, then for the next, until the last plug-in has no more.
void ServiceDesk::read_parameter(const ServiceCall& call, ParameterReading reading) {
  constexpr std::uint32_t kMostRead = 256;
  const auto order = robot_.order(reading.order);
  if (!order) {
    return reply(call, ros::GetParameters::Response{false, std::string(kWayIsFull), {}, {}, {}, {}, {}});
  }
  const std::int64_t ends_ns = reading.ends_ns;
  orders_.wait(*order, call.client, ends_ns,
               [this, call, reading = std::move(reading)](const OrderResult* result) mutable {
                 if (result == nullptr) {
                   return send_(call, service_failure(call, "the robot has not told all parameters of " +
                                                                shown(reading.order.plugin) + " in time"));
                 }
                 if (keep_parameter(reading, *result) && ++reading.order.index < kMostRead) {
                   return read_parameter(call, std::move(reading));
                 }
                 read_plugins_.insert(reading.order.plugin);
                 if (reading.remaining.empty()) return reading.done(reading.response);
                 reading.order.plugin = std::move(reading.remaining.back());
                 reading.remaining.pop_back();
                 reading.order.index = 0;
                 reading.response = {};
                 read_parameter(call, std::move(reading));
               });
}

// False: it was none; the plug-in has told all.
bool ServiceDesk::keep_parameter(ParameterReading& reading, const OrderResult& result) {
  auto& response = reading.response;
  response.success = true;
  const auto parameter = result.done ? facts::read_parameter_line(result.text) : std::nullopt;
  if (!parameter) {
    response.success = !result.done;
    response.message = result.text;
    return false;
  }
  response.names.emplace_back(parameter->name);
  response.values.emplace_back(parameter->value);
  response.units.emplace_back(parameter->unit);
  response.docs.emplace_back(parameter->doc);
  response.live.push_back(parameter->live);
  parameters_[reading.order.plugin + ":" + response.names.back()] = response.values.back();
  return true;
}

}  // namespace gaitway::api

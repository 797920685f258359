// One request at a time, from one stage to the next.
#include "gaitway/manager/plugin_requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace gaitway::core {
namespace {

template <std::size_t size>
std::string_view view_of(const std::uint8_t (&field)[size]) noexcept {
  const auto* const text = reinterpret_cast<const char*>(field);
  return {text, strnlen(text, size)};
}

template <std::size_t size>
std::string text_of(const std::uint8_t (&field)[size]) {
  return std::string(view_of(field));
}

std::unique_ptr<PluginChange> prepared(PluginManager& manager, const PluginRequest& request) {
  const std::string plugin = text_of(request.plugin);
  const std::string library = text_of(request.library);
  switch (static_cast<PluginVerb>(request.verb)) {
    case PluginVerb::reload:
      return manager.changes().prepare_reload(plugin, library);
    case PluginVerb::load:
      return manager.changes().prepare_addition(
          {.name = plugin,
           .library = library.empty() ? fmt::format("libgaitway_plugin_{}.so", plugin) : library});
    case PluginVerb::unload:
      return manager.changes().prepare_removal(plugin);
    case PluginVerb::stop:
      return manager.changes().prepare_stop(plugin);
    case PluginVerb::start:
      return manager.changes().prepare_start(plugin);
    case PluginVerb::set:
    case PluginVerb::describe_parameter:
      break;
  }
  throw PluginError(fmt::format(
      "there is no verb {}: 0 reloads, 1 loads, 2 unloads, 3 sets a parameter, 4 stops, 5 starts, "
      "6 describes a parameter",
      request.verb));
}

void require_allowed_over_network(const PluginRequest& request, const PluginManager& manager) {
  const std::string plugin = text_of(request.plugin);
  const auto verb = static_cast<PluginVerb>(request.verb);
  if ((verb == PluginVerb::unload || verb == PluginVerb::stop) && manager.plugins().local_sockets(plugin)) {
    throw PluginError(
        fmt::format("'{0}' keeps the link over which this came: nothing could bring it back from there. "
                    "On the robot: gaitway ctl plugin {1} {0}",
                    plugin, verb == PluginVerb::unload ? "unload" : "stop"));
  }
  // A plug-in's name becomes its library's where there is none.
  for (const std::string& name : {text_of(request.library), plugin}) {
    if (name.find('/') != std::string::npos) {
      throw PluginError(fmt::format(
          "'{}': over the network a library is named without its folder. Put it on the plug-in path", name));
    }
  }
}

}  // namespace

PluginRequests::PluginRequests(msgclient::Client& client, PluginManager& manager)
    : manager_(manager),
      requests_{client.read_queue<PluginRequest>("plugin_request"),
                client.read_queue<PluginRequest>("api_plugin_request")},
      answers_(client.write_stream<PluginAnswer>("plugin_answer")) {
  refuse_what_waits();
}

// It outlived the main controller that was asked, and its asker's patience.
void PluginRequests::refuse_what_waits() noexcept {
  set_text("asked before this main controller was there, and not carried out: ask again");
  for (msgclient::QueueReader<PluginRequest>& queue : requests_) {
    while (const msgclient::ReadResult read = queue.pop(request_)) {
      answer(read.stamp_ns);
    }
  }
}

void PluginRequests::go_to(Stage stage) noexcept {
  Stage expected = stage_.load(std::memory_order_acquire);
  while (expected != Stage::ended &&
         !stage_.compare_exchange_weak(expected, stage, std::memory_order_acq_rel)) {
  }
  stage_.notify_all();
}

void PluginRequests::step(std::int64_t now_ns) noexcept {
  switch (stage_.load(std::memory_order_acquire)) {
    case Stage::idle:
      if (take_request()) {
        manager_.plugins().copy_value(view_of(request_.plugin), request_.index, value_);
        go_to(Stage::preparing);
      }
      break;
    case Stage::prepared:
      put_in_place();
      break;
    case Stage::scheduled:
      if (auto result = manager_.changes().take_result()) {
        done_ = result->done;
        changed_ = changed_ || done_;
        set_text(result->text);
        change_ = std::move(result->remains);
        go_to(Stage::clearing);
      }
      break;
    case Stage::answered:
      answer(now_ns);
      go_to(Stage::idle);
      break;
    case Stage::preparing:
    case Stage::clearing:
    case Stage::ended:
      break;
  }
}

// The queue that was served last comes second.
bool PluginRequests::take_request() noexcept {
  for (std::size_t i = 0; i < requests_.size(); ++i) {
    const std::size_t queue = (next_queue_ + i) % requests_.size();
    if (requests_[queue].pop(request_)) {
      from_network_ = queue == 1;
      next_queue_ = (queue + 1) % requests_.size();
      return true;
    }
  }
  return false;
}

void PluginRequests::put_in_place() noexcept {
  if (change_ != nullptr) {
    manager_.changes().schedule(std::move(change_));
    go_to(Stage::scheduled);
    return;
  }
  done_ = ChangeControl::apply(*parameter_);
  changed_ = changed_ || done_;
  if (!done_) {
    set_text(parameter_->slot->plugin->fault());
  }
  go_to(Stage::clearing);
}

void PluginRequests::set_text(std::string_view text) noexcept {
  copy_text(text, text_);
}

void PluginRequests::answer(std::int64_t now_ns) noexcept {
  PluginAnswer answer{};
  answer.number = request_.number;
  answer.done = done_ ? 1 : 0;
  std::memcpy(answer.text, text_.data(), sizeof answer.text);
  answers_.publish(answer, now_ns);
}

std::string PluginRequests::describe_parameter() const {
  const std::string plugin = text_of(request_.plugin);
  const auto& parameters = manager_.plugins().parameters_of(plugin).declared();
  if (request_.index >= parameters.size()) {
    throw PluginError(fmt::format("plug-in '{}' has {} parameters: there is no number {}, counted from 0",
                                  plugin, parameters.size(), request_.index));
  }
  const Parameter& parameter = parameters[request_.index];
  return parameter_line({.name = parameter.name,
                         .kind = parameter.kind,
                         .unit = parameter.unit,
                         .doc = parameter.doc,
                         .fallback = parameter.fallback,
                         .value = value_.data(),  // a copy: the tick's thread may change it
                         .lowest = parameter.lowest,
                         .highest = parameter.highest,
                         .live = parameter.live},
                        sizeof(PluginAnswer::text) - 1);
}

PluginRequests::Stage PluginRequests::prepare() {
  try {
    switch (static_cast<PluginVerb>(request_.verb)) {
      case PluginVerb::describe_parameter:
        set_text(describe_parameter());
        done_ = true;
        return Stage::answered;
      case PluginVerb::set:
        parameter_ = manager_.changes().prepare_parameter(
            text_of(request_.plugin), text_of(request_.parameter), text_of(request_.value));
        break;
      default:
        if (from_network_) {
          require_allowed_over_network(request_, manager_);
        }
        change_ = prepared(manager_, request_);
    }
    return Stage::prepared;
  } catch (const std::exception& error) {
    done_ = false;
    set_text(error.what());
    return Stage::answered;
  }
}

// What is no longer needed goes.
PluginRequests::Stage PluginRequests::clear() {
  if (parameter_ && done_) {
    ChangeControl::keep(*parameter_);
    set_text(fmt::format("{} is {} from now on", parameter_->parameter, parameter_->text));
  }
  parameter_.reset();
  change_.reset();
  return Stage::answered;
}

void PluginRequests::work() {
  const Stage stage = stage_.load(std::memory_order_acquire);
  if (stage != Stage::preparing && stage != Stage::clearing) {
    return;
  }
  const auto verb = static_cast<PluginVerb>(request_.verb);
  const bool runs_plugin = verb != PluginVerb::set && verb != PluginVerb::describe_parameter;
  StepWatch* const watch = runs_plugin ? manager_.step_watch() : nullptr;
  if (watch != nullptr) {
    watch->begin_change(view_of(request_.plugin));
  }
  const Stage next = stage == Stage::preparing ? prepare() : clear();
  if (watch != nullptr) {
    watch->end_change();
  }
  go_to(next);
}

bool PluginRequests::wait_for_work() const noexcept {
  while (true) {
    const Stage stage = stage_.load(std::memory_order_acquire);
    if (stage == Stage::ended) {
      return false;
    }
    if (stage == Stage::preparing || stage == Stage::clearing) {
      return true;
    }
    stage_.wait(stage, std::memory_order_acquire);
  }
}

void PluginRequests::end_work() noexcept {
  stage_.store(Stage::ended, std::memory_order_release);
  stage_.notify_all();
}

}  // namespace gaitway::core

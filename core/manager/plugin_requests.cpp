// One request at a time, from one stage to the next.
#include "gaitway/manager/plugin_requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "parameter_line.hpp"

namespace gaitway::core {
namespace {

template <std::size_t size>
std::string text_of(const std::uint8_t (&field)[size]) {
  const auto* const text = reinterpret_cast<const char*>(field);
  return {text, strnlen(text, size)};
}

std::unique_ptr<PluginChange> prepared(PluginManager& manager, const PluginRequest& request) {
  const std::string plugin = text_of(request.plugin);
  const std::string library = text_of(request.library);
  switch (static_cast<PluginVerb>(request.verb)) {
    case PluginVerb::reload:
      return manager.prepare_reload(plugin, library);
    case PluginVerb::load:
      return manager.prepare_addition(
          {.name = plugin,
           .library = library.empty() ? fmt::format("libgaitway_plugin_{}.so", plugin) : library});
    case PluginVerb::unload:
      return manager.prepare_removal(plugin);
    case PluginVerb::stop:
      return manager.prepare_stop(plugin);
    case PluginVerb::start:
      return manager.prepare_start(plugin);
    case PluginVerb::set:
    case PluginVerb::describe_parameter:
      break;
  }
  throw PluginError(fmt::format(
      "there is no verb {}: 0 reloads, 1 loads, 2 unloads, 3 sets a parameter, 4 stops, 5 starts, "
      "6 describes a parameter",
      request.verb));
}

// A plug-in's name becomes its library's where there is none.
void require_no_path(const PluginRequest& request) {
  for (const std::string& name : {text_of(request.library), text_of(request.plugin)}) {
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
      answers_(client.write_stream<PluginAnswer>("plugin_answer")) {}

void PluginRequests::go_to(Stage stage) noexcept {
  Stage expected = stage_.load(std::memory_order_acquire);
  while (expected != Stage::ended &&
         !stage_.compare_exchange_weak(expected, stage, std::memory_order_acq_rel)) {
  }
  stage_.notify_all();
}

void PluginRequests::step(std::int64_t now_ns) {
  switch (stage_.load(std::memory_order_acquire)) {
    case Stage::idle:
      if (take_request()) {
        begin(now_ns);
      }
      break;
    case Stage::prepared:
      manager_.schedule(std::move(change_));
      go_to(Stage::scheduled);
      break;
    case Stage::scheduled:
      if (auto result = manager_.take_result()) {
        done_ = result->done;
        text_ = std::move(result->text);
        change_ = std::move(result->remains);
        go_to(Stage::clearing);
      }
      break;
    case Stage::refused:
    case Stage::cleared:
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
bool PluginRequests::take_request() {
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

void PluginRequests::begin(std::int64_t now_ns) {
  try {
    switch (static_cast<PluginVerb>(request_.verb)) {
      case PluginVerb::set:
        set_parameter();
        break;
      case PluginVerb::describe_parameter:
        describe_parameter();
        break;
      default:
        if (from_network_) {
          require_no_path(request_);
        }
        go_to(Stage::preparing);
        return;
    }
    done_ = true;
  } catch (const std::exception& error) {
    done_ = false;
    text_ = error.what();
  }
  answer(now_ns);
}

void PluginRequests::set_parameter() {
  const std::string parameter = text_of(request_.parameter);
  const std::string value = text_of(request_.value);
  manager_.set_parameter(text_of(request_.plugin), parameter, value);
  text_ = fmt::format("{} is {} from now on", parameter, value);
}

void PluginRequests::describe_parameter() {
  const std::string plugin = text_of(request_.plugin);
  const auto& parameters = manager_.parameters_of(plugin).declared();
  if (request_.index >= parameters.size()) {
    throw PluginError(fmt::format("plug-in '{}' has {} parameters: there is no number {}, counted from 0",
                                  plugin, parameters.size(), request_.index));
  }
  text_ = parameter_line(parameters[request_.index], sizeof(PluginAnswer::text) - 1);
}

void PluginRequests::answer(std::int64_t now_ns) {
  PluginAnswer answer{};
  answer.number = request_.number;
  answer.done = done_ ? 1 : 0;
  std::memcpy(answer.text, text_.data(), std::min(text_.size(), sizeof answer.text - 1));
  answers_.publish(answer, now_ns);
}

void PluginRequests::prepare() {
  try {
    change_ = prepared(manager_, request_);
    go_to(Stage::prepared);
  } catch (const std::exception& error) {
    done_ = false;
    text_ = error.what();
    go_to(Stage::refused);
  }
}

void PluginRequests::work() {
  const Stage stage = stage_.load(std::memory_order_acquire);
  if (stage == Stage::preparing) {
    prepare();
  } else if (stage == Stage::clearing) {
    change_.reset();
    go_to(Stage::cleared);
  }
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

// One request at a time, from one stage to the next.
#include "gaitway/core/plugin_requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

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
      break;
  }
  throw PluginError(
      fmt::format("there is no verb {}: 0 reloads, 1 loads, 2 unloads, 3 sets a parameter, 4 stops, 5 starts",
                  request.verb));
}

}  // namespace

PluginRequests::PluginRequests(msgclient::Client& client, PluginManager& manager)
    : manager_(manager),
      requests_(client.read_queue<PluginRequest>("plugin_request")),
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
      if (requests_.pop(request_)) {
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

void PluginRequests::begin(std::int64_t now_ns) {
  if (static_cast<PluginVerb>(request_.verb) != PluginVerb::set) {
    go_to(Stage::preparing);
    return;
  }
  const std::string parameter = text_of(request_.parameter);
  const std::string value = text_of(request_.value);
  try {
    manager_.set_parameter(text_of(request_.plugin), parameter, value);
    done_ = true;
    text_ = fmt::format("{} is {} from now on", parameter, value);
  } catch (const std::exception& error) {
    done_ = false;
    text_ = error.what();
  }
  answer(now_ns);
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

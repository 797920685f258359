// Requests to change the plug-ins while the robot walks: taken from the queue `plugin_request`, answered in
// the stream `plugin_answer`. What takes its time is done by a second thread, which the binary owns.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "gaitway/core/plugin_manager.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {

enum class PluginVerb : std::uint32_t { reload = 0, load = 1, unload = 2, set = 3, stop = 4, start = 5 };

class PluginRequests {
 public:
  // Opens the two topics. Throws msgclient::TopicError. Both outlive this object.
  PluginRequests(msgclient::Client& client, PluginManager& manager);

  // The thread of the ticks, after each: takes a request, hands what was prepared to the manager, answers.
  void step(std::int64_t now_ns);

  // The other thread: loads, constructs and destroys. work() returns at once when there is nothing to do.
  void work();
  // Sleeps until there is something to do, or end_work() was called; then false, for ever.
  [[nodiscard]] bool wait_for_work() const noexcept;
  void end_work() noexcept;  // from any thread

 private:
  // Whose turn it is: step()'s, but for preparing and clearing.
  enum class Stage : std::uint32_t {
    idle,
    preparing,
    prepared,
    refused,
    scheduled,
    clearing,
    cleared,
    ended
  };

  void begin(std::int64_t now_ns);
  void prepare();
  void answer(std::int64_t now_ns);
  void go_to(Stage stage) noexcept;

  PluginManager& manager_;
  msgclient::QueueReader<PluginRequest> requests_;
  msgclient::Writer<PluginAnswer> answers_;
  std::atomic<Stage> stage_{Stage::idle};
  PluginRequest request_{};
  bool done_ = false;
  std::string text_;
  std::unique_ptr<PluginChange> change_;  // prepared, or no longer needed
};

}  // namespace gaitway::core

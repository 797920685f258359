// Requests to change the plug-ins while the robot walks: taken from the queues `plugin_request` and
// `api_plugin_request` by turns, answered in the stream `plugin_answer`. What takes its time or allocates is
// done by a second thread, which the binary owns. What comes over the network (`api_plugin_request`) names
// libraries of the search path and no other files: who can write a file somewhere must not have it run here.
// And it takes no plug-in away that keeps the link: nothing could bring that back from there.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "gaitway/manager/plugin_manager.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {

enum class PluginVerb : std::uint32_t {
  reload = 0,
  load = 1,
  unload = 2,
  set = 3,
  stop = 4,
  start = 5,
  describe_parameter = 6  // answered with a line of facts/parameter_line.hpp
};

class PluginRequests {
 public:
  // Opens the three topics, and refuses what has been asked before. Throws msgclient::TopicError. Both
  // outlive this object.
  PluginRequests(msgclient::Client& client, PluginManager& manager);

  // The thread of the ticks, after each: takes a request, hands what was prepared to the manager, answers. No
  // allocation, lock or exception.
  void step(std::int64_t now_ns) noexcept;

  // The other thread: reads requests, loads, constructs and destroys, finds words. work() returns at once
  // when there is nothing to do.
  void work();
  // Sleeps until there is something to do, or end_work() was called; then false, for ever.
  [[nodiscard]] bool wait_for_work() const noexcept;
  void end_work() noexcept;  // from any thread
  // Whether a change or a parameter has been put in place since the last call; by the thread of the ticks.
  [[nodiscard]] bool take_change() noexcept { return std::exchange(changed_, false); }

 private:
  // Whose turn it is: step()'s, where nothing else is said.
  enum class Stage : std::uint32_t {
    idle,
    preparing,  // work()'s turn
    prepared,
    scheduled,
    clearing,  // work()'s turn
    answered,  // the answer's text is there
    ended
  };

  void refuse_what_waits() noexcept;
  bool take_request() noexcept;
  void put_in_place() noexcept;  // what was prepared
  [[nodiscard]] std::string describe_parameter() const;
  Stage prepare();  // what comes next
  Stage clear();
  void set_text(std::string_view text) noexcept;
  void answer(std::int64_t now_ns) noexcept;
  void go_to(Stage stage) noexcept;

  PluginManager& manager_;
  std::array<msgclient::QueueReader<PluginRequest>, 2> requests_;  // of this machine, and of the network
  msgclient::Writer<PluginAnswer> answers_;
  std::atomic<Stage> stage_{Stage::idle};
  std::size_t next_queue_ = 0;
  bool from_network_ = false;
  PluginRequest request_{};
  bool done_ = false;
  bool changed_ = false;
  std::array<char, sizeof(PluginAnswer::text)> text_{};   // of the answer
  std::array<char, sizeof(PluginAnswer::text)> value_{};  // of the parameter that is to be described
  std::unique_ptr<PluginChange> change_;                  // prepared, or no longer needed
  std::optional<ParameterChange> parameter_;              // prepared, or in place
};

// The thread beside the ticks that loads and destroys plug-ins when somebody asks for a change, for binaries.
// Works at ordinary priority, from construction to destruction.
class PluginWorkshop {
 public:
  // `requests` outlives it, and is stepped by another thread.
  explicit PluginWorkshop(PluginRequests& requests)
      : requests_(requests), thread_([&requests] {
          while (requests.wait_for_work()) {
            requests.work();
          }
        }) {}
  PluginWorkshop(const PluginWorkshop&) = delete;
  PluginWorkshop& operator=(const PluginWorkshop&) = delete;
  ~PluginWorkshop() { requests_.end_work(); }

 private:
  PluginRequests& requests_;
  std::jthread thread_;  // joined after end_work()
};

}  // namespace gaitway::core

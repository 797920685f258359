// The other end of an isolated plug-in: loads its code, asks the manager for what it declares, and runs
// its calls on values in the shared segment.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "exchange.hpp"
#include "gaitway/instance/event_log.hpp"
#include "gaitway/instance/plugin_instance.hpp"
#include "gaitway/instance/plugin_library.hpp"
#include "gaitway/instance/topic_port.hpp"
#include "gaitway/msgclient/segment.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "messages.hpp"

namespace gaitway::core {

inline constexpr int kChildSocket = 3;                   // where the manager left it
inline constexpr const char* kLocalSockets = "sockets";  // last word of the child's command line, or another

// --- What it can still tell when it dies, and when it has used up what it may use (last_words.cpp).

// Deaths inside this plug-in's library are told as offsets into it.
void describe_deaths_in(const gaitway_plugin& entry) noexcept;
// A signal that ends this process writes here what it knows; the process still ends by that signal.
void leave_last_words_in(LastWords& words) noexcept;

enum class Resource : std::uint32_t { none = 0, memory = 1, descriptors = 2 };
// What is as good as used up.
[[nodiscard]] Resource exhausted_resource() noexcept;

// A plug-in's code, once the child has been told which to load.
struct PluginCode {
  const gaitway_plugin& entry;
  std::filesystem::path file;
};
// As PluginLibrary takes it. The code outlives the program. Throws PluginError.
using LoadCode = std::function<PluginCode(const std::string& library, const std::filesystem::path& base,
                                          const SearchPath& path)>;

// A child from its command line to its end: enters its bounds, and runs what `load` loads. `words`: what the
// manager has put after the program's name. Returns the exit code, for _exit(): what the plug-in left for the
// process's end must not run beside a manager that waits.
int run_child(std::span<const char* const> words, const LoadCode& load);

class ChildProgram final : private PluginDeclarations, private PluginSurroundings {
 public:
  ChildProgram(process::FileDescriptor socket, LoadCode load)
      : socket_(std::move(socket)), load_(std::move(load)) {}
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  // Until the manager says so, or goes. Returns the exit code.
  int run();

 private:
  struct Port {
    Access access = Access::read;
    std::uint32_t size = 0;
    PortArea* area = nullptr;
    [[nodiscard]] std::byte* value() const noexcept { return reinterpret_cast<std::byte*>(area + 1); }
  };

  // What the plug-in is offered: it declares by asking the manager, and its values lie in the segment.
  gaitway_port* open_topic(const gaitway_topic& topic, gaitway_access access) override;
  gaitway_value declare_parameter(const gaitway_parameter& parameter) override;
  void set_period(gaitway_period period) override;
  void report(gaitway_severity severity, std::string_view text) noexcept override;
  const char* robot_directory() const noexcept override { return robot_directory_.c_str(); }
  const char* memory_socket() const noexcept override { return memory_socket_.c_str(); }
  gaitway_status read(gaitway_port& port, void* value, gaitway_sample& sample) noexcept override;
  gaitway_status publish(gaitway_port& port, const void* value) noexcept override;
  // Throws PluginError with what the manager refuses it with.
  std::vector<std::byte> ask(const PacketWriter& question);

  bool tell(const PacketWriter& packet) {
    return send_packet(socket_, packet.bytes(), Wait::yes) == Sent::whole;
  }
  bool create();
  bool load(const std::string& file, const std::filesystem::path& base, const SearchPath& path);
  bool construct();
  bool attach();
  void serve();
  void answer(const ChildRequest& request, ChildReply& reply) noexcept;
  void put_report(gaitway_severity severity, std::string_view text) noexcept;
  gaitway_status call(const ChildRequest& request, ChildReply& reply, const gaitway_text& error) noexcept;
  gaitway_status step(const ChildRequest& request, ChildReply& reply, const gaitway_text& error) noexcept;
  gaitway_status save_state(ChildReply& reply, const gaitway_text& error) noexcept;
  gaitway_status set_parameter(const ChildRequest& request, const gaitway_text& error) noexcept;

  process::FileDescriptor socket_;
  LoadCode load_;
  std::optional<PluginCode> code_;
  std::string robot_directory_, memory_socket_;
  std::deque<Port> ports_;       // stable addresses: the plug-in holds them
  std::set<std::string> texts_;  // values of parameters: the plug-in may keep them
  PluginInstance instance_{*this, *this};
  bool hands_state_on_ = true;  // until a save shows that it does not
  std::unique_ptr<msgclient::Segment> segment_;
  ExchangeHeader* exchange_ = nullptr;
  const std::thread::id caller_ = std::this_thread::get_id();  // of the plug-in
  EventLog posts_;                                             // what its other threads report
  std::uint64_t passed_on_ = 0;                                // of them
};

}  // namespace gaitway::core

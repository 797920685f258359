// The other end of an isolated plug-in: loads its library, asks the manager for what it declares, and runs
// its calls on values in the shared segment.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "exchange.hpp"
#include "gaitway/manager/data_flow.hpp"
#include "gaitway/manager/event_log.hpp"
#include "gaitway/manager/plugin_library.hpp"
#include "gaitway/msgclient/segment.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "messages.hpp"

namespace gaitway::core {

inline constexpr int kChildSocket = 3;                   // where the manager left it
inline constexpr const char* kServesNetwork = "serves";  // last word of the child's command line, or another

class ChildProgram {
 public:
  // `serves_network`: it is bound as network_bounds.hpp says.
  ChildProgram(process::FileDescriptor socket, bool serves_network)
      : socket_(std::move(socket)), serves_network_(serves_network) {}
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
  struct Functions;  // of gaitway_host
  enum class Phase : std::uint8_t { creating, idle, stepping };

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
  gaitway_status restore_state(const ChildRequest& request, const gaitway_text& error) noexcept;
  gaitway_status set_parameter(const ChildRequest& request, const gaitway_text& error) noexcept;

  process::FileDescriptor socket_;
  const bool serves_network_;
  bool may_write_ = false;  // of one that does, once it is set up
  std::unique_ptr<PluginLibrary> library_;
  std::string robot_directory_, memory_socket_, write_folder_;
  std::deque<Port> ports_;         // stable addresses: the plug-in holds them
  std::deque<std::string> texts_;  // values of parameters
  gaitway_host host_{};
  gaitway_instance instance_{};
  Phase phase_ = Phase::creating;
  bool hands_state_on_ = true;  // until a save shows that it does not
  std::unique_ptr<msgclient::Segment> segment_;
  ExchangeHeader* exchange_ = nullptr;
  const std::thread::id caller_ = std::this_thread::get_id();  // of the plug-in
  EventLog posts_;                                             // what its other threads report
  std::uint64_t passed_on_ = 0;                                // of them
};

}  // namespace gaitway::core

// One child as the manager holds it: its process, its socket, the segment that both share, and calls over it.
// Between a call and its answer nothing is allocated and nothing locked; the futex is the only system call
// while all goes well.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "child_process.hpp"
#include "exchange.hpp"
#include "gaitway/instance/plugin_instance.hpp"
#include "gaitway/instance/topic_port.hpp"
#include "gaitway/msgclient/segment.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "messages.hpp"

namespace gaitway::core {

class Child {
 public:
  using Ports = std::list<TopicPort>;

  // Starts it. `library`: what texts call the plug-in's; outlives it. Throws PluginError.
  Child(const std::filesystem::path& binary, const ChildBounds& bounds, const std::string& library);

  // --- While it starts, over the socket. Sends without waiting; throws PluginError if it does not read.
  void send(std::span<const std::byte> packet, int descriptor = -1);
  [[nodiscard]] Receipt receive() { return receive_packet(socket_, packet_, Wait::no); }
  [[nodiscard]] std::span<const std::byte> packet() const noexcept { return packet_; }  // received last
  // Waits at most so long for a message or its end; once it has hung up, for its end alone.
  void wait_for_message(int timeout_ms, bool hung_up) const noexcept;
  // Makes the segment and hands it over. Throws PluginError.
  void attach(const Ports& ports);

  // --- Calls over the segment.
  [[nodiscard]] ChildRequest& request() noexcept { return exchange().request; }
  void copy_in(Ports& ports) noexcept;         // inputs that are newer than what it has
  void copy_out(Ports& ports) const noexcept;  // what it published is staged
  void begin(ChildCall call) noexcept;
  enum class Result : std::uint8_t {
    done,
    failed,   // the plug-in says why
    pending,  // it may still be answered
    lost      // its process ended, or the segment holds what no child writes
  };
  // Waits at most so long for the answer to what was begun; text() says what became of it. What the plug-in
  // reported goes to `reports`.
  Result finish(std::int64_t limit_ns, PluginDeclarations& reports) noexcept;
  // Waits at most so long for what finish() would find without waiting. False: there is nothing yet.
  [[nodiscard]] bool wait(std::int64_t limit_ns) noexcept;
  [[nodiscard]] bool has_answered() const noexcept { return exchange().answer.number.load() != called_ - 1; }
  [[nodiscard]] std::string_view text() const noexcept { return text_.data(); }
  [[nodiscard]] std::string_view calling() const noexcept;  // the last call, for people
  [[nodiscard]] std::string_view exhausted()
      const noexcept;  // what a failed step has used up; empty: nothing
  // The state that it handed out; false: it claims more than there is room for. And the other way.
  bool take_state(PluginState& state) const noexcept;
  void put_state(const PluginState& state) noexcept;
  // For set_parameter. False: too long.
  bool put_parameter(const char* name, const gaitway_value& value) noexcept;

  // Of one that has ended: says so in text(), and takes the reports of its last moments.
  void describe_end(std::string_view during, PluginDeclarations& reports) noexcept;
  [[nodiscard]] ChildProcess& process() noexcept { return process_; }

 private:
  [[nodiscard]] ExchangeHeader& exchange() const noexcept {
    return *static_cast<ExchangeHeader*>(segment_->data());
  }
  [[nodiscard]] PortArea& port(std::size_t index) const noexcept {
    return *reinterpret_cast<PortArea*>(static_cast<std::byte*>(segment_->data()) +
                                        layout_->port_offset[index]);
  }
  [[nodiscard]] std::byte* value(std::size_t index) const noexcept {
    return reinterpret_cast<std::byte*>(&port(index) + 1);
  }
  [[nodiscard]] bool is_whole() const noexcept;  // the marks between the areas are as they were
  void take_reports(PluginDeclarations& to) const noexcept;

  process::FileDescriptor socket_;
  ChildProcess process_;
  std::vector<std::byte> packet_;
  std::unique_ptr<msgclient::Segment> segment_;
  std::unique_ptr<ExchangeLayout> layout_;
  std::vector<gaitway_sample> samples_;  // of the ports, as the child has them
  Spin spin_;
  std::uint32_t called_ = 0;  // number of the last call
  ChildCall calling_ = ChildCall::end;
  const std::string& library_;
  std::array<char, sizeof ChildReply::text> text_{};
};

}  // namespace gaitway::core

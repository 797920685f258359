// The manager's end of one child: its process, its socket, the shared segment.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "child_process.hpp"
#include "exchange.hpp"
#include "gaitway/msgclient/segment.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "messages.hpp"

namespace gaitway::core {

class ChildLink {
 public:
  // Starts the child. Throws PluginError.
  ChildLink(const std::filesystem::path& binary, const ChildBounds& bounds);

  // Makes the segment and hands it over. Throws PluginError.
  void attach(const std::vector<std::uint32_t>& port_sizes);
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
  // Whether the marks between the areas are as they were.
  [[nodiscard]] bool is_whole() const noexcept;
  // Waits at most so long for a message or the child's end.
  void wait_for_message(int timeout_ms) const noexcept;

  process::FileDescriptor socket;
  ChildProcess process;
  Spin spin;
  std::uint32_t called = 0;            // number of the last call
  ChildCall calling = ChildCall::end;  // what it is
  std::vector<std::byte> packet;

 private:
  std::unique_ptr<msgclient::Segment> segment_;
  std::unique_ptr<ExchangeLayout> layout_;
};

}  // namespace gaitway::core

// Gives the memory block to other processes from a thread of its own, where the owner waits for what such a
// process does: a plug-in's constructor, for example.
#pragma once

#include <poll.h>

#include <array>
#include <filesystem>
#include <stop_token>
#include <thread>

#include "gaitway/msgclient/memory_block_server.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::msgclient {

class MemoryBlockThread {
 public:
  // As MemoryBlockServer.
  MemoryBlockThread(const MemoryBlock& block, const std::filesystem::path& socket)
      : server_(block, socket), thread_([this](const std::stop_token& stop) {
          std::array<pollfd, 1> wakes{pollfd{server_.wake_fd(), POLLIN, 0}};
          while (!stop.stop_requested()) {
            poll(wakes.data(), wakes.size(), kLook_ms);
            server_.step(process::monotonic_ns());
          }
        }) {}

 private:
  static constexpr int kLook_ms = 100;  // for the wish to stop
  MemoryBlockServer server_;
  std::jthread thread_;
};

}  // namespace gaitway::msgclient

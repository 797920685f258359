// Takes stops by datagram in a thread of its own, so that nothing that clients of the server do delays one.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/api/module_link.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/stopgram/stop_desk.hpp"
#include "gaitway/stopgram/stop_socket.hpp"

namespace gaitway::api {

// Stops that have been passed on to the robot.
struct PostedStops {
  std::uint32_t count = 0;
  link::StopKind kind = link::StopKind::stop;  // of the newest
  stopgram::Peer from;                         // who asked for it
};

// For people: "stop by datagram from 192.168.1.7:5000".
[[nodiscard]] std::string text_of(const PostedStops& stops);

class StopPost {
 public:
  // `link` outlives it, and must wake its thread by then. Throws std::system_error and
  // stopgram::StopKeyError.
  StopPost(ModuleLink& link, stopgram::StopSocket socket, stopgram::StopKey key);
  StopPost(const StopPost&) = delete;
  StopPost& operator=(const StopPost&) = delete;
  ~StopPost();

  // Those since it was asked last, if any: whoever commands must not go on, and the link wants see_stops().
  [[nodiscard]] std::optional<PostedStops> take_stops();
  // Lines about who was refused.
  [[nodiscard]] std::vector<std::string> take_refusals();

 private:
  void run(const std::stop_token& stop);
  void take_datagrams();
  void note_refusals();

  ModuleLink& link_;
  stopgram::StopSocket socket_;
  stopgram::StopDesk desk_;
  process::FileDescriptor wake_;  // an eventfd
  std::mutex mutex_;              // of what follows
  PostedStops stops_;
  std::vector<std::string> refusals_;
  std::jthread thread_;
};

}  // namespace gaitway::api

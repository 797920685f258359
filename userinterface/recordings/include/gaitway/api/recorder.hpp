// Records what the feed publishes, and never waits for a disk: files are read and written in a thread of the
// recorder's own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "gaitway/api/cdr_codec.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/recording_folder.hpp"
#include "gaitway/api/robot_port.hpp"

namespace gaitway::api {

struct RecorderOptions {
  RecordingLimits limits = {};
  RecordingDisk disk = RecordingDisk::real();
  std::size_t waiting_bytes = 16 << 20;  // for the disk, at most: then the recording ends
};

// Takes what the feed publishes, from the feed's first poll on. The last message of each latched topic is
// kept, and is the first of every recording. For one thread.
class Recorder {
 public:
  // `folder`: as of RecordingFolder. Starts the thread.
  explicit Recorder(std::filesystem::path folder, RecorderOptions options = {});
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  // Ends the recording. A disk that takes nothing for half a second is left to itself.
  ~Recorder();

  // Orders, answered by take_result() under their `number` with the file's path, the recordings, or what
  // RecordingFolder refuses. Throw std::runtime_error, for people, when too much waits for the disk.
  void start(std::uint32_t number, std::string name, std::int64_t robot_ns);
  void stop(std::uint32_t number);
  void list(std::uint32_t number, std::size_t most);
  [[nodiscard]] std::optional<OrderResult> take_result();

  // Time passes: once a second what waits is written. To be called every 100 ms or so.
  void step(std::int64_t wall_ns);
  // Why the recording has ended by itself, for people.
  [[nodiscard]] std::optional<std::string> take_report();

  // Whether publish() would do anything.
  [[nodiscard]] bool wants(Topic topic) const { return recording() || row(topic).latched; }
  template <class Message>
  void publish(Topic topic, const Message& message, std::int64_t robot_ns) {
    if (!wants(topic)) {
      return;
    }
    std::string encoded;
    append_cdr(encoded, message);
    if (row(topic).latched) {
      latched_[static_cast<std::size_t>(topic)] = encoded;
    }
    if (recording()) {
      write(topic, std::move(encoded), robot_ns);
    }
  }

 private:
  class Desk;

  [[nodiscard]] bool recording() const noexcept;
  void write(Topic topic, std::string data, std::int64_t robot_ns);

  std::shared_ptr<Desk> desk_;  // the thread's, too
  std::thread thread_;
  std::array<std::string, kTopicCount> latched_;  // last message, encoded; empty: none yet
  std::optional<std::int64_t> flushed_wall_ns_;
};

}  // namespace gaitway::api

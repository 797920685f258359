// Records what the feed publishes into MCAP files in one folder.
#pragma once

#include <dirent.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/api/cdr_codec.hpp"
#include "gaitway/api/mcap_writer.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/robot_port.hpp"

namespace gaitway::api {

inline constexpr std::uint64_t kRecordingLimit_bytes = std::uint64_t{4} << 30;

// Whether a recording may be called so: 1 to 100 of A-Z a-z 0-9 . _ - and no dot in front.
[[nodiscard]] bool is_recording_name(std::string_view name) noexcept;

// Takes what the feed publishes, from the feed's first poll on. The last message of each
// latched topic is kept, and is the first of every recording. Log and publish time are the robot's clock.
// Writes in the caller's thread, a chunk at a time.
class Recorder {
 public:
  // `folder`: exists; it is opened here, and files are made beneath it only. Throws std::runtime_error when
  // it cannot be opened.
  explicit Recorder(std::filesystem::path folder, std::uint64_t limit_bytes = kRecordingLimit_bytes);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();  // ends the recording

  // Makes <name>.mcap and gives its path. Throws std::runtime_error, for people, when a recording is under
  // way, the name is not plain or taken, or the file cannot be made: nothing is overwritten.
  std::string start(std::string_view name, std::int64_t robot_ns);
  // Ends the recording: path of the finished file. Throws std::runtime_error when none is under way or its
  // end could not be written (none is then under way, either).
  std::string stop();
  [[nodiscard]] bool recording() const noexcept { return writer_ != nullptr; }
  // The folder's recordings, also of others: at most so many, the newest. Opens nothing.
  [[nodiscard]] RecordingList list(std::size_t most) const;

  // Time passes: once a second what waits is written. To be called every 100 ms or so.
  void step(std::int64_t wall_ns);
  // Why the recording has ended by itself, for people: the disk is full, or the file is as large as it may
  // be.
  [[nodiscard]] std::optional<std::string> take_report();

  // Whether publish() would do anything.
  [[nodiscard]] bool wants(Topic topic) const { return recording() || row(topic).latched; }
  template <class Message>
  void publish(Topic topic, const Message& message, std::int64_t robot_ns) {
    if (!wants(topic)) {
      return;
    }
    encoded_.clear();
    append_cdr(encoded_, message);
    if (row(topic).latched) {
      latched_[static_cast<std::size_t>(topic)] = encoded_;
    }
    if (recording()) {
      write(topic, encoded_, robot_ns);
    }
  }

 private:
  void write(Topic topic, std::string_view data, std::int64_t robot_ns);
  void end(std::string_view reason);
  [[nodiscard]] std::string path() const;

  struct CloseFolder {
    void operator()(DIR* folder) const noexcept { ::closedir(folder); }
  };

  std::filesystem::path folder_;
  std::unique_ptr<DIR, CloseFolder> opened_;
  std::uint64_t limit_bytes_;
  std::unique_ptr<McapWriter> writer_;  // while recording
  std::string file_name_;
  std::optional<std::int64_t> flushed_wall_ns_;
  std::array<std::string, kTopicCount> latched_;  // last message, encoded; empty: none yet
  std::string encoded_;
  std::optional<std::string> report_;
};

}  // namespace gaitway::api

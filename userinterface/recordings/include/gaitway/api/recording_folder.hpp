// Recordings as MCAP files in one folder, within limits of their size, their number and the disk's free
// space.
#pragma once

#include <dirent.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/api/mcap_writer.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/robot_port.hpp"

namespace gaitway::api {

inline constexpr std::uint64_t kRecordingLimit_bytes = std::uint64_t{4} << 30;

// Whether a recording may be called so: 1 to 100 of A-Z a-z 0-9 . _ - and no dot in front.
[[nodiscard]] bool is_recording_name(std::string_view name) noexcept;

struct RecordingLimits {
  std::uint64_t file_bytes = kRecordingLimit_bytes;
  std::size_t files = 1000;                                // in the folder
  std::uint64_t reserve_bytes = std::uint64_t{256} << 20;  // of its disk, left free
};

// What is asked of the disk; another one stands in for it in tests.
struct RecordingDisk {
  // A new file, open for writing; negative: errno says why there is none.
  std::function<int(int folder, const char* name)> create;
  std::function<std::uint64_t(int folder)> free_bytes;

  static RecordingDisk real();
};

// Writes in the caller's thread, a chunk at a time: every call takes as long as the disk does.
class RecordingFolder {
 public:
  // `folder`: exists; it is opened here, and files are made beneath it only. Throws std::runtime_error when
  // it cannot be opened.
  explicit RecordingFolder(std::filesystem::path folder, RecordingLimits limits = {},
                           RecordingDisk disk = RecordingDisk::real());
  RecordingFolder(const RecordingFolder&) = delete;
  RecordingFolder& operator=(const RecordingFolder&) = delete;
  ~RecordingFolder();  // ends the recording

  // Makes <name>.mcap and gives its path. Throws std::runtime_error, for people, when a recording is under
  // way, the name is not plain or taken, a limit is reached, or the file cannot be made: nothing is
  // overwritten.
  std::string start(std::string_view name);
  // Ends the recording: path of the finished file. Throws std::runtime_error when none is under way or its
  // end could not be written (none is then under way, either).
  std::string stop();
  [[nodiscard]] bool recording() const noexcept { return writer_ != nullptr; }
  // The folder's recordings, also of others: at most so many, the newest. Opens nothing.
  [[nodiscard]] RecordingList list(std::size_t most) const;

  // One encoded message. Log and publish time are the robot's clock. These three do nothing unless a
  // recording is under way.
  void write(Topic topic, std::string_view data, std::int64_t robot_ns);
  // Writes what waits.
  void flush();
  void end(std::string_view reason);
  // Why the recording has ended by itself, for people: the disk is full, say, or the file is as large as it
  // may be.
  [[nodiscard]] std::optional<std::string> take_report();

 private:
  [[nodiscard]] std::string path() const;
  [[nodiscard]] const char* next_name() const;
  [[nodiscard]] bool is_full() const;
  [[nodiscard]] std::optional<std::string> lack_of_room() const;
  void end_without_room();

  struct CloseFolder {
    void operator()(DIR* folder) const noexcept { ::closedir(folder); }
  };

  std::filesystem::path folder_;
  std::unique_ptr<DIR, CloseFolder> opened_;
  RecordingLimits limits_;
  RecordingDisk disk_;
  std::unique_ptr<McapWriter> writer_;  // while recording
  std::string file_name_;
  std::optional<std::string> report_;
};

}  // namespace gaitway::api

// Writes MCAP files (mcap.dev/spec, version 0), which Foxglove, PlotJuggler and the MCAP libraries open:
// chunks without compression, message and chunk indexes, statistics, CRCs. No network, no clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::api {

struct McapChannel {
  std::string topic;
  std::string type;    // e.g. "sensor_msgs/msg/JointState"
  std::string schema;  // its definition, with those of all that it contains
  bool latched = false;
};

struct McapSettings {
  std::string profile = "ros2", message_encoding = "cdr", schema_encoding = "ros2msg";
  std::uint64_t chunk_bytes = 1 << 20;  // a chunk is written when it has become this large
};

// A file that is written from front to back. What a killed writer leaves behind is readable up to its last
// chunk. After a failure nothing more is written, and the file ends with its last whole chunk and, if it can
// be written, its summary. Never throws after construction.
class McapWriter {
 public:
  // Takes over `file`, an empty one open for writing, and closes it. Writes schemas and channels at once; a
  // message's channel is its place in `channels`.
  McapWriter(int file, std::vector<McapChannel> channels, McapSettings settings = {});
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;
  // Leaves the file as it is after the last flush().
  ~McapWriter();

  // Returns whether all is well so far. `data`: one encoded message.
  bool write(std::size_t channel, std::string_view data, std::int64_t log_ns, std::int64_t publish_ns);
  // Writes what waits as a chunk.
  bool flush();
  // Writes what waits, the summary and the footer, and closes the file.
  bool finish();

  // What the system said when writing failed; empty: all is well.
  [[nodiscard]] const std::string& error() const noexcept { return error_; }
  // What the file would measure if it was finished now.
  [[nodiscard]] std::uint64_t size_bytes() const noexcept;
  [[nodiscard]] std::uint64_t messages() const noexcept { return messages_; }
  [[nodiscard]] bool waits() const noexcept { return !chunk_.records.empty(); }

 private:
  struct IndexEntry {
    std::uint64_t log_ns = 0, offset = 0;
  };
  struct Chunk {
    std::string records;
    std::vector<std::vector<IndexEntry>> index;  // [channel]
    std::uint64_t begin_ns = 0, end_ns = 0;
  };
  struct ChunkIndex {
    std::uint64_t begin_ns = 0, end_ns = 0, offset = 0, length = 0, index_length = 0, size = 0;
    std::map<std::uint16_t, std::uint64_t> message_index_offsets;
  };

  void append_channels(std::string& out) const;
  void append_schemas(std::string& out) const;
  void append_chunk_indexes(std::string& out) const;
  void append_statistics(std::string& out) const;
  [[nodiscard]] std::string chunk_record() const;
  [[nodiscard]] std::string message_indexes(ChunkIndex& index) const;
  [[nodiscard]] std::string ending() const;
  // All of it, or none: what was written of it is cut off again.
  bool put(std::string_view bytes);
  void fail(int error_number);
  void close_file();

  int file_;
  std::vector<McapChannel> channels_;
  std::vector<std::uint16_t> schema_ids_;  // [channel]
  McapSettings settings_;
  Chunk chunk_;
  std::vector<ChunkIndex> chunks_;
  std::vector<std::uint64_t> counts_;  // [channel]
  std::uint64_t messages_ = 0, begin_ns_ = 0, end_ns_ = 0;
  std::uint64_t written_bytes_ = 0;
  std::uint32_t crc_ = 0;  // of all that was written
  std::string error_;
  bool damaged_ = false;  // something incomplete stands at the file's end
};

}  // namespace gaitway::api

// The file's order: magic, header, schemas, channels, {chunk, its message indexes}…, data end, summary
// (schemas, channels, statistics, chunk indexes), summary offsets, footer, magic.
#include "gaitway/api/mcap_writer.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <set>
#include <span>
#include <utility>

#include "gaitway/process/crc32.hpp"
#include "mcap_record.hpp"

namespace gaitway::api {
namespace {

using mcap::append_number;
using mcap::append_record;
using mcap::append_text;
using mcap::Opcode;

constexpr std::string_view kLibrary = "gaitway";

std::uint32_t crc_of(std::string_view bytes, std::uint32_t before = 0) noexcept {
  return process::crc32(std::as_bytes(std::span(bytes)), before);
}

std::uint16_t id_of(std::size_t channel) noexcept {
  return static_cast<std::uint16_t>(channel);
}

void append_map_entry(std::string& out, std::string_view key, std::string_view value) {
  append_text(out, key);
  append_text(out, value);
}

// As rosbag2 writes it, with every field, since readers want all; times without a limit are infinite. 1:
// reliable, automatic; 1 and 2: transient local and volatile.
std::string quality_of_service(bool latched) {
  constexpr std::string_view kInfinite = "{sec: 9223372036, nsec: 854775807}";
  std::string text = "- history: 1\n";
  text += latched ? "  depth: 1\n" : "  depth: 10\n";
  text += "  reliability: 1\n";
  text += latched ? "  durability: 1\n" : "  durability: 2\n";
  for (const std::string_view limit : {"deadline", "lifespan"}) {
    text.append("  ").append(limit).append(": ").append(kInfinite).append("\n");
  }
  text += "  liveliness: 1\n";
  text.append("  liveliness_lease_duration: ").append(kInfinite).append("\n");
  return text + "  avoid_ros_namespace_conventions: false\n";
}

}  // namespace

McapWriter::McapWriter(int file, std::vector<McapChannel> channels, McapSettings settings)
    : file_(file), channels_(std::move(channels)), settings_(std::move(settings)) {
  for (const McapChannel& channel : channels_) {
    const auto first = std::ranges::find(channels_, channel.type, &McapChannel::type);
    // Schemas are counted from 1, and bear the number of the first channel with that type.
    schema_ids_.push_back(static_cast<std::uint16_t>(first - channels_.begin() + 1));
  }
  chunk_.index.resize(channels_.size());
  counts_.resize(channels_.size());
  std::string beginning{mcap::kMagic};
  std::string content;
  append_text(content, settings_.profile);
  append_text(content, kLibrary);
  append_record(beginning, Opcode::header, content);
  append_schemas(beginning);
  append_channels(beginning);
  put(beginning);
}

McapWriter::~McapWriter() {
  close_file();
}

void McapWriter::append_schemas(std::string& out) const {
  std::string content;
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
    if (schema_ids_[channel] != channel + 1) continue;
    content.clear();
    append_number(content, schema_ids_[channel]);
    append_text(content, channels_[channel].type);
    append_text(content, settings_.schema_encoding);
    append_text(content, channels_[channel].schema);
    append_record(out, Opcode::schema, content);
  }
}

void McapWriter::append_channels(std::string& out) const {
  std::string content, metadata;
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
    content.clear();
    metadata.clear();
    append_map_entry(metadata, "offered_qos_profiles", quality_of_service(channels_[channel].latched));
    append_number(content, id_of(channel));
    append_number(content, schema_ids_[channel]);
    append_text(content, channels_[channel].topic);
    append_text(content, settings_.message_encoding);
    append_text(content, metadata);
    append_record(out, Opcode::channel, content);
  }
}

bool McapWriter::write(std::size_t channel, std::string_view data, std::int64_t log_ns,
                       std::int64_t publish_ns) {
  if (file_ < 0 || !error_.empty()) return false;
  const auto time_ns = static_cast<std::uint64_t>(std::max<std::int64_t>(log_ns, 0));
  const bool first = chunk_.records.empty();
  chunk_.begin_ns = first ? time_ns : std::min(chunk_.begin_ns, time_ns);
  chunk_.end_ns = first ? time_ns : std::max(chunk_.end_ns, time_ns);
  begin_ns_ = messages_ == 0 ? time_ns : std::min(begin_ns_, time_ns);
  end_ns_ = std::max(end_ns_, time_ns);
  chunk_.index[channel].push_back({time_ns, chunk_.records.size()});

  mcap::append_record_header(chunk_.records, Opcode::message, 2 + 4 + 8 + 8 + data.size());
  append_number(chunk_.records, id_of(channel));
  append_number(chunk_.records, static_cast<std::uint32_t>(counts_[channel]));
  append_number(chunk_.records, time_ns);
  append_number(chunk_.records, static_cast<std::uint64_t>(std::max<std::int64_t>(publish_ns, 0)));
  chunk_.records.append(data);
  ++counts_[channel];
  ++messages_;
  return chunk_.records.size() < settings_.chunk_bytes || flush();
}

std::string McapWriter::chunk_record() const {
  std::string head;
  append_number(head, chunk_.begin_ns);
  append_number(head, chunk_.end_ns);
  append_number(head, std::uint64_t{chunk_.records.size()});
  append_number(head, crc_of(chunk_.records));
  append_text(head, "");  // compression
  append_number(head, std::uint64_t{chunk_.records.size()});
  std::string record;
  record.reserve(mcap::kRecordHeaderBytes + head.size() + chunk_.records.size());
  mcap::append_record_header(record, Opcode::chunk, head.size() + chunk_.records.size());
  record.append(head);
  record.append(chunk_.records);
  return record;
}

std::string McapWriter::message_indexes(ChunkIndex& index) const {
  std::string records, content;
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
    const std::vector<IndexEntry>& entries = chunk_.index[channel];
    if (entries.empty()) continue;
    index.message_index_offsets[id_of(channel)] = index.offset + index.length + records.size();
    content.clear();
    append_number(content, id_of(channel));
    append_number(content, static_cast<std::uint32_t>(entries.size() * 16));
    for (const IndexEntry& entry : entries) {
      append_number(content, entry.log_ns);
      append_number(content, entry.offset);
    }
    append_record(records, Opcode::message_index, content);
  }
  return records;
}

bool McapWriter::flush() {
  if (file_ < 0 || !error_.empty()) return false;
  if (chunk_.records.empty()) return true;
  ChunkIndex index;
  index.begin_ns = chunk_.begin_ns;
  index.end_ns = chunk_.end_ns;
  index.offset = written_bytes_;
  std::string bytes = chunk_record();
  index.length = bytes.size();
  index.size = chunk_.records.size();
  const std::string indexes = message_indexes(index);
  index.index_length = indexes.size();
  bytes.append(indexes);
  const bool well = put(bytes);
  if (well) {
    chunks_.push_back(std::move(index));
  } else {  // these messages are lost
    for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
      counts_[channel] -= chunk_.index[channel].size();
      messages_ -= chunk_.index[channel].size();
    }
  }
  chunk_.records.clear();
  for (std::vector<IndexEntry>& entries : chunk_.index) entries.clear();
  return well;
}

void McapWriter::append_statistics(std::string& out) const {
  std::string content;
  append_number(content, messages_);
  const std::set<std::uint16_t> schemas(schema_ids_.begin(), schema_ids_.end());
  append_number(content, static_cast<std::uint16_t>(schemas.size()));
  append_number(content, static_cast<std::uint32_t>(channels_.size()));
  append_number(content, std::uint32_t{0});  // attachments
  append_number(content, std::uint32_t{0});  // metadata
  append_number(content, static_cast<std::uint32_t>(chunks_.size()));
  append_number(content, begin_ns_);
  append_number(content, end_ns_);
  std::string counts;
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
    append_number(counts, id_of(channel));
    append_number(counts, counts_[channel]);
  }
  append_text(content, counts);
  append_record(out, Opcode::statistics, content);
}

void McapWriter::append_chunk_indexes(std::string& out) const {
  std::string content, offsets;
  for (const ChunkIndex& chunk : chunks_) {
    content.clear();
    offsets.clear();
    for (const auto& [channel, offset] : chunk.message_index_offsets) {
      append_number(offsets, channel);
      append_number(offsets, offset);
    }
    append_number(content, chunk.begin_ns);
    append_number(content, chunk.end_ns);
    append_number(content, chunk.offset);
    append_number(content, chunk.length);
    append_text(content, offsets);
    append_number(content, chunk.index_length);
    append_text(content, "");  // compression
    append_number(content, chunk.size);
    append_number(content, chunk.size);
    append_record(out, Opcode::chunk_index, content);
  }
}

std::string McapWriter::ending() const {
  std::string out, content;
  append_number(content, crc_);
  append_record(out, Opcode::data_end, content);
  const std::size_t summary = out.size();

  struct Group {
    Opcode opcode;
    void (McapWriter::*append)(std::string&) const;
  };
  constexpr std::array kGroups{Group{Opcode::schema, &McapWriter::append_schemas},
                               Group{Opcode::channel, &McapWriter::append_channels},
                               Group{Opcode::statistics, &McapWriter::append_statistics},
                               Group{Opcode::chunk_index, &McapWriter::append_chunk_indexes}};
  std::string offsets;
  for (const Group& group : kGroups) {
    const std::size_t begin = out.size();
    (this->*group.append)(out);
    if (out.size() == begin) continue;
    content.clear();
    content.push_back(static_cast<char>(group.opcode));
    append_number(content, written_bytes_ + begin);
    append_number(content, std::uint64_t{out.size() - begin});
    append_record(offsets, Opcode::summary_offset, content);
  }
  const std::uint64_t offsets_start = written_bytes_ + out.size();
  out.append(offsets);
  mcap::append_record_header(out, Opcode::footer, 8 + 8 + 4);
  append_number(out, written_bytes_ + summary);
  append_number(out, offsets_start);
  append_number(out, crc_of(std::string_view(out).substr(summary)));
  out.append(mcap::kMagic);
  return out;
}

bool McapWriter::finish() {
  if (file_ < 0) return false;
  flush();
  const bool well = error_.empty();
  if (!damaged_) put(ending());  // after a failure, too: cutting off what was not whole may have made room
  close_file();
  return well && error_.empty();
}

std::uint64_t McapWriter::size_bytes() const noexcept {
  constexpr std::uint64_t kChunk = 128, kEntry = 16, kIndexOfChannel = 32;  // at most, with what refers to it
  std::uint64_t description = 0;
  for (const McapChannel& channel : channels_) {
    description += 256 + channel.topic.size() + channel.type.size() + channel.schema.size();
  }
  const std::uint64_t chunks = chunks_.size() + 1;
  std::uint64_t waiting = chunk_.records.size() + channels_.size() * kIndexOfChannel;
  for (const std::vector<IndexEntry>& entries : chunk_.index) waiting += entries.size() * kEntry;
  return written_bytes_ + waiting + description + chunks * (kChunk + channels_.size() * 10) + 256;
}

bool McapWriter::put(std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      fail(count < 0 ? errno : EIO);
      return false;
    }
    done += static_cast<std::size_t>(count);
  }
  written_bytes_ += bytes.size();
  crc_ = crc_of(bytes, crc_);
  return true;
}

void McapWriter::fail(int error_number) {
  const auto end = static_cast<off_t>(written_bytes_);
  damaged_ = ::ftruncate(file_, end) != 0 || ::lseek(file_, end, SEEK_SET) != end;
  if (error_.empty()) error_ = std::strerror(error_number);
}

void McapWriter::close_file() {
  if (file_ < 0) return;
  if (::close(file_) != 0 && error_.empty()) {
    error_ = std::strerror(errno);
  }
  file_ = -1;
}

}  // namespace gaitway::api

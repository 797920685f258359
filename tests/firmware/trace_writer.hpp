// Writes traces, and plays them on this machine.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/firmware/trace_replay.hpp"

namespace gaitway::firmware {

// A file's place in memory: source and sink of the replay.
class ByteSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool read(std::uint8_t* into, std::size_t size) {
    if (size > bytes_.size()) {
      return false;
    }
    std::copy_n(bytes_.begin(), size, into);
    bytes_ = bytes_.subspan(size);
    return true;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
};

struct ByteSink {
  void write(const std::uint8_t* from, std::size_t size) { bytes.insert(bytes.end(), from, from + size); }
  std::vector<std::uint8_t> bytes;
};

class TraceWriter {
 public:
  void joint(int index, localcontroller::JointConfig config) {
    begin(TraceRecord::joint, index);
    trace_fields(put_, config);
  }
  // The joints with these indices receive the frame, each at its own time.
  void frame(can::Frame frame) {
    put_(static_cast<std::uint8_t>(TraceRecord::frame));
    trace_fields(put_, frame);
  }
  void received(int index, std::int64_t time_ns) {
    begin(TraceRecord::received, index);
    put_(time_ns);
  }
  void step(int index, std::int64_t time_ns, localcontroller::JointSensors sensors) {
    begin(TraceRecord::step, index);
    put_(time_ns);
    trace_fields(put_, sensors);
  }
  void take(int index) { begin(TraceRecord::take, index); }
  void reset(int index) { begin(TraceRecord::reset, index); }
  // The finished trace.
  [[nodiscard]] std::vector<std::uint8_t> finish() {
    put_(static_cast<std::uint8_t>(TraceRecord::end));
    return std::move(sink_.bytes);
  }

 private:
  void begin(TraceRecord kind, int index) {
    put_(static_cast<std::uint8_t>(kind));
    put_(static_cast<std::uint8_t>(index));
  }
  ByteSink sink_;
  FieldPut<ByteSink> put_{sink_};
};

struct Played {
  ReplayResult result{};
  std::vector<std::uint8_t> output;
};

[[nodiscard]] inline Played play_here(std::span<const std::uint8_t> trace) {
  ByteSource source(trace);
  ByteSink sink;
  NoMeter meter;
  TraceReplay replay;
  const ReplayResult result = replay.run(source, sink, meter);
  return {result, std::move(sink.bytes)};
}

}  // namespace gaitway::firmware

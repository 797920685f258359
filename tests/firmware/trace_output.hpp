// What a played trace answered, record by record.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "trace_writer.hpp"

namespace gaitway::firmware {

struct Answer {
  TraceRecord kind{};
  int joint = 0;
  std::size_t begin = 0, end = 0;                               // its bytes in the output
  localcontroller::JointConfig config;                          // joint
  double torque_Nm = 0.0, reference_rad = 0.0, trim_rad = 0.0;  // step
  can::JointState state{};                                      // received, step, reset
  std::optional<can::Frame> frame;                              // take
};

// Empty when the output is not that of the trace.
class AnswerReader {
 public:
  AnswerReader(std::span<const std::uint8_t> trace, std::span<const std::uint8_t> output)
      : trace_(trace), output_(output), output_size_(output.size()) {}

  std::optional<Answer> next() {
    const auto kind = static_cast<TraceRecord>(asked_.get<std::uint8_t>());
    if (!asked_.complete() || kind == TraceRecord::end) {
      return std::nullopt;
    }
    if (kind == TraceRecord::frame) {
      can::Frame frame;
      trace_fields(asked_, frame);
      return next();
    }
    Answer answer;
    answer.kind = kind;
    answer.joint = asked_.get<std::uint8_t>();
    answer.begin = output_size_ - output_.left();
    read(answer);
    answer.end = output_size_ - output_.left();
    return answered_.complete() ? std::optional(answer) : std::nullopt;
  }

 private:
  void read(Answer& answer) {
    localcontroller::JointSensors sensors;
    switch (answer.kind) {
      case TraceRecord::joint:
        trace_fields(asked_, answer.config);
        answered_.get<std::uint8_t>();
        break;
      case TraceRecord::received:
        asked_.get<std::int64_t>();
        answered_.get<std::int32_t>();
        answer.state = state();
        break;
      case TraceRecord::step:
        asked_.get<std::int64_t>();
        trace_fields(asked_, sensors);
        answered_(answer.torque_Nm);
        answered_(answer.reference_rad);
        answered_(answer.trim_rad);
        answered_.get<std::int32_t>();
        answer.state = state();
        break;
      case TraceRecord::take:
        if (answered_.get<std::uint8_t>() == 1) {
          trace_fields(answered_, answer.frame.emplace());
        }
        break;
      default:
        answer.state = state();
    }
  }
  can::JointState state() { return static_cast<can::JointState>(answered_.get<std::uint8_t>()); }

  ByteSource trace_, output_;
  std::size_t output_size_;
  FieldGet<ByteSource> asked_{trace_}, answered_{output_};
};

}  // namespace gaitway::firmware

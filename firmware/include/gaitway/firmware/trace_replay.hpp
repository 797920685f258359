// Plays a trace through joint controllers and writes all that they answer, bit for bit:
//   joint          index
//   reset          state
//   received       reference count, state
//   step           torque (N·m), reference (rad), trim (rad), reference count, state
//   take           1 and the frame, or 0
//   frame, end     nothing
// Freestanding: the same source runs on the host and on the microcontroller.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/firmware/trace.hpp"
#include "gaitway/localcontroller/joint_controller.hpp"

namespace gaitway::firmware {

enum class ReplayResult : std::uint8_t {
  complete = 0,
  truncated = 1,       // no `end` record
  unknown_record = 2,  // a kind of record that does not exist
  unknown_joint = 3    // an index without a `joint` record, or too large a one
};

// Called around each `step` and each `received`, to measure them.
struct NoMeter {
  void begin() noexcept {}
  void end(TraceRecord) noexcept {}
};

class TraceReplay {
 public:
  // `source` and `sink` as FieldGet and FieldPut want them.
  template <class Source, class Sink, class Meter>
  ReplayResult run(Source& source, Sink& sink, Meter& meter) {
    FieldGet<Source> get(source);
    FieldPut<Sink> put(sink);
    while (true) {
      const auto kind = static_cast<TraceRecord>(get.template get<std::uint8_t>());
      if (!get.complete()) {
        return ReplayResult::truncated;
      }
      if (kind == TraceRecord::end) {
        return ReplayResult::complete;
      }
      if (kind == TraceRecord::frame) {
        trace_fields(get, frame_);
        continue;
      }
      const auto index = get.template get<std::uint8_t>();
      if (kind == TraceRecord::joint) {
        if (index >= joints_.size()) {
          return ReplayResult::unknown_joint;
        }
        localcontroller::JointConfig config;
        trace_fields(get, config);
        joints_[index].emplace(config);
        put(index);
        continue;
      }
      if (index >= joints_.size() || !joints_[index]) {
        return ReplayResult::unknown_joint;
      }
      if (!play(kind, *joints_[index], get, put, meter)) {
        return ReplayResult::unknown_record;
      }
    }
  }

 private:
  template <class Get, class Put, class Meter>
  bool play(TraceRecord kind, localcontroller::JointController& joint, Get& get, Put& put, Meter& meter) {
    switch (kind) {
      case TraceRecord::received:
        receive(joint, get.template get<std::int64_t>(), meter);
        put(joint.reference_count());
        put(static_cast<std::uint8_t>(joint.state()));
        return true;
      case TraceRecord::step:
        step(joint, get, put, meter);
        return true;
      case TraceRecord::take:
        take(joint, put);
        return true;
      case TraceRecord::reset:
        joint.reset();
        put(static_cast<std::uint8_t>(joint.state()));
        return true;
      default:
        return false;
    }
  }

  template <class Meter>
  void receive(localcontroller::JointController& joint, std::int64_t now_ns, Meter& meter) {
    meter.begin();
    joint.on_frame(frame_, now_ns);
    meter.end(TraceRecord::received);
  }

  template <class Get, class Put, class Meter>
  void step(localcontroller::JointController& joint, Get& get, Put& put, Meter& meter) {
    const auto now_ns = get.template get<std::int64_t>();
    localcontroller::JointSensors sensors;
    trace_fields(get, sensors);
    meter.begin();
    const double torque_Nm = joint.step(now_ns, sensors);
    meter.end(TraceRecord::step);
    put(torque_Nm);
    put(joint.reference_rad());
    put(joint.trim_rad());
    put(joint.reference_count());
    put(static_cast<std::uint8_t>(joint.state()));
  }

  template <class Put>
  void take(localcontroller::JointController& joint, Put& put) {
    can::Frame frame;
    const bool taken = joint.take_frame(frame);
    put(static_cast<std::uint8_t>(taken ? 1 : 0));
    if (taken) {
      trace_fields(put, frame);
    }
  }

  std::array<std::optional<localcontroller::JointController>, kLargestTraceJoints> joints_;
  can::Frame frame_;
};

}  // namespace gaitway::firmware

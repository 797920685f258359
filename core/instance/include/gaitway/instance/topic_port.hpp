// A topic as one plug-in uses it: declared while the plug-in is constructed, bound to the memory block once
// the data flow was checked, read and staged in the cycle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/plugin/abi.h"

namespace gaitway::core {

// Same numbers as in the ABI.
enum class Access : std::uint32_t {
  read = GAITWAY_READ,
  read_previous = GAITWAY_READ_PREVIOUS,
  read_optional = GAITWAY_READ_OPTIONAL,
  write = GAITWAY_WRITE,
  read_previous_optional = GAITWAY_READ_PREVIOUS_OPTIONAL
};
inline constexpr std::array kAccesses{Access::read, Access::read_previous, Access::read_optional,
                                      Access::write, Access::read_previous_optional};

// Of the tick before: such a use orders nothing.
constexpr bool is_of_tick_before(Access access) noexcept {
  return access == Access::read_previous || access == Access::read_previous_optional;
}
constexpr bool needs_writer(Access access) noexcept {
  return access == Access::read || access == Access::read_previous;
}

struct TopicUse {
  Access access = Access::read;
  std::string topic;
  std::string type_name;
  std::uint64_t type_hash = 0;
  std::uint32_t size = 0;
  std::string number_fields = {};  // its floating-point fields and where they lie, for people
};

struct DataFlowNode {  // a plug-in
  std::string name;
  std::vector<TopicUse> uses;
};

// A run of floating-point numbers in a topic's value.
struct FloatField {
  std::string name;
  std::uint32_t offset = 0;  // bytes
  std::uint32_t count = 0;
  std::uint32_t bytes = 0;  // of a number: 4 or 8
  std::uint32_t rows = 1;   // first extent
  double lowest = 0.0;      // what is allowed
  double highest = 0.0;
};

// The first number that is not finite or lies beyond its field's limits.
struct BadNumber {
  const FloatField* field = nullptr;
  std::uint32_t element = 0;  // flat index into the field
  double value = 0.0;
};

class TopicPort {
 public:
  // Copies all of `topic`. Throws PluginError for an unusable description.
  TopicPort(const gaitway_topic& topic, Access access);

  // Set-up: throws msgclient::TopicError.
  void bind(msgclient::Client& client);

  // If both write the same topic and `from` has it open: takes it over. For the cycle.
  void take_output(TopicPort& from) noexcept;

  // What the ABI's read says. Of the tick before: the value that take_snapshot() took.
  gaitway_status read(void* value, gaitway_sample& sample) noexcept;
  // Before any plug-in of a tick is stepped; for what is read of the tick before.
  void take_snapshot() noexcept;

  // Keeps a copy of `value` for commit().
  gaitway_status stage(const void* value) noexcept;
  void discard() noexcept { staged_ = false; }
  // Publishes what was staged, if anything.
  void commit(std::int64_t stamp_ns) noexcept;
  // Looks through the staged value's floating-point numbers, as far as they are in use.
  [[nodiscard]] std::optional<BadNumber> find_bad_number() const noexcept;
  // For faults that are injected: `offset` onto the first number of each field of the staged value.
  void spoil_staged(double offset) noexcept;
  // Past stage() and checks: out at once. False: nobody has it open here.
  bool publish_now(const void* value, std::int64_t stamp_ns) noexcept;

  // Age of the value that was read since the last call; 0: none was, or it is of a topic that is written on
  // change only.
  std::int64_t take_read_age_ns(std::int64_t now_ns) noexcept;

  [[nodiscard]] const TopicUse& use() const noexcept { return use_; }

 private:
  [[nodiscard]] std::uint32_t elements_in_use(const FloatField& field) const noexcept;
  [[nodiscard]] double number_at(const FloatField& field, std::uint32_t element) const noexcept;

  TopicUse use_;
  std::vector<FloatField> float_fields_;
  std::optional<msgclient::UntypedReader> reader_;
  std::optional<msgclient::UntypedWriter> writer_;
  std::vector<std::byte> copy_;  // staged output, or the snapshot
  gaitway_sample snapshot_{};
  bool staged_ = false;
  bool periodic_ = true;
  std::int64_t read_stamp_ns_ = 0;  // of the value that was read; 0: none since the last look
};

}  // namespace gaitway::core

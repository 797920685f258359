// The standard topics of a short walk, tick by tick: the inputs of every check.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/msgclient/type_descriptor.hpp"
#include "gaitway/plugin/cycle.hpp"
#include "tools/check_plugin/worker_process.hpp"

namespace gaitway::plugin_check {

struct RecordedTopic {
  std::string name;
  const TypeDescriptor* type = nullptr;
  std::vector<std::uint32_t> newest_at;  // [tick]: 1 + index of the newest value; 0: none yet
  std::vector<std::int64_t> stamp_ns;    // [value]
  std::vector<std::byte> values;         // [value]: type->size bytes each

  void add(std::uint32_t tick, std::span<const std::byte> value, std::int64_t stamp);
};

// A tick of the record, which may be played again and again: `pass` counts.
struct RecordPosition {
  std::uint32_t tick = 0;
  std::uint32_t pass = 0;
};

class NominalRecord {
 public:
  NominalRecord() = default;
  explicit NominalRecord(std::uint32_t ticks) : ticks_(ticks) {}

  [[nodiscard]] std::uint32_t ticks() const noexcept { return ticks_; }
  RecordedTopic& add_topic(const std::string& name, const TypeDescriptor& type);
  [[nodiscard]] std::vector<RecordedTopic>& topics() noexcept { return topics_; }
  [[nodiscard]] const RecordedTopic* find(std::string_view name) const noexcept;

  // The n-th tick from the start, over as many passes as it takes; times and sequences grow on.
  [[nodiscard]] RecordPosition position(std::uint64_t n) const noexcept {
    return {static_cast<std::uint32_t>(n % ticks_), static_cast<std::uint32_t>(n / ticks_)};
  }
  [[nodiscard]] Tick tick(const RecordPosition& position) const noexcept;
  // Copies value number `index` with its times and sequences moved to the pass. For the cycle.
  void copy(const RecordedTopic& topic, std::uint32_t index, std::uint32_t pass,
            std::span<std::byte> to) const noexcept;
  [[nodiscard]] std::int64_t shift_ns(std::uint32_t pass) const noexcept;

  void save(int fd) const;
  static NominalRecord load(int fd);  // throws std::runtime_error

 private:
  std::uint32_t ticks_ = 0;  // a multiple of a cycle's
  std::vector<RecordedTopic> topics_;
};

// Lets the simulated robot walk for some seconds and records what the plug-ins see.
// Throws what the robot, the configuration or a plug-in of it is refused with, and std::runtime_error when
// the robot falls.
NominalRecord record_nominal_walk(const std::filesystem::path& robot, const std::filesystem::path& config,
                                  const std::vector<std::filesystem::path>& plugin_path, std::uint64_t seed);

}  // namespace gaitway::plugin_check

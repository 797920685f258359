// The host of a plug-in under check: plays a recorded walk to its inputs, with faults on demand, and keeps
// its outputs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/instance/parameter_set.hpp"
#include "gaitway/plugin/abi.h"
#include "gaitway/plugin/cycle.hpp"
#include "tools/check_plugin/nominal_record.hpp"
#include "tools/check_plugin/worker_process.hpp"

namespace gaitway::plugin_check {

// What is done to inputs on their way.
struct InputFault {
  enum class Kind : std::uint8_t { none, frozen, missing, not_a_number, joint_count };
  Kind kind = Kind::none;
  std::string topic = {};         // only this one; empty: all
  std::uint32_t joint_count = 0;  // of Kind::joint_count
};

struct Port {  // a topic as the plug-in opened it
  std::string topic;
  gaitway_access access = GAITWAY_READ;
  std::string type_name;
  std::uint64_t type_hash = 0;
  std::vector<gaitway_float_field> float_fields;  // names point into field_names
  std::vector<std::unique_ptr<std::string>> field_names;
  const TypeDescriptor* standard_type = nullptr;  // nullptr: not one of the schema's
  const RecordedTopic* recorded = nullptr;        // of inputs
  std::vector<std::byte> value;                   // of inputs the newest, of outputs the last one published
  gaitway_sample sample{};
  bool published = false;  // in the last step

  [[nodiscard]] bool is_output() const noexcept { return access == GAITWAY_WRITE; }
};

class ReplayHost {
 public:
  enum class Phase : std::uint8_t { creating, idle, stepping };

  // `record` may be nullptr: then no input has a value.
  ReplayHost(const Job& job, const NominalRecord* record);
  ReplayHost(const ReplayHost&) = delete;
  ReplayHost& operator=(const ReplayHost&) = delete;

  [[nodiscard]] const gaitway_host* table() const noexcept { return &table_; }
  void set_phase(Phase phase) noexcept { phase_ = phase; }

  // Set-up call number `call` (0 is the first) is refused.
  void refuse_call(std::uint32_t call) noexcept { refused_call_ = call; }
  [[nodiscard]] std::uint32_t calls() const noexcept { return calls_; }

  // Brings the inputs to a tick of the record. For the cycle.
  void feed(const RecordPosition& position, const InputFault& fault) noexcept;

  [[nodiscard]] std::list<Port>& ports() noexcept { return ports_; }
  [[nodiscard]] const std::list<Port>& ports() const noexcept { return ports_; }
  [[nodiscard]] core::ParameterSet& parameters() noexcept { return parameters_; }
  [[nodiscard]] Period period() const noexcept { return period_; }
  [[nodiscard]] const std::vector<std::string>& complaints() const noexcept { return complaints_; }

 private:
  template <class Function>
  static gaitway_status set_up(void* context, const gaitway_text* error, const Function& function) noexcept;
  static gaitway_status open_topic(void* context, const gaitway_topic* topic, gaitway_access access,
                                   gaitway_port** port, const gaitway_text* error) noexcept;
  static gaitway_status parameter(void* context, const gaitway_parameter* parameter, gaitway_value* value,
                                  const gaitway_text* error) noexcept;
  static gaitway_status set_period(void* context, gaitway_period period, const gaitway_text* error) noexcept;
  static const char* robot_directory(void* context) noexcept;
  static const void* get_extension(void* context, const char* name) noexcept;  // there is none
  static gaitway_status read(void* context, gaitway_port* port, void* value, gaitway_sample* sample) noexcept;
  static gaitway_status publish(void* context, gaitway_port* port, const void* value) noexcept;
  static void report(void* context, gaitway_severity severity, const char* text) noexcept;
  void add_port(const gaitway_topic& topic, gaitway_access access);
  void feed(Port& port, const RecordPosition& position, const InputFault& fault) noexcept;

  std::string robot_;
  const NominalRecord* record_;
  core::ParameterSet parameters_;
  std::list<Port> ports_;  // stable addresses: the plug-in holds them
  Period period_ = Period::tick;
  Phase phase_ = Phase::creating;
  std::uint32_t calls_ = 0;
  std::optional<std::uint32_t> refused_call_;
  std::vector<std::string> complaints_;  // about the declarations themselves
  gaitway_host table_{};
};

}  // namespace gaitway::plugin_check

// What a plug-in author writes against: one class, its setup and its tick. Everything else stays behind the C
// ABI.
//
//   class Sway final : public gaitway::Plugin {
//    public:
//     explicit Sway(gaitway::Setup& setup)
//         : amplitude_(setup.parameter("amplitude", 0.02, "m")),
//           walk_(setup.reads<gaitway::WalkCommand>("walk_command")),
//           plan_(setup.writes<gaitway::MotionPlan>("motion_plan")) {}
//     void step(const gaitway::Tick& tick) override;
//   };
//   GAITWAY_PLUGIN(Sway, "sway", "1.0.0", "Sways from foot to foot")
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/abi.h"
#include "gaitway/plugin/cycle.hpp"
#include "gaitway/plugin/detail/plugin_border.hpp"
#include "gaitway/plugin/number_parameter.hpp"
#include "gaitway/plugin/state_archive.hpp"

namespace gaitway {

// The topic or parameter that a plug-in asks for cannot be given; the message says why. Let it pass: the
// manager adds the plug-in's name and stops the start.
class SetupError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A topic that the plug-in reads. During one step its value never changes. Copied into its own storage; no
// allocation.
template <class T>
class Input {
 public:
  // The newest value (of this tick or of the tick before, as was asked for); T{} while there is none. The
  // reference stays valid; what it shows changes at the first use in the next step.
  [[nodiscard]] const T& read() noexcept {
    refresh();
    return state_->value;
  }
  // Whether there has ever been a value.
  [[nodiscard]] bool has_value() noexcept {
    refresh();
    return state_->sample.sequence != 0;
  }
  // Time since the value's stamp. Only with a value.
  [[nodiscard]] std::int64_t age_ns(std::int64_t now_ns) noexcept {
    refresh();
    return now_ns - state_->sample.stamp_ns;
  }
  // Counts the topic's values: two equal numbers mean the same value. 0: none yet.
  [[nodiscard]] std::uint64_t sequence() noexcept {
    refresh();
    return state_->sample.sequence;
  }

 private:
  friend class Setup;
  struct State {
    T value{};
    gaitway_sample sample{};
    std::uint64_t step = 0;
  };
  Input(const gaitway_host* host, gaitway_port* port, const std::uint64_t* step)
      : host_(host), port_(port), step_(step), state_(std::make_unique<State>()) {}

  void refresh() noexcept {
    if (state_->step != *step_) {
      state_->step = *step_;
      host_->read(host_->context, port_, &state_->value, &state_->sample);
    }
  }

  const gaitway_host* host_;
  gaitway_port* port_;
  const std::uint64_t* step_;  // counts the plug-in's calls
  std::unique_ptr<State> state_;
};

// A topic that the plug-in alone writes: fill value() in place, then publish(). The value keeps what was
// filled in.
template <class T>
class Output {
 public:
  [[nodiscard]] T& value() noexcept { return *value_; }
  // Goes out when step() has returned; if step() throws, nothing of it does. Throws outside of step().
  void publish() {
    if (host_->publish(host_->context, port_, value_.get()) != GAITWAY_OK) {
      throw std::logic_error("publish() is for step() only");
    }
  }

 private:
  friend class Setup;
  Output(const gaitway_host* host, gaitway_port* port)
      : host_(host), port_(port), value_(std::make_unique<T>()) {}

  const gaitway_host* host_;
  gaitway_port* port_;
  std::unique_ptr<T> value_;
};

enum class Severity : std::uint32_t { info = 0, warning = 1, error = 2 };

// Puts lines into the run's list of events. May be kept for the plug-in's life and used on any thread; no
// allocation, no lock.
class Reporter {
 public:
  void operator()(Severity severity, const char* text) const noexcept {
    host_->report(host_->context, static_cast<gaitway_severity>(severity), text);
  }

 private:
  friend class Setup;
  explicit Reporter(const gaitway_host* host) : host_(host) {}
  const gaitway_host* host_;
};

// What a number may be, and what it is for.
struct ParameterLimits {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  // One line for people. Its initialiser lets {.lowest = 0} lack nothing.
  std::string_view doc = "";  // NOLINT(readability-redundant-member-init)
};

// The value of a parameter that may change between two steps.
template <detail::ParameterValue T>
class Live {
 public:
  [[nodiscard]] T get() const noexcept { return *value_; }
  operator T() const noexcept { return *value_; }  // NOLINT(google-explicit-constructor): it is that value

 private:
  friend class Setup;
  explicit Live(const T* value) : value_(value) {}
  const T* value_;
};

// What a plug-in's constructor declares: topics, parameters, period. For the constructor only. Throws
// SetupError.
class Setup {
 public:
  Setup(const gaitway_host* host, const std::uint64_t* step, detail::LiveParameters* live)
      : host_(host), step_(step), live_(live) {}
  Setup(const Setup&) = delete;
  Setup& operator=(const Setup&) = delete;

  // The configuration's value, or `fallback`. It may carry a unit of the kind of `unit` ("0.4 s", "2 T");
  // without one it is taken in `unit`, with one of another kind, or outside of `limits`, it is refused.
  [[nodiscard]] double parameter(std::string_view name, double fallback, std::string_view unit = "1",
                                 const ParameterLimits& limits = {}) {
    return declare(name, number(fallback), unit, limits, false).number;
  }
  template <std::integral I>
  requires(!std::same_as<I, bool>) [[nodiscard]] std::int64_t
      parameter(std::string_view name, I fallback, std::string_view unit = "1",
                const ParameterLimits& limits = {}) {
    return declare(name, integer(static_cast<std::int64_t>(fallback)), unit, limits, false).integer;
  }
  template <std::same_as<bool> B>
  [[nodiscard]] bool parameter(std::string_view name, B fallback, std::string_view doc = "") {
    return declare(name, flag(fallback), "", {.doc = doc}, false).integer != 0;
  }
  [[nodiscard]] std::string parameter(std::string_view name, const std::string& fallback,
                                      std::string_view doc = "") {
    const gaitway_value value{GAITWAY_TEXT, 0, 0.0, 0, fallback.c_str()};
    return declare(name, value, "", {.doc = doc}, false).text;
  }
  [[nodiscard]] std::string parameter(std::string_view name, const char* fallback,
                                      std::string_view doc = "") {
    return parameter(name, std::string(fallback), doc);
  }
  // Each as parameter() has it, the number itself being the fallback. A live one is written to where it is
  // kept, between two steps: that must last as long as the plug-in.
  void parameters(std::span<const NumberParameter> numbers) {
    for (const NumberParameter& kept : numbers) {
      const ParameterLimits limits{kept.lowest, kept.highest, kept.doc};
      kept.value = declare(kept.name, number(kept.value), kept.unit, limits, kept.live).number;
      if (kept.live) live_->refer(kept.name, kept.value);
    }
  }
  // A parameter that may be changed while the robot walks, between two steps.
  [[nodiscard]] Live<double> live_parameter(std::string_view name, double fallback,
                                            std::string_view unit = "1", const ParameterLimits& limits = {}) {
    return live<double>(name, number(fallback), unit, limits);
  }
  template <std::integral I>
  requires(!std::same_as<I, bool>)
      [[nodiscard]] Live<std::int64_t> live_parameter(std::string_view name, I fallback,
                                                      std::string_view unit = "1",
                                                      const ParameterLimits& limits = {}) {
    return live<std::int64_t>(name, integer(static_cast<std::int64_t>(fallback)), unit, limits);
  }
  template <std::same_as<bool> B>
  [[nodiscard]] Live<bool> live_parameter(std::string_view name, B fallback, std::string_view doc = "") {
    return live<bool>(name, flag(fallback), "", {.doc = doc});
  }

  // How often step() is called. Default: every tick.
  void period(Period period) {
    check([&](const gaitway_text* error) {
      return host_->set_period(host_->context, static_cast<gaitway_period>(period), error);
    });
  }

  // Value of this tick: orders this plug-in after the topic's writer, which must exist.
  template <class T>
  [[nodiscard]] Input<T> reads(std::string_view topic) {
    return Input<T>(host_, open<T>(topic, GAITWAY_READ), step_);
  }
  // Value of the tick before: no ordering, breaks a cycle.
  template <class T>
  [[nodiscard]] Input<T> reads_previous(std::string_view topic) {
    return Input<T>(host_, open<T>(topic, GAITWAY_READ_PREVIOUS), step_);
  }
  // Like reads_previous; a missing writer is no error.
  template <class T>
  [[nodiscard]] Input<T> reads_previous_optional(std::string_view topic) {
    return Input<T>(host_, open<T>(topic, GAITWAY_READ_PREVIOUS_OPTIONAL), step_);
  }
  // Like reads; a missing writer is no error.
  template <class T>
  [[nodiscard]] Input<T> reads_optional(std::string_view topic) {
    return Input<T>(host_, open<T>(topic, GAITWAY_READ_OPTIONAL), step_);
  }
  // The topic's only writer.
  template <class T>
  [[nodiscard]] Output<T> writes(std::string_view topic) {
    return Output<T>(host_, open<T>(topic, GAITWAY_WRITE));
  }

  // load_robot() of it gives the RobotModel.
  [[nodiscard]] std::filesystem::path robot_directory() const {
    return host_->robot_directory(host_->context);
  }
  // Where the memory block's server takes clients; empty: nowhere. For a plug-in that works beside the steps,
  // as a client of its own: msgclient::Client::connect().
  [[nodiscard]] std::filesystem::path memory_socket() const {
    const gaitway_network* const network = network_functions();
    return network == nullptr ? "" : network->memory_socket(host_->context);
  }
  [[nodiscard]] Reporter reporter() const noexcept { return Reporter(host_); }

 private:
  [[nodiscard]] const gaitway_network* network_functions() const noexcept {
    return static_cast<const gaitway_network*>(
        host_->get_extension(host_->context, GAITWAY_NETWORK_EXTENSION));
  }
  template <class Call>
  static void check(const Call& call) {
    detail::ErrorBuffer buffer;
    const gaitway_text text = buffer.text();
    if (call(&text) != GAITWAY_OK) {
      throw SetupError(buffer.message());
    }
  }
  template <class T>
  gaitway_port* open(std::string_view topic, gaitway_access access) {
    static_assert(std::is_trivially_copyable_v<T>);
    using Type = TopicType<T>;
    const std::string name(topic), type_name(Type::name);
    const detail::FloatFields fields(Type::fields);
    const gaitway_topic wanted{.name = name.c_str(),
                               .type_name = type_name.c_str(),
                               .type_hash = Type::hash,
                               .size = sizeof(T),
                               .float_field_count = fields.count(),
                               .float_fields = fields.data()};
    gaitway_port* port = nullptr;
    check([&](const gaitway_text* error) {
      return host_->open_topic(host_->context, &wanted, access, &port, error);
    });
    return port;
  }

  static gaitway_value number(double value) noexcept { return {GAITWAY_NUMBER, 0, value, 0, nullptr}; }
  static gaitway_value integer(std::int64_t value) noexcept {
    return {GAITWAY_INTEGER, 0, 0.0, value, nullptr};
  }
  static gaitway_value flag(bool value) noexcept { return {GAITWAY_FLAG, 0, 0.0, value ? 1 : 0, nullptr}; }
  gaitway_value declare(std::string_view name, const gaitway_value& fallback, std::string_view unit,
                        const ParameterLimits& limits, bool live) {
    const std::string name_text(name), unit_text(unit), doc_text(limits.doc);
    const gaitway_parameter wanted{.name = name_text.c_str(),
                                   .unit = unit_text.c_str(),
                                   .doc = doc_text.c_str(),
                                   .fallback = fallback,
                                   .lowest = limits.lowest,
                                   .highest = limits.highest,
                                   .live = live ? 1U : 0U,
                                   .reserved = 0};
    gaitway_value value{};
    check(
        [&](const gaitway_text* error) { return host_->parameter(host_->context, &wanted, &value, error); });
    return value;
  }
  template <detail::ParameterValue T>
  Live<T> live(std::string_view name, const gaitway_value& fallback, std::string_view unit,
               const ParameterLimits& limits) {
    const gaitway_value value = declare(name, fallback, unit, limits, true);
    return Live<T>(live_->add<T>(name, detail::value_as<T>(value)));
  }

  const gaitway_host* host_;
  const std::uint64_t* step_;
  detail::LiveParameters* live_;
};

// A plug-in. Its constructor takes Setup&, may allocate and may throw. All calls come from one thread at a
// time.
class Plugin {
 public:
  Plugin() = default;
  Plugin(const Plugin&) = delete;
  Plugin& operator=(const Plugin&) = delete;
  virtual ~Plugin() = default;

  // Before the first step; may allocate and throw. Inputs of topics from outside may have values already.
  virtual void activate() {}
  // Once a tick or a batch. No allocation, no lock, no system call. A throw is caught at the border: nothing
  // of this step is published, and the fault is counted and reported.
  virtual void step(const Tick& tick) = 0;
  virtual void deactivate() {}

  // What the next version of this plug-in is to go on from when it is put in this one's place while the robot
  // walks: the new one is constructed and activated beside the ticks, then restored and stepped. Another
  // version number or another size is refused, and then this one stays. 0: nothing is handed on. No
  // allocation.
  [[nodiscard]] virtual std::uint32_t state_version() const { return 0; }
  virtual void save_state(StateWriter&) const {}
  virtual void restore_state(StateReader&) {}
};

}  // namespace gaitway

// Makes `Class` the plug-in of this library. Once a library, at global scope.
#define GAITWAY_PLUGIN(Class, plugin_name, plugin_version, plugin_description) \
  extern "C" const gaitway_plugin gaitway_plugin_entry = {                     \
      GAITWAY_PLUGIN_HEAD, plugin_name, plugin_version, plugin_description,    \
      &::gaitway::detail::PluginBorder<Class, ::gaitway::Plugin, ::gaitway::Setup>::create};

// Turns a C++ plug-in class into the C function table: every exception ends here. Not for direct use.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "gaitway/msgclient/type_descriptor.hpp"
#include "gaitway/plugin/abi.h"
#include "gaitway/plugin/cycle.hpp"
#include "gaitway/plugin/state_archive.hpp"

namespace gaitway::detail {

inline void write_text(const gaitway_text* to, const char* text) noexcept {
  if (to == nullptr || to->data == nullptr || to->capacity == 0) {
    return;
  }
  const std::size_t length = strnlen(text, to->capacity - 1);
  std::memcpy(to->data, text, length);
  to->data[length] = '\0';
}

// Nullptr: the plug-in hands no state on.
[[nodiscard]] inline const gaitway_state_functions* state_functions(
    const gaitway_instance& instance) noexcept {
  return instance.get_extension == nullptr
             ? nullptr
             : static_cast<const gaitway_state_functions*>(
                   instance.get_extension(instance.context, GAITWAY_STATE_EXTENSION));
}

class ErrorBuffer {
 public:
  [[nodiscard]] gaitway_text text() noexcept {
    return {bytes_.data(), static_cast<std::uint32_t>(bytes_.size()), 0};
  }
  [[nodiscard]] const char* message() const noexcept { return bytes_.data(); }
  [[nodiscard]] bool empty() const noexcept { return bytes_[0] == '\0'; }
  void clear() noexcept { bytes_[0] = '\0'; }

 private:
  std::array<char, 1024> bytes_{};
};

// The floating-point fields of a topic's type, as the ABI wants them.
class FloatFields {
 public:
  explicit FloatFields(std::span<const FieldDescriptor> fields) {
    names_.reserve(fields.size());
    for (const FieldDescriptor& field : fields) {
      if (field.type != ScalarType::float32_value && field.type != ScalarType::float64_value) {
        continue;
      }
      names_.emplace_back(field.name);
      fields_.push_back({.name = names_.back().c_str(),
                         .offset = field.offset,
                         .count = field.elements(),
                         .bytes = scalar_size(field.type),
                         .rows = field.rank > 0 ? field.extents[0] : 1,
                         .lowest = field.lowest,
                         .highest = field.highest});
    }
  }
  [[nodiscard]] std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(fields_.size()); }
  [[nodiscard]] const gaitway_float_field* data() const noexcept { return fields_.data(); }

 private:
  std::vector<std::string> names_;
  std::vector<gaitway_float_field> fields_;
};

// The parameters that may change between two steps: where each one's value lies.
template <class T>
concept ParameterValue = std::same_as<T, double> || std::same_as<T, std::int64_t> || std::same_as<T, bool>;

template <ParameterValue T>
[[nodiscard]] T value_as(const gaitway_value& value) noexcept {
  if constexpr (std::same_as<T, double>) {
    return value.number;
  } else {
    return static_cast<T>(value.integer);
  }
}

class LiveParameters {
 public:
  template <ParameterValue T>
  T* add(std::string_view name, T value) {
    entries_.push_back({std::string(name), std::make_unique<T>(value)});
    return std::get<std::unique_ptr<T>>(entries_.back().value).get();
  }
  // A number that the plug-in keeps itself.
  void refer(std::string_view name, double& value) { entries_.push_back({std::string(name), &value}); }
  // False: there is no such parameter.
  bool set(std::string_view name, const gaitway_value& value) noexcept {
    bool found = false;
    for (Entry& entry : entries_) {
      if (entry.name == name) {
        found = true;
        std::visit([&value](auto& cell) { assign(*cell, value); }, entry.value);
      }
    }
    return found;
  }

 private:
  template <ParameterValue T>
  static void assign(T& cell, const gaitway_value& value) noexcept {
    cell = value_as<T>(value);
  }
  struct Entry {
    std::string name;
    std::variant<double*, std::unique_ptr<double>, std::unique_ptr<std::int64_t>, std::unique_ptr<bool>>
        value;
  };
  std::vector<Entry> entries_;
};

template <class Class, class Base, class SetupType>
class PluginBorder {
  static_assert(std::is_base_of_v<Base, Class>, "a plug-in derives publicly from gaitway::Plugin");
  static_assert(std::is_constructible_v<Class, SetupType&>,
                "a plug-in's constructor takes a gaitway::Setup&");

 public:
  static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                               const gaitway_text* error) noexcept {
    return guarded(error, [&] {
      auto border = std::make_unique<PluginBorder>();
      SetupType setup(host, &border->calls_, &border->live_);
      border->plugin_ = std::make_unique<Class>(setup);
      *instance = {border.release(), &activate, &step, &deactivate, &destroy, &set_parameter, &get_extension};
    });
  }

 private:
  static gaitway_status activate(void* context, const gaitway_text* error) noexcept {
    return call(context, error, [](Base& plugin) { plugin.activate(); });
  }
  static gaitway_status step(void* context, const gaitway_tick* tick, const gaitway_text* error) noexcept {
    return call(context, error, [tick](Base& plugin) {
      plugin.step(Tick{.now_ns = tick->now_ns,
                       .batch_start_ns = tick->batch_start_ns,
                       .batch_sequence = tick->batch_sequence,
                       .tick = tick->tick,
                       .batch = tick->batch != 0});
    });
  }
  static gaitway_status deactivate(void* context, const gaitway_text* error) noexcept {
    return call(context, error, [](Base& plugin) { plugin.deactivate(); });
  }
  static void destroy(void* context) noexcept { delete static_cast<PluginBorder*>(context); }

  static gaitway_status set_parameter(void* context, const char* name, const gaitway_value* value,
                                      const gaitway_text* error) noexcept {
    if (static_cast<PluginBorder*>(context)->live_.set(name, *value)) {
      return GAITWAY_OK;
    }
    write_text(error, "this parameter does not change while the plug-in runs");
    return GAITWAY_FAILED;
  }
  static const void* get_extension(void* /*context*/, const char* name) noexcept {
    static constexpr gaitway_state_functions kState{&save_state, &restore_state};
    return std::strcmp(name, GAITWAY_STATE_EXTENSION) == 0 ? &kState : nullptr;
  }
  static gaitway_status save_state(void* context, gaitway_state* state, const gaitway_text* error) noexcept {
    return guarded(error, [&] {
      const Base& plugin = *static_cast<PluginBorder*>(context)->plugin_;
      StateWriter writer({static_cast<std::byte*>(state->data), state->capacity});
      state->version = plugin.state_version();
      plugin.save_state(writer);
      state->size = static_cast<std::uint32_t>(writer.size());
    });
  }
  static gaitway_status restore_state(void* context, const gaitway_state* state,
                                      const gaitway_text* error) noexcept {
    return guarded(error, [&] {
      Base& plugin = *static_cast<PluginBorder*>(context)->plugin_;
      if (plugin.state_version() != state->version) {
        throw StateError("takes over state of version " + std::to_string(plugin.state_version()) +
                         ", but was handed version " + std::to_string(state->version));
      }
      StateReader reader({static_cast<const std::byte*>(state->data), state->size});
      plugin.restore_state(reader);
      if (reader.remaining() != 0) {
        throw StateError("takes over all but " + std::to_string(reader.remaining()) + " of " +
                         std::to_string(state->size) + " bytes of the state that was handed on");
      }
    });
  }

  template <class Function>
  static gaitway_status call(void* context, const gaitway_text* error, const Function& function) noexcept {
    auto& border = *static_cast<PluginBorder*>(context);
    ++border.calls_;
    return guarded(error, [&] { function(*border.plugin_); });
  }
  template <class Function>
  static gaitway_status guarded(const gaitway_text* error, const Function& function) noexcept {
    try {
      function();
      return GAITWAY_OK;
    } catch (const std::exception& problem) {
      write_text(error, problem.what());
    } catch (...) {
      write_text(error, "threw something that is no std::exception");
    }
    return GAITWAY_FAILED;
  }

  std::uint64_t calls_ = 0;  // by which inputs know that a new step has begun
  LiveParameters live_;
  std::unique_ptr<Class> plugin_;
};

}  // namespace gaitway::detail

// The parameters of a C++ plug-in that may change between two steps: where each one's value lies. Not for
// direct use.
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gaitway/plugin/abi.h"

namespace gaitway::detail {

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

}  // namespace gaitway::detail

// A plug-in's state as bytes, on its way from one version of the plug-in to the next.
//
//   void save_state(gaitway::StateWriter& state) const override { state(phase_, amplitude_); }
//   void restore_state(gaitway::StateReader& state) override { state(phase_, amplitude_); }
//
// Takes numbers, enums, plain structs without pointers, fixed arrays (std::array, Eigen vectors and matrices
// of fixed size), std::optional, and classes with
//   template <class Self, class Archive> static void visit_state(Self& self, Archive& archive) {
//     archive(self.a_, self.b_);
//   }
#pragma once

#include <concepts>
#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace gaitway {

// The bytes do not fit: another version, another layout, or no room.
class StateError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

namespace detail {

template <class T>
concept Plain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;
template <class T, class Archive>
concept Visited = requires(T value, Archive archive) {
  T::visit_state(value, archive);
};
template <class T>
concept Optional = requires(T value) {
  value.has_value();
  *value;
};
template <class T>
concept Elements = !Optional<T> && requires(T value) {
  { value.size() } -> std::convertible_to<std::size_t>;
  *value.data();
};

}  // namespace detail

class StateWriter {
 public:
  explicit StateWriter(std::span<std::byte> room) noexcept : room_(room) {}

  // Throws StateError when there is no room left.
  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (detail::Visited<const T, StateWriter&>) {
      T::visit_state(value, *this);
    } else if constexpr (detail::Optional<T>) {
      put(value.has_value());
      if (value) put(*value);
    } else if constexpr (detail::Elements<T>) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(value.size()); ++i) put(value.data()[i]);
    } else {
      static_assert(detail::Plain<T>, "give this class a visit_state(), see above");
      if (room_.size() - size_ < sizeof value) {
        throw StateError("the state is larger than what a plug-in may hand on");
      }
      std::memcpy(room_.data() + size_, &value, sizeof value);
      size_ += sizeof value;
    }
  }

  std::span<std::byte> room_;
  std::size_t size_ = 0;
};

class StateReader {
 public:
  explicit StateReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  // Throws StateError when the bytes run out.
  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  // Of bytes that were not asked for: the layouts differ.
  [[nodiscard]] std::size_t remaining() const noexcept { return bytes_.size() - used_; }

 private:
  template <class T>
  void get(T& value) {
    if constexpr (detail::Visited<T, StateReader&>) {
      T::visit_state(value, *this);
    } else if constexpr (detail::Optional<T>) {
      bool present = false;
      get(present);
      value.reset();
      if (present) get(value.emplace());
    } else if constexpr (detail::Elements<T>) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(value.size()); ++i) get(value.data()[i]);
    } else {
      static_assert(detail::Plain<T>, "give this class a visit_state(), see above");
      if (remaining() < sizeof value) {
        throw StateError("the state that was handed on is too short");
      }
      std::memcpy(&value, bytes_.data() + used_, sizeof value);
      used_ += sizeof value;
    }
  }

  std::span<const std::byte> bytes_;
  std::size_t used_ = 0;
};

}  // namespace gaitway

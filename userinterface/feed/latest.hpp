// A latest-value topic of the memory block, and what was last read of it.
#pragma once

#include <cstdint>
#include <string_view>

#include "gaitway/msgclient/client.hpp"

namespace gaitway::api {

template <class T>
class Latest {
 public:
  Latest(msgclient::Client& client, std::string_view topic) : reader_(client.read<T>(topic)) {}

  [[nodiscard]] bool is_newer() const noexcept { return reader_.newest_sequence() != sequence_; }
  // Whether there is a newer value; it is then in value().
  bool update() noexcept {
    if (!is_newer()) return false;
    const msgclient::ReadResult result = reader_.read(value_);
    if (result.status != msgclient::ReadStatus::value) return false;
    sequence_ = result.sequence;
    there_ = true;
    return true;
  }
  // Nothing of it is known until the next value.
  void forget() noexcept { there_ = false; }
  [[nodiscard]] const T& value() const noexcept { return value_; }
  [[nodiscard]] const T* if_there() const noexcept { return there_ ? &value_ : nullptr; }

 private:
  msgclient::Reader<T> reader_;
  std::uint64_t sequence_ = 0;
  bool there_ = false;
  T value_{};
};

}  // namespace gaitway::api

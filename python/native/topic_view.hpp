// The newest value of a topic in memory of its own, which outlives the robot; and what may be written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/msgclient/type_descriptor.hpp"

namespace gaitway::python {

class TopicView {
 public:
  TopicView(std::size_t topic, std::uint32_t bytes)
      : topic_(topic), bytes_(bytes), words_((bytes + 7U) / 8U) {}

  [[nodiscard]] std::size_t topic() const noexcept { return topic_; }
  [[nodiscard]] std::span<std::byte> value() noexcept {
    return std::as_writable_bytes(std::span(words_)).first(bytes_);
  }
  std::uint64_t sequence = 0;  // of the value; 0: none yet
  std::uint64_t run = 0;       // in which it was published

 private:
  std::size_t topic_;
  std::uint32_t bytes_;
  std::vector<std::uint64_t> words_;  // never resized: arrays point into it
};

// Throws std::invalid_argument naming topic, field, element, value and rule for the first number that is not
// finite or beyond its limits: what a plug-in's output would be discarded for.
void check_value(const StandardTopic& topic, std::span<const std::byte> value);

}  // namespace gaitway::python

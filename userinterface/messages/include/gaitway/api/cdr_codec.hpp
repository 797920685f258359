// Messages as CDR, little endian, as ROS 2 stores and sends them (OMG DDS-XTypes 1.3, 7.4, plain CDR version
// 1): each number at a multiple of its size from the end of the 4-byte encapsulation header; strings with
// their length and a closing 0; sequences with their count; arrays without.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace gaitway::api {

class CdrWriter {
 public:
  // Appends to `out`; begins with the encapsulation header.
  explicit CdrWriter(std::string& out) : out_(out) {
    out_.append(std::string_view("\x00\x01\x00\x00", 4));
    begin_ = out_.size();
  }

  template <class Number>
  requires std::is_arithmetic_v<Number>
  void write(Number value) {
    static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");
    align(sizeof value);
    std::array<char, sizeof value> bytes{};
    std::memcpy(bytes.data(), &value, sizeof value);
    out_.append(bytes.data(), bytes.size());
  }
  void write(const std::string& text) {
    write(static_cast<std::uint32_t>(text.size() + 1));
    out_.append(text.c_str(), text.size() + 1);
  }
  template <class Element>
  void write(const std::vector<Element>& elements) {
    write(static_cast<std::uint32_t>(elements.size()));
    write_elements(elements.data(), elements.size());
  }
  template <class Element, std::size_t count>
  void write(const std::array<Element, count>& elements) {
    write_elements(elements.data(), count);
  }
  template <class Message>
  requires std::is_class_v<Message>
  void write(const Message& message) {
    message.fields([this](std::string_view, const auto& member) { this->write(member); });
  }

 private:
  void align(std::size_t size) { out_.append((size - (out_.size() - begin_) % size) % size, '\0'); }

  template <class Element>
  void write_elements(const Element* elements, std::size_t count) {
    if constexpr (std::is_arithmetic_v<Element>) {
      if (count == 0) return;
      align(sizeof(Element));
      const std::size_t end = out_.size();
      out_.resize(end + count * sizeof(Element));
      std::memcpy(out_.data() + end, elements, count * sizeof(Element));
    } else {
      for (std::size_t i = 0; i < count; ++i) write(elements[i]);
    }
  }

  std::string& out_;
  std::size_t begin_ = 0;  // after the header
};

// Appends `message`, one of ros_messages.hpp, with its encapsulation header.
template <class Message>
void append_cdr(std::string& out, const Message& message) {
  CdrWriter(out).write(message);
}

// Reads what CdrWriter writes. Whatever the bytes: a message, or std::invalid_argument that says what is
// wrong.
class CdrReader {
 public:
  explicit CdrReader(std::string_view message) {
    if (message.substr(0, 2) != std::string_view("\x00\x01", 2) || message.size() < 4)
      throw std::invalid_argument("is no plain CDR message, little endian");
    bytes_ = message.substr(4);
  }

  template <class Number>
  requires std::is_arithmetic_v<Number>
  void read(Number& value) {
    static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");
    at_ += (sizeof value - at_ % sizeof value) % sizeof value;
    const std::string_view taken = take(sizeof value);
    if constexpr (std::is_same_v<Number, bool>) {
      value = taken[0] != 0;
    } else {
      std::memcpy(&value, taken.data(), sizeof value);
    }
  }
  void read(std::string& text) {
    std::uint32_t size = 0;
    read(size);
    text = take(size);
    if (text.empty() || text.back() != '\0') throw std::invalid_argument("a text in it has no end");
    text.pop_back();
  }
  template <class Element>
  void read(std::vector<Element>& elements) {
    std::uint32_t count = 0;
    read(count);
    if (at_ > bytes_.size() || count > bytes_.size() - at_) throw std::invalid_argument("is cut off");
    elements.resize(count);
    for (Element& element : elements) read(element);
  }
  template <class Element, std::size_t count>
  void read(std::array<Element, count>& elements) {
    for (Element& element : elements) read(element);
  }
  template <class Message>
  requires std::is_class_v<Message>
  void read(Message& message) {
    message.fields([this](std::string_view, auto& member) { this->read(member); });
  }

 private:
  std::string_view take(std::size_t size) {
    if (at_ > bytes_.size() || size > bytes_.size() - at_) throw std::invalid_argument("is cut off");
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  std::string_view bytes_;  // after the header
  std::size_t at_ = 0;
};

template <class Message>
[[nodiscard]] Message read_cdr(std::string_view bytes) {
  Message message;
  CdrReader(bytes).read(message);
  return message;
}

}  // namespace gaitway::api

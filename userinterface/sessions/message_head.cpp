// The parser tells of every value; only those that belong to the outermost object are kept.
#include "message_head.hpp"

#include <cstddef>
#include <utility>

namespace gaitway::api {
namespace {

using nlohmann::json;

class HeadReader final : public nlohmann::json_sax<json> {
 public:
  [[nodiscard]] MessageHead take() { return std::move(head_); }
  [[nodiscard]] bool is_object() const noexcept { return is_object_; }

  bool null() override { return other(); }
  bool boolean(bool) override { return other(); }
  bool number_integer(number_integer_t value) override { return number(value); }
  bool number_unsigned(number_unsigned_t value) override { return number(value); }
  bool number_float(number_float_t, const string_t&) override { return other(); }
  bool binary(binary_t&) override { return other(); }
  bool string(string_t& value) override {
    if (text_ != nullptr) {
      *text_ = std::move(value);
    } else if (is_id_) {
      head_.id = std::move(value);
    }
    return forget_field();
  }
  bool key(string_t& name) override {
    if (depth_ == 1) {
      text_ = name == "op"            ? &head_.op
              : name == "service"     ? &head_.service
              : name == "compression" ? &head_.compression
                                      : nullptr;
      is_id_ = name == "id";
    }
    return true;
  }
  bool start_object(std::size_t) override {
    is_object_ |= depth_ == 0;
    return deeper();
  }
  bool start_array(std::size_t) override { return deeper(); }
  bool end_object() override { return higher(); }
  bool end_array() override { return higher(); }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

 private:
  bool forget_field() noexcept {
    text_ = nullptr;
    is_id_ = false;
    return true;
  }
  // A value that no field of the head may have.
  bool other() {
    if (text_ != nullptr) {
      text_->clear();
    } else if (is_id_) {
      head_.id = nullptr;
    }
    return forget_field();
  }
  template <class Number>
  bool number(Number value) {
    const bool is_id = is_id_;
    other();
    if (is_id) {
      head_.id = value;
    }
    return true;
  }
  bool deeper() {
    other();
    ++depth_;
    return true;
  }
  bool higher() noexcept {
    --depth_;
    return true;
  }

  MessageHead head_;
  std::string* text_ = nullptr;  // the field whose value comes next
  bool is_id_ = false;           // likewise, the id
  bool is_object_ = false;
  std::size_t depth_ = 0;
};

}  // namespace

std::optional<MessageHead> head_of(std::string_view message) {
  HeadReader reader;
  if (!json::sax_parse(message, &reader) || !reader.is_object()) {
    return std::nullopt;
  }
  return reader.take();
}

}  // namespace gaitway::api

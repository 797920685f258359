#include "fragments.hpp"

#include <algorithm>
#include <utility>

#include "gaitway/api/json_codec.hpp"

namespace gaitway::api {

Fragments::Fragments(std::shared_ptr<const std::string> whole, std::size_t piece_bytes, std::string id)
    : whole_(std::move(whole)), piece_bytes_(std::max(piece_bytes, kLeast_bytes)), id_(std::move(id)) {
  for (std::size_t at = 0; at < whole_->size(); at = end_of_piece(at)) {
    ++total_;
  }
}

Frame Fragments::next() {
  const std::size_t end = end_of_piece(begin_);
  auto text = std::make_shared<std::string>(R"({"op":"fragment","id":)");
  append_json_string(*text, id_);
  *text += R"(,"data":)";
  append_json_string(*text, std::string_view(*whole_).substr(begin_, end - begin_));
  *text += ",\"num\":" + std::to_string(number_) + ",\"total\":" + std::to_string(total_) + "}";
  begin_ = end;
  ++number_;
  return {std::move(text), false};
}

std::size_t Fragments::end_of_piece(std::size_t begin) const noexcept {
  std::size_t end = std::min(begin + piece_bytes_, whole_->size());
  const auto inside_character = [this](std::size_t at) {
    return at < whole_->size() && (static_cast<unsigned char>((*whole_)[at]) & 0xC0U) == 0x80U;
  };
  // A character has at most three bytes after its first.
  for (int i = 0; i < 3 && inside_character(end); ++i) {
    --end;
  }
  return end;
}

}  // namespace gaitway::api

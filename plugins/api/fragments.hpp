// A long message cut into rosbridge's `fragment` messages, one at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "gaitway/api/session.hpp"

namespace gaitway::api {

class Fragments {
 public:
  // Smaller pieces would be mostly envelope.
  static constexpr std::size_t kLeast_bytes = 64;

  // Pieces of at most `piece_bytes` (at least kLeast_bytes) of UTF-8 text, cut between characters. `id` tells
  // this message's fragments from those of others to the same client.
  Fragments(std::shared_ptr<const std::string> whole, std::size_t piece_bytes, std::string id);

  [[nodiscard]] bool done() const noexcept { return begin_ == whole_->size(); }
  // The next one; not when done.
  [[nodiscard]] Frame next();
  [[nodiscard]] std::size_t whole_bytes() const noexcept { return whole_->size(); }

 private:
  [[nodiscard]] std::size_t end_of_piece(std::size_t begin) const noexcept;

  std::shared_ptr<const std::string> whole_;
  std::size_t piece_bytes_;
  std::string id_;
  std::size_t begin_ = 0;
  std::size_t number_ = 0, total_ = 0;
};

}  // namespace gaitway::api

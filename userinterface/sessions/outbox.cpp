// Room for answers at the expense of publications, and long texts cut between characters.
#include "outbox.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "gaitway/api/json_codec.hpp"

namespace gaitway::api {
namespace {

std::size_t cost_bytes(const std::string& message) {
  return message.size() + Outbox::kMessage_bytes;
}

}  // namespace

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

bool Outbox::answer(Frame frame, std::size_t fragment_bytes) {
  std::vector<Frame> frames;
  if (fragment_bytes > 0 && !frame.binary && frame.bytes->size() > fragment_bytes) {
    for (Fragments pieces = cut(frame, fragment_bytes); !pieces.done();) {
      frames.push_back(pieces.next());
    }
  } else {
    frames.push_back(std::move(frame));
  }
  std::size_t bytes = 0;
  for (const Frame& piece : frames) {
    bytes += cost_bytes(*piece.bytes);
  }
  if (!make_room(bytes)) {
    return false;
  }
  keep(bytes);
  std::move(frames.begin(), frames.end(), std::back_inserter(answers_));
  return true;
}

void Outbox::open(LaneKey key, const Terms& terms) {
  if (key.number >= lanes_.size()) {
    lanes_.resize(key.number + 1);
  }
  auto& place = lanes_[key.number];
  if (!place) {
    place = std::make_unique<Lane>();
  }
  place->terms = terms;
  while (place->waiting.size() > terms.queue_length) {
    drop_oldest(*place, false);
  }
}

void Outbox::close(LaneKey key) {
  auto& place = lanes_[key.number];
  if (place) {
    discard(place->bytes);
    place.reset();
  }
}

void Outbox::close_all() {
  for (std::size_t number = 0; number < lanes_.size(); ++number) {
    close(LaneKey(number));
  }
}

void Outbox::clear() {
  close_all();
  answers_.clear();
  rest_.reset();
  discard(waiting_bytes_);
}

void Outbox::keep(std::size_t bytes) noexcept {
  waiting_bytes_ += bytes;
  waiting_bytes_of_all_ += bytes;
}

void Outbox::discard(std::size_t bytes) noexcept {
  waiting_bytes_ -= bytes;
  waiting_bytes_of_all_ -= bytes;
}

const Terms* Outbox::terms(LaneKey key) const noexcept {
  const auto& place = lanes_[key.number];
  return place ? &place->terms : nullptr;
}

LaneKey Outbox::free_lane() const noexcept {
  std::size_t number = kTopicCount;
  while (number < lanes_.size() && lanes_[number]) {
    ++number;
  }
  return LaneKey(number);
}

bool Outbox::hold(std::size_t bytes) noexcept {
  const bool room = make_room(bytes);
  if (room) {
    keep(bytes);
  }
  return room;
}

void Outbox::offer(LaneKey key, const Frame& frame, std::int64_t now_ns) {
  Lane& lane = *this->lane(key);
  const bool slow = lane.slow(now_ns);
  while (lane.waiting.size() >= lane.terms.queue_length) {
    drop_oldest(lane, slow);
  }
  const std::size_t bytes = cost_bytes(*frame.bytes);
  if (!make_room(bytes)) {
    ++lane.drops;
    has_drops_ = true;
    return;
  }
  lane.waiting.push_back(frame);
  lane.bytes += bytes;
  keep(bytes);
}

std::optional<Frame> Outbox::next(std::int64_t now_ns) {
  if (!answers_.empty()) {
    Frame frame = std::move(answers_.front());
    answers_.pop_front();
    discard(cost_bytes(*frame.bytes));
    return frame;
  }
  if (rest_) {
    Frame piece = rest_->next();
    if (rest_->done()) {
      discard(cost_bytes(rest_->whole()));
      rest_.reset();
    }
    return piece;
  }
  return next_of_lanes(now_ns);
}

bool Outbox::ready(std::int64_t now_ns) const noexcept {
  return !answers_.empty() || rest_ || std::ranges::any_of(lanes_, [now_ns](const auto& lane) {
    return lane && !lane->waiting.empty() && lane->due(now_ns);
  });
}

std::uint64_t Outbox::take_drops(LaneKey key) noexcept {
  Lane* const lane = this->lane(key);
  const std::uint64_t drops = lane != nullptr ? std::exchange(lane->drops, 0) : 0;
  has_drops_ = std::ranges::any_of(lanes_, [](const auto& place) { return place && place->drops > 0; });
  return drops;
}

bool Outbox::make_room(std::size_t bytes) noexcept {
  while (waiting_bytes_ + bytes > most_bytes_) {
    const auto bytes_of = [](const auto& lane) { return lane ? lane->bytes : 0; };
    const auto fullest = std::ranges::max_element(
        lanes_, [&](const auto& a, const auto& b) { return bytes_of(a) < bytes_of(b); });
    if (bytes_of(*fullest) == 0 || bytes > most_bytes_) {
      return false;
    }
    drop_oldest(**fullest, true);
  }
  return true;
}

void Outbox::drop_oldest(Lane& lane, bool slow) noexcept {
  const std::size_t bytes = cost_bytes(*lane.waiting.front().bytes);
  lane.bytes -= bytes;
  discard(bytes);
  lane.waiting.pop_front();
  if (slow) {
    ++lane.drops;
    has_drops_ = true;
  }
}

std::optional<Frame> Outbox::next_of_lanes(std::int64_t now_ns) {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    const std::size_t at = (turn_ + i) % lanes_.size();
    Lane* const lane = lanes_[at].get();
    if (lane != nullptr && !lane->waiting.empty() && lane->due(now_ns)) {
      turn_ = (at + 1) % lanes_.size();
      lane->sent_ns = now_ns;
      return start(*lane);
    }
  }
  return std::nullopt;
}

// Takes the lane's oldest message: whole, or its first piece, and the rest is to follow.
Frame Outbox::start(Lane& lane) {
  Frame frame = std::move(lane.waiting.front());
  lane.waiting.pop_front();
  const std::size_t bytes = cost_bytes(*frame.bytes);
  lane.bytes -= bytes;
  const std::size_t fragment_bytes = lane.terms.fragment_bytes;
  if (frame.binary || fragment_bytes == 0 || frame.bytes->size() <= fragment_bytes) {
    discard(bytes);
    return frame;
  }
  rest_ = cut(frame, fragment_bytes);
  return rest_->next();  // at least one more follows
}

Fragments Outbox::cut(const Frame& frame, std::size_t fragment_bytes) {
  return {frame.bytes, fragment_bytes, std::to_string(++fragmented_)};
}

}  // namespace gaitway::api

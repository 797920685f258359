// What waits for one client: answers in their order, and for each topic it subscribes to the newest messages,
// long ones cut into fragments. Bounded, whatever the client reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/api/publication.hpp"
#include "gaitway/api/session.hpp"

namespace gaitway::api {

// A long message cut into rosbridge's `fragment` messages, one at a time.
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
  [[nodiscard]] const std::string& whole() const noexcept { return *whole_; }

 private:
  [[nodiscard]] std::size_t end_of_piece(std::size_t begin) const noexcept;

  std::shared_ptr<const std::string> whole_;
  std::size_t piece_bytes_;
  std::string id_;
  std::size_t begin_ = 0;
  std::size_t number_ = 0, total_ = 0;
};

// How messages of a topic are to be sent.
struct Terms {
  std::int64_t throttle_ns = 0;    // between two of them, at least
  std::size_t queue_length = 1;    // the newest so many wait, at least 1
  std::size_t fragment_bytes = 0;  // longer ones are sent in pieces; 0: as they are
  Encoding encoding = Encoding::json;
};

// One of the queues of an outbox: a topic of the robot, or a number beyond them all.
struct LaneKey {
  constexpr LaneKey() noexcept = default;
  constexpr LaneKey(Topic topic) noexcept : number(static_cast<std::size_t>(topic)) {}
  constexpr explicit LaneKey(std::size_t lane_number) noexcept : number(lane_number) {}
  [[nodiscard]] constexpr bool operator==(const LaneKey&) const noexcept = default;

  std::size_t number = 0;
};

class Outbox {
 public:
  // What a message that waits takes beside its text: allocations, and its place in a queue.
  static constexpr std::size_t kMessage_bytes = 128;

  // `most_bytes` may wait at once; they are also counted in `waiting_bytes_of_all`.
  Outbox(std::size_t most_bytes, std::size_t& waiting_bytes_of_all)
      : most_bytes_(most_bytes), waiting_bytes_of_all_(waiting_bytes_of_all), lanes_(kTopicCount) {}
  ~Outbox() { discard(waiting_bytes_); }
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  // An answer or status; goes before publications, which give way to it. False: no room, even so.
  [[nodiscard]] bool answer(Frame frame, std::size_t fragment_bytes = 0);

  // The topic is subscribed to, or on other terms.
  void open(LaneKey key, const Terms& terms);
  void close(LaneKey key);
  void close_all();
  // Nothing waits any more, answers neither.
  void clear();
  [[nodiscard]] const Terms* terms(LaneKey key) const noexcept;
  // One that is closed, and belongs to no topic of the robot.
  [[nodiscard]] LaneKey free_lane() const noexcept;
  // Room for something that is kept elsewhere on behalf of this client; publications give way to it. False:
  // there is none, even so.
  [[nodiscard]] bool hold(std::size_t bytes) noexcept;
  void let_go(std::size_t bytes) noexcept { discard(bytes); }
  // A publication; the topic is open. Older ones beyond the queue's length are dropped, and counted unless
  // they were throttled on demand.
  void offer(LaneKey key, const Frame& frame, std::int64_t now_ns);

  // The next frame: answers first, then what is left of a message in pieces, then topics by turns.
  [[nodiscard]] std::optional<Frame> next(std::int64_t now_ns);
  [[nodiscard]] bool ready(std::int64_t now_ns) const noexcept;

  [[nodiscard]] std::size_t waiting_bytes() const noexcept { return waiting_bytes_; }
  // Messages of the topic that were dropped because the client was too slow, since this was asked last.
  [[nodiscard]] std::uint64_t take_drops(LaneKey key) noexcept;
  [[nodiscard]] bool has_drops() const noexcept { return has_drops_; }

 private:
  struct Lane {
    Terms terms;
    std::deque<Frame> waiting;
    std::size_t bytes = 0;
    std::optional<std::int64_t> sent_ns;
    std::uint64_t drops = 0;
    [[nodiscard]] bool due(std::int64_t now_ns) const noexcept {
      return !sent_ns || now_ns - *sent_ns >= terms.throttle_ns;
    }
    // What is dropped now is dropped because the client is slow, not because it wanted fewer messages.
    [[nodiscard]] bool slow(std::int64_t now_ns) const noexcept {
      return terms.throttle_ns == 0 || (sent_ns && now_ns - *sent_ns >= 2 * terms.throttle_ns);
    }
  };
  void keep(std::size_t bytes) noexcept;
  void discard(std::size_t bytes) noexcept;
  [[nodiscard]] Lane* lane(LaneKey key) noexcept { return lanes_[key.number].get(); }
  [[nodiscard]] bool make_room(std::size_t bytes) noexcept;
  void drop_oldest(Lane& lane, bool slow) noexcept;
  [[nodiscard]] std::optional<Frame> next_of_lanes(std::int64_t now_ns);
  [[nodiscard]] Frame start(Lane& lane);
  [[nodiscard]] Fragments cut(const Frame& frame, std::size_t fragment_bytes);

  std::size_t most_bytes_;
  std::size_t waiting_bytes_ = 0;
  std::size_t& waiting_bytes_of_all_;
  std::deque<Frame> answers_;
  std::optional<Fragments> rest_;
  std::vector<std::unique_ptr<Lane>> lanes_;  // those of the robot's topics first
  std::size_t turn_ = 0;                      // the lane that is asked first
  std::uint64_t fragmented_ = 0;
  bool has_drops_ = false;
};

}  // namespace gaitway::api

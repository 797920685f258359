// Two wires in virtual time, one for each direction, and everything that may happen to bytes on them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <random>

#include "gaitway/link/carrier.hpp"

namespace gaitway::link::test {

// Each with its probability for a byte, but for the cut.
struct WireFaults {
  double flipped_bit = 0.0, lost = 0.0, doubled = 0.0, garbage = 0.0;  // garbage: a random byte in front
};

class SimulatedWire {
 public:
  // `byte_ns` 0: what is written is there at once.
  SimulatedWire(std::int64_t byte_ns, std::size_t buffer_bytes, std::uint64_t seed)
      : byte_ns_(byte_ns), random_(seed), to_right_(*this, buffer_bytes), to_left_(*this, buffer_bytes) {}

  Carrier& left() { return left_; }
  Carrier& right() { return right_; }

  void advance(std::int64_t until_ns) {
    now_ns_ = until_ns;
    to_right_.advance();
    to_left_.advance();
  }
  void set_faults(const WireFaults& faults) { faults_ = faults; }
  // What is written is lost; `holding`: it waits, and comes when the cut ends.
  void cut(bool is_cut, bool holding = false) {
    to_right_.cut = to_left_.cut = is_cut && !holding;
    to_right_.held = to_left_.held = is_cut && holding;
  }
  void cut_to_right(bool is_cut) { to_right_.cut = is_cut; }

 private:
  struct Direction {
    Direction(SimulatedWire& wire, std::size_t bytes) : owner(wire), buffer_bytes(bytes) {}

    void advance() {
      while (!queue.empty() && !held) {
        const std::int64_t done_ns = std::max(free_ns, queue.front().written_ns) + owner.byte_ns_;
        if (done_ns > owner.now_ns_) {
          return;
        }
        free_ns = done_ns;
        deliver(queue.front().byte);
        queue.pop_front();
      }
    }
    void deliver(std::uint8_t byte) {
      if (cut || owner.happens(owner.faults_.lost)) return;
      if (owner.happens(owner.faults_.garbage)) arrived.push_back(owner.any_byte());
      if (owner.happens(owner.faults_.flipped_bit)) {
        byte = static_cast<std::uint8_t>(byte ^ 1U << (owner.any_byte() % 8U));
      }
      arrived.push_back(byte);
      if (owner.happens(owner.faults_.doubled)) arrived.push_back(byte);
    }

    struct Waiting {
      std::uint8_t byte;
      std::int64_t written_ns;
    };
    SimulatedWire& owner;
    std::size_t buffer_bytes;
    std::deque<Waiting> queue;
    std::deque<std::uint8_t> arrived;
    std::int64_t free_ns = 0;
    bool cut = false, held = false;
  };

  class Port final : public Carrier {
   public:
    Port(Direction& out, Direction& in) : out_(out), in_(in) {}
    std::size_t write(Bytes bytes) noexcept override {
      const std::size_t room = out_.buffer_bytes - std::min(out_.buffer_bytes, out_.queue.size());
      const std::size_t count = std::min(bytes.size(), room);
      for (const std::uint8_t byte : bytes.first(count)) {
        out_.queue.push_back({byte, out_.owner.now_ns_});
      }
      if (out_.owner.byte_ns_ == 0) out_.advance();
      return count;
    }
    std::size_t read(std::span<std::uint8_t> room) noexcept override {
      const std::size_t count = std::min(room.size(), in_.arrived.size());
      std::copy_n(in_.arrived.begin(), count, room.begin());
      in_.arrived.erase(in_.arrived.begin(), in_.arrived.begin() + static_cast<std::ptrdiff_t>(count));
      return count;
    }
    [[nodiscard]] bool connected() const noexcept override { return true; }

   private:
    Direction& out_;
    Direction& in_;
  };

  bool happens(double probability) {
    return probability > 0.0 && std::bernoulli_distribution(probability)(random_);
  }
  std::uint8_t any_byte() { return static_cast<std::uint8_t>(random_()); }

  std::int64_t byte_ns_;
  std::mt19937_64 random_;
  WireFaults faults_;
  std::int64_t now_ns_ = 0;
  Direction to_right_, to_left_;
  Port left_{to_right_, to_left_}, right_{to_left_, to_right_};
};

}  // namespace gaitway::link::test

// Stop datagrams (userinterface/stopgram/). Whatever comes: what decodes encodes to the same bytes, nothing
// without the right code is answered or obeyed, an answer is never longer than its question, no stop is
// carried out twice, and a client that is heard again has its stop obeyed.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/stopgram/stop_desk.hpp"
#include "gaitway/stopgram/stop_sender.hpp"

namespace gaitway::fuzz {
namespace {

using namespace stopgram;

constexpr std::int64_t kStep_ns = facts::kMillisecond_ns;
constexpr char kToken[] = "0123456789abcdef";

template <class Message>
void check_codec(Bytes content) {
  Message message;
  std::array<std::uint8_t, kMostDatagramBytes> room{};
  if (decode(content, message)) {
    const std::size_t size = encode(message, room);
    require(std::ranges::equal(Bytes(room).first(size), content), "what decodes encodes to the same bytes");
  }
}

class Robot {
 public:
  Robot() {
    for (std::uint64_t client = 1; client <= 3; ++client) {
      senders_.emplace_back(StopKey(kToken), client);
    }
  }

  void say(Bytes datagram) {
    for (const Bytes content :
         {datagram, datagram.first(datagram.size() - std::min(datagram.size(), kMacBytes))}) {
      check_codec<Greeting>(content);
      check_codec<Welcome>(content);
      check_codec<Stop>(content);
      check_codec<Ack>(content);
      check_codec<Stranger>(content);
    }
    const Bytes answer = desk_->on_datagram(datagram, peer_, now_ns_);
    require(answer.size() <= datagram.size(), "an answer is not longer than its question");
    require(answer.empty() || key_.has_signed(datagram), "who has no token is not answered");
    while (const auto stop = desk_->next_stop(asked_)) {
      require(key_.has_signed(datagram), "who has no token stops nothing");
      require(carried_out_.emplace(stop->client, stop->number, stop->kind).second,
              "no stop is carried out twice");
      ++(stop->kind == StopKind::stop             ? asked_.stops
         : stop->kind == StopKind::emergency_hold ? asked_.holds
                                                  : asked_.softs);
    }
    desk_->obeyed(asked_);
    answer_.assign(answer.begin(), answer.end());
  }
  // With the right code behind it.
  void say_signed(Bytes content) {
    std::vector<std::uint8_t> datagram(content.begin(), content.end());
    datagram.resize(datagram.size() + kMacBytes);
    require(key_.sign(datagram), "every content has a code");
    // Whoever has the key may say what it likes, but not in another client's name.
    if (Stop stop; decode(content, stop) && stop.client <= senders_.size()) {
      return;
    }
    say(datagram);
  }
  void stop(std::size_t client, StopKind kind) { senders_[client].stop(kind); }
  void exchange(std::size_t client, bool answers) {
    for (Bytes said; !(said = senders_[client].next(now_ns_)).empty();) {
      record_.emplace_back(said.begin(), said.end());
      say(said);
      if (answers) {
        senders_[client].on_datagram(answer_, now_ns_);
      }
    }
    now_ns_ += StopSender::kRepeat_ns;
  }
  void replay(std::size_t which) {
    if (!record_.empty()) {
      say(std::vector(record_[which % record_.size()]));
    }
  }
  void answer(std::size_t client, Bytes datagram) { senders_[client].on_datagram(datagram, now_ns_); }
  void sleep(std::int64_t duration_ns) { now_ns_ += duration_ns; }
  void tell() {
    while (desk_->take_refusal(now_ns_)) {
    }
  }
  void check_that_all_are_obeyed() {
    for (std::size_t client = 0; client < senders_.size(); ++client) {
      stop(client, StopKind::emergency_soft);
      for (int i = 0; i < 10; ++i) {
        exchange(client, true);
      }
      require(senders_[client].state(StopKind::emergency_soft) == StopState::obeyed,
              "who is heard is obeyed");
    }
  }

 private:
  StopKey key_{kToken};
  std::unique_ptr<StopDesk> desk_ = std::make_unique<StopDesk>(StopKey(kToken), 1);
  std::vector<StopSender> senders_;
  Peer peer_;
  std::int64_t now_ns_ = 0;
  link::StopCounts asked_;
  std::set<std::tuple<std::uint64_t, std::uint32_t, StopKind>> carried_out_;
  std::vector<std::vector<std::uint8_t>> record_;
  std::vector<std::uint8_t> answer_;
};

}  // namespace

void stop_datagrams(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  Robot robot;
  // A client that gave way to others may have a stop carried out twice: here none does.
  constexpr int kMostActions = 60;
  static_assert(kMostActions + 3 < StopDesk::kClients);
  for (int action = 0; action < kMostActions && !input.empty(); ++action) {
    const std::size_t client = input.choose(3);
    switch (input.choose(8)) {
      case 0:
        robot.say(input.take_bytes(input.choose(kMostDatagramBytes + 2)));
        break;
      case 1:
        robot.say_signed(input.take_bytes(input.choose(kStopBytes - kMacBytes + 1)));
        break;
      case 2:
        robot.stop(client, static_cast<StopKind>(input.choose(kStopKinds)));
        break;
      case 3:
        robot.replay(input.take<std::uint8_t>());
        break;
      case 4:
        robot.answer(client, input.take_bytes(input.choose(kMostDatagramBytes + 2)));
        break;
      case 5:
        robot.sleep(kStep_ns * input.take<std::uint16_t>());
        robot.tell();
        break;
      default:
        robot.exchange(client, input.flag());
    }
  }
  robot.check_that_all_are_obeyed();
}

}  // namespace gaitway::fuzz

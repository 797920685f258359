// The narrow link (userinterface/link/). Whatever comes: a frame's content encodes to a frame that decodes to
// the same, what decodes encodes to the same bytes, no order is carried out twice or after its expiry, every
// outcome is that of an order that was given, and two ends that hear each other again have a session, in
// which an order is answered.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/link/controller_end.hpp"
#include "gaitway/link/module_end.hpp"

namespace gaitway::fuzz {
namespace {

using namespace link;

constexpr std::array kChannels{Channel{"small", 40}, Channel{"large", 600}};
constexpr std::int64_t kMs = facts::kMillisecond_ns;

template <class Message>
void check_codec(Bytes content) {
  Message message;
  if (!decode(content, message)) {
    return;
  }
  std::array<std::uint8_t, kMostContentBytes> room{};
  std::size_t size = 0;
  if constexpr (std::is_same_v<Message, Hello>) {
    size = encode(message, room);
  } else {
    size = encode(message, session_of(content), room);
  }
  require(std::ranges::equal(Bytes(room).first(size), content), "what decodes encodes to the same bytes");
}

void check_content(Bytes content) {
  std::array<std::uint8_t, kMostFrameBytes> wire{};
  const Bytes frame = Bytes(wire).first(encode_frame(content, wire));
  require(frame.size() == content.size() + kFramingBytes, "every content has a frame");
  FrameDecoder decoder;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const std::optional<Bytes> back = decoder.take(frame[i]);
    require(back.has_value() == (i + 1 == frame.size()), "a frame ends with its last zero");
    require(!back || std::ranges::equal(*back, content), "a frame's content is what was put into it");
  }
  check_codec<Hello>(content);
  check_codec<Status>(content);
  check_codec<StopMessage>(content);
  check_codec<StopAnswer>(content);
  check_codec<Part>(content);
  check_codec<StateFragment>(content);
}

class Link {
 public:
  Link() { exchange(200, 10); }

  // Raw bytes to one end.
  void say(bool to_module, Bytes bytes) {
    if (to_module) {
      module_->on_bytes(bytes, now_ns_);
    } else {
      controller_->on_bytes(bytes, now_ns_);
    }
    look();
  }
  // A frame with the right checksum and, if wanted, of the session of now.
  void say_frame(bool to_module, bool of_session, Bytes content) {
    std::vector<std::uint8_t> changed(content.begin(), content.end());
    if (of_session && changed.size() >= kHeaderBytes) {
      const std::uint32_t tag = module_->session().tag();
      for (std::size_t i = 0; i < 4; ++i) changed[1 + i] = static_cast<std::uint8_t>(tag >> (8 * i));
    }
    check_content(changed);
    std::array<std::uint8_t, kMostFrameBytes> wire{};
    say(to_module, Bytes(wire).first(encode_frame(changed, wire)));
  }
  void submit(Bytes payload, std::int64_t validity_ns) {
    const Submission submission = module_->submit(1, payload, now_ns_ + validity_ns, now_ns_);
    if (submission.refusal == Refusal::none) {
      require(given_.insert({submission.id.session, submission.id.number}).second,
              "orders have ids of their own");
    }
  }
  void publish(std::size_t channel, Bytes value) { controller_->publish(channel, value, now_ns_); }
  void stop() { module_->stop(StopKind::stop); }

  void exchange(int milliseconds, int step_ms = 1) {
    for (int i = 0; i < milliseconds; i += step_ms) {
      now_ns_ += step_ms * kMs;
      for (Bytes bytes; !(bytes = module_->pending(now_ns_)).empty(); module_->taken(bytes.size())) {
        controller_->on_bytes(bytes, now_ns_);
      }
      look();
      for (Bytes bytes; !(bytes = controller_->pending(now_ns_)).empty(); controller_->taken(bytes.size())) {
        module_->on_bytes(bytes, now_ns_);
      }
      look();
    }
  }
  void sleep(int milliseconds) { now_ns_ += milliseconds * kMs; }

  void check_that_it_recovers() {
    exchange(2000, 10);
    require(module_->session().open() && controller_->session().open(),
            "ends that hear each other have a session");
    require(given_.empty(), "every order has its outcome");
  }

 private:
  void look() {
    while (const std::optional<Order> order = controller_->next_order(now_ns_)) {
      require(now_ns_ <= order->expiry_ns, "nothing is carried out late");
      require(carried_out_.insert({order->id.session, order->id.number}).second,
              "nothing is carried out twice");
      controller_->answer(order->id, 0, order->payload);
    }
    while (const std::optional<Outcome> outcome = module_->next_outcome(now_ns_)) {
      require(given_.erase({outcome->id.session, outcome->id.number}) == 1, "an outcome is that of an order");
    }
    while (module_->state().next_changed()) {
    }
  }

  std::unique_ptr<ModuleEnd> module_ =
      std::make_unique<ModuleEnd>(LinkIdentity{Role::module, 1, 3, "module"}, kChannels, LinkSettings{});
  std::unique_ptr<ControllerEnd> controller_ = std::make_unique<ControllerEnd>(
      LinkIdentity{Role::controller, 2, 3, "controller"}, kChannels, LinkSettings{});
  std::int64_t now_ns_ = 0;
  std::set<std::pair<std::uint32_t, std::uint32_t>> given_, carried_out_;
};

}  // namespace

void link_frames(std::span<const std::uint8_t> bytes) {
  FrameDecoder decoder;
  for (const std::uint8_t byte : bytes) {
    if (const std::optional<Bytes> content = decoder.take(byte)) {
      check_content(*content);
    }
  }
  Input input(bytes);
  Link link;
  constexpr int kMostActions = 200;
  for (int action = 0; action < kMostActions && !input.empty(); ++action) {
    const bool flag = input.flag();
    switch (input.choose(8)) {
      case 0:
        link.say(flag, input.take_bytes(input.take<std::uint8_t>()));
        break;
      case 1:
      case 2: {
        const Bytes content = input.take_bytes(1 + input.choose(kMostContentBytes));
        if (!content.empty()) link.say_frame(input.flag(), flag, content);
        break;
      }
      case 3:
        link.submit(input.take_bytes(input.take<std::uint16_t>() % 1200),
                    static_cast<std::int64_t>(input.choose(250)) * kMs);
        break;
      case 4:
        link.publish(input.choose(3), input.take_bytes(input.take<std::uint16_t>() % 700));
        break;
      case 5:
        link.stop();
        break;
      case 6:
        link.sleep(static_cast<int>(input.choose(256)));
        break;
      default:
        link.exchange(static_cast<int>(input.choose(20)));
    }
  }
  link.check_that_it_recovers();
}

}  // namespace gaitway::fuzz

// The message controller (msgcontroller/message_controller.hpp) under any mails from the main controller, any
// frames from other stations and any states of its bus. Whatever comes: every frame that it sends is a
// message of its profile that only it may send, with a content that decodes; a trim that is no number moves
// nothing; its queue stays bounded; every hand-over and user command is answered once; an emergency stop
// stays one.
#include "gaitway/msgcontroller/message_controller.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "fuzz_frame.hpp"
#include "gaitway/can/message_layout.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/emi_adapter.hpp"
#include "robot.hpp"

namespace gaitway::fuzz {
namespace {

using namespace msgclient;
using msgcontroller::Mode;

const urdf::RobotModel& robot(bool paper) {
  static const urdf::RobotModel with_paper_profile = [] {
    urdf::RobotModel model = shipped_robot();
    model.network.profile = "paper";
    return model;
  }();
  return paper ? with_paper_profile : shipped_robot();
}

bool decodes(const can::Profile& profile, const can::Frame& frame) {
  return can::decode_emergency_stop(profile, frame) || can::decode_user_command(profile, frame) ||
         can::decode_sync(profile, frame) || can::decode_trim(profile, frame) ||
         can::decode_trajectory(profile, frame) || can::decode_resynchronisation(profile, frame) ||
         can::decode_heartbeat(profile, frame) || can::decode_tail(profile, frame);
}

class Controller {
 public:
  explicit Controller(const urdf::RobotModel& robot)
      : robot_(robot),
        client_(block_.local_client("message_controller")),
        adapter_(block_),
        controller_(robot, client_, adapter_.message()),
        hand_over_(std::make_unique<HandOver>()) {}

  [[nodiscard]] const can::Profile& profile() const { return controller_.profile(); }

  void step(std::size_t milliseconds) {
    for (; milliseconds > 0; --milliseconds) {
      now_ns_ += facts::kMillisecond_ns;
      controller_.step(now_ns_);
      take_frames();
      while (const auto answer = adapter_.host().take_answer(now_ns_)) {
        ++answers_;
      }
    }
    require(answers_ <= mails_, "nothing is answered twice");
    const bool stopped = controller_.mode() == Mode::emergency_stop;
    require(stopped || !stopped_ || release_asked_, "nothing but a release ends an emergency stop");
    stopped_ = stopped;
  }
  void check_that_all_is_answered() {
    constexpr std::size_t kLongEnough_ms = 400;
    step(kLongEnough_ms);
    require(answers_ == mails_, "every hand-over and every user command is answered");
  }

  void receive(const can::Frame& frame) {
    controller_.on_frame(frame, now_ns_);
    take_frames();
  }
  void on_bus_state(Input& input) {
    const auto state = static_cast<can::BusState>(input.choose(4));
    controller_.on_bus_state(state, {.transmit = input.take<std::uint8_t>(), .receive = 0}, now_ns_);
    take_frames();
  }

  // A batch and a tail for the next cycle that go on from where the joints stand, but for what the fuzzer
  // changes.
  void post_hand_over(Input& input) {
    HandOver& mail = *hand_over_;
    mail.sequence = controller_.state().cycle + 1 + static_cast<std::uint32_t>(input.choose(4) / 3);
    mail.joint_count = static_cast<std::uint32_t>(robot_.joints.size());
    mail.point_count = static_cast<std::uint32_t>(kBatchPoints + input.choose(32));
    mail.support.fill(static_cast<std::uint8_t>(input.choose(3)));
    for (int point = 0; point < static_cast<int>(mail.point_count); ++point) {
      for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
        const double count = controller_.expected_count(static_cast<int>(joint));
        mail.set_position(point, static_cast<int>(joint),
                          static_cast<float>(count * robot_.joints[joint].count_rad));
      }
    }
    for (std::size_t changes = input.choose(8); changes > 0; --changes) {
      const auto at = input.take<std::uint16_t>() % std::max(mail.point_count * mail.joint_count, 1U);
      mail.position[at] +=
          input.flag() ? input.take_float() : static_cast<float>(input.take<std::int8_t>()) * 1e-3F;
    }
    mails_ += adapter_.host().post(mail, now_ns_) ? 1U : 0U;
  }
  void post_user_command(Input& input) {
    const UserCommandMail mail{.sequence = input.take<std::uint32_t>(),
                               .kind = static_cast<UserCommandKind>(input.choose(5)),
                               .joint = static_cast<std::uint32_t>(input.choose(24)),
                               .position = input.flag() ? input.take_float() : 0.0F,
                               .duration_slots = input.take<std::uint16_t>()};
    release_asked_ = release_asked_ || mail.kind == UserCommandKind::release;
    mails_ += adapter_.host().post(mail, now_ns_) ? 1U : 0U;
  }
  // Trims of the main controller are judged alone: there are no trim gains in this.
  void post_trim(Input& input) {
    TrimUpdate mail{.stamp_ns = now_ns_, .channel_count = static_cast<std::uint32_t>(input.choose(9))};
    for (float& angle : mail.angle) {
      angle = input.take_float();
    }
    if (!adapter_.host().post(mail, now_ns_)) {
      return;
    }
    for (std::size_t channel = 0; channel < kTrimChannels; ++channel) {
      const bool positive = channel < mail.channel_count && mail.angle[channel] > 0.0F;
      const bool negative = channel < mail.channel_count && mail.angle[channel] < 0.0F;
      may_be_positive_[channel] = may_be_positive_[channel] || positive;
      may_be_negative_[channel] = may_be_negative_[channel] || negative;
    }
  }

 private:
  void take_frames() {
    can::Frame frame;
    constexpr int kMost = static_cast<int>(msgcontroller::TransmitQueue::kCapacity);
    int frames = 0;
    for (; frames <= kMost && controller_.take_frame(frame); ++frames) {
      const auto identified = profile().identify(frame.id);
      require(identified && can::layout(identified->kind).sender == can::Sender::message_controller,
              "it sends only what is its own to send");
      require(decodes(profile(), frame), "what it sends decodes");
      if (const auto trim = can::decode_trim(profile(), frame)) {
        check_trim(*trim);
      }
    }
    require(frames <= kMost, "its queue is bounded");
    require(controller_.health().queue_full == 0, "its queue has room for all that it sends");
  }

  void check_trim(const can::Trim& trim) const {
    for (std::size_t channel = 0; channel < trim.count.size(); ++channel) {
      require(trim.count[channel] <= 0 || may_be_positive_[channel], "nobody asked for a positive trim here");
      require(trim.count[channel] >= 0 || may_be_negative_[channel], "nobody asked for a negative trim here");
    }
  }

  const urdf::RobotModel& robot_;
  MemoryBlock block_;
  Client client_;
  EmiAdapter adapter_;
  msgcontroller::MessageController controller_;
  std::unique_ptr<HandOver> hand_over_;
  std::int64_t now_ns_ = 0;
  std::uint64_t mails_ = 0, answers_ = 0;
  bool stopped_ = false;
  bool release_asked_ = false;
  std::array<bool, kTrimChannels> may_be_positive_{}, may_be_negative_{};
};

}  // namespace

void message_controller(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  Controller controller(robot(input.flag()));
  constexpr int kMostActions = 200;
  for (int action = 0; action < kMostActions && !input.empty(); ++action) {
    switch (input.choose(8)) {
      case 0:
        controller.receive(take_frame(input));
        break;
      case 1:
        controller.on_bus_state(input);
        break;
      case 2:
        controller.post_hand_over(input);
        break;
      case 3:
        controller.post_user_command(input);
        break;
      case 4:
        controller.post_trim(input);
        break;
      case 5:
        controller.receive(
            take_known_frame(input, controller.profile(), static_cast<can::NodeId>(1 + input.choose(22))));
        break;
      default:
        controller.step(1 + input.choose(40));
    }
  }
  controller.check_that_all_is_answered();
}

}  // namespace gaitway::fuzz

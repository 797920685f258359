// The message controller's side of the EMI.
// "model: NAME.N" names a step of the models in tests/models.
#include <algorithm>

#include "emi_window.hpp"

namespace gaitway::msgclient {

EmiMessage::EmiMessage(Client& client)
    : window_(std::make_unique<EmiWindow>(client, Role::reader, Role::writer)) {}
EmiMessage::~EmiMessage() = default;
EmiMessage::EmiMessage(EmiMessage&&) noexcept = default;
EmiMessage& EmiMessage::operator=(EmiMessage&&) noexcept = default;

std::span<const std::uint32_t> EmiMessage::fetch(MailKind mail, std::int64_t now_ns) noexcept {
  HostRegion& host = window_->host();
  // model: fetch.1
  if (const std::uint64_t rings = host.rings.load(std::memory_order_acquire); rings != rings_seen_) {
    rings_seen_ = rings;
    for (std::size_t kind = 0; kind < kMailKinds; ++kind) {
      // model: fetch.2
      announced_[kind] = host.mailbox[kind].posted.load(std::memory_order_acquire);
    }
  }
  const auto kind = static_cast<std::size_t>(mail);
  HostRegion::Mailbox& box = host.mailbox[kind];
  SharedWord& taken = window_->message().taken[kind];
  if (announced_[kind] == taken.load(std::memory_order_relaxed) ||
      now_ns < static_cast<std::int64_t>(box.ready_ns.load(std::memory_order_relaxed))) {
    return {};
  }
  // A length beyond the mailbox can only come from a host that has gone mad; what is read then fails its
  // checksum.
  // model: fetch.3
  const std::size_t length =
      std::clamp<std::size_t>(box.length.load(std::memory_order_relaxed), 1, kMailboxWords[kind]);
  const WindowWord* const words = host.words(mail);
  for (std::size_t i = 0; i < length; ++i) {
    // model: fetch.4
    window_->staging[i] = words[i].load(std::memory_order_relaxed);
  }
  // model: fetch.5
  taken.store(announced_[kind], std::memory_order_release);
  return std::span<const std::uint32_t>(window_->staging).first(length);
}

TakeStatus EmiMessage::damaged(MailKind mail, std::uint32_t sequence) noexcept {
  ++corrupt_;
  if (mail != MailKind::trim) {
    (void)answer({mail, sequence, Verdict::corrupt, Reason::checksum});
  }
  return TakeStatus::corrupt;
}

bool EmiMessage::answers_full() const noexcept {
  // model: answer.1
  return window_->message().answers_posted.load(std::memory_order_relaxed) -
             window_->host().answers_taken.load(std::memory_order_acquire) >=
         kAnswerSlots;
}

TakeStatus EmiMessage::take_hand_over(HandOver& hand_over, std::int64_t now_ns) noexcept {
  if (answers_full()) {
    return TakeStatus::none;
  }
  const auto words = fetch(MailKind::hand_over, now_ns);
  if (words.empty()) {
    return TakeStatus::none;
  }
  return decode(words, hand_over) == DecodeStatus::whole ? TakeStatus::mail
                                                         : damaged(MailKind::hand_over, hand_over.sequence);
}

TakeStatus EmiMessage::take_trim(TrimUpdate& trim, std::int64_t now_ns) noexcept {
  const auto words = fetch(MailKind::trim, now_ns);
  if (words.empty()) {
    return TakeStatus::none;
  }
  return unpack(words, trim) ? TakeStatus::mail : damaged(MailKind::trim, 0);
}

TakeStatus EmiMessage::take_user_command(UserCommandMail& command, std::int64_t now_ns) noexcept {
  // Not held back by answers that lie there: a stop must come through. A damaged one may then go unanswered,
  // and is counted.
  const auto words = fetch(MailKind::user_command, now_ns);
  if (words.empty()) {
    return TakeStatus::none;
  }
  return unpack(words, command) ? TakeStatus::mail : damaged(MailKind::user_command, command.sequence);
}

bool EmiMessage::answer(const Answer& answer) noexcept {
  if (answers_full()) {
    return false;
  }
  MessageRegion& message = window_->message();
  const auto words = pack(answer);
  auto& slot = message.answers[message.answers_posted.load(std::memory_order_relaxed) % kAnswerSlots];
  for (std::size_t i = 0; i < words.size(); ++i) {
    // model: answer.2
    slot[i].store(words[i], std::memory_order_relaxed);
  }
  // model: answer.3
  count_up(message.answers_posted);
  // model: answer.4
  ring_doorbell(message.rings, faults_);
  return true;
}

}  // namespace gaitway::msgclient

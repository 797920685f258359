// The main controller's side of the EMI: every access is charged.
// "model: NAME.N" names a step of the models in tests/models.
#include <algorithm>
#include <utility>

#include "emi_window.hpp"

namespace gaitway::msgclient {
namespace {

constexpr std::uint64_t kMailOverheadWords = 4;  // taken count, length, posted count, doorbell
constexpr std::uint64_t kOccupiedWords = 2;      // taken count, doorbell

}  // namespace

EmiHost::EmiHost(Client& client, const EmiTiming& timing)
    : timing_(timing), window_(std::make_unique<EmiWindow>(client, Role::writer, Role::reader)) {
  if (timing.clock_hz <= 0 || timing.setup_cycles < 0 || timing.strobe_cycles < 1 || timing.hold_cycles < 0) {
    throw TopicError(
        "EMI timing: the clock must be above 0 Hz, strobe at least 1 cycle, set-up and hold at least 0");
  }
}
EmiHost::~EmiHost() = default;
EmiHost::EmiHost(EmiHost&&) noexcept = default;
EmiHost& EmiHost::operator=(EmiHost&&) noexcept = default;

std::int64_t EmiHost::charge(std::uint64_t words, std::int64_t now_ns) noexcept {
  const std::int64_t duration = timing_.transfer_ns(words);
  statistics_.words += words;
  statistics_.busy_ns += duration;
  bus_free_ns_ = std::max(bus_free_ns_, now_ns) + duration;
  return bus_free_ns_ - now_ns;
}

PostResult EmiHost::post_words(MailKind mail, std::span<const std::uint32_t> words,
                               std::int64_t now_ns) noexcept {
  if (faults_.bus_stuck) {
    ++statistics_.stuck;
    return {PostStatus::bus_stuck, 0};
  }
  HostRegion& host = window_->host();
  HostRegion::Mailbox& box = host.mailbox[static_cast<std::size_t>(mail)];
  // model: post.1
  const std::uint64_t taken =
      window_->message().taken[static_cast<std::size_t>(mail)].load(std::memory_order_acquire);
  if (box.posted.load(std::memory_order_relaxed) != taken) {
    ++statistics_.occupied;
    // model: post.2
    ring_doorbell(host.rings, faults_);
    return {PostStatus::occupied, charge(kOccupiedWords, now_ns)};
  }
  WindowWord* const target = host.words(mail);
  for (std::size_t i = 0; i < words.size(); ++i) {
    // model: post.3
    target[i].store(words[i], std::memory_order_relaxed);
  }
  if (faults_.flip_next && faults_.flip_next->mail == mail) {
    const std::size_t word = faults_.flip_next->word % words.size();
    target[word].store(words[word] ^ faults_.flip_next->mask, std::memory_order_relaxed);
    faults_.flip_next.reset();
  }
  const std::int64_t delay_ns = mail == MailKind::hand_over ? std::exchange(faults_.delay_next_ns, 0) : 0;
  const std::int64_t transfer = charge(words.size() + kMailOverheadWords, now_ns) + delay_ns;
  // model: post.4
  box.length.store(words.size(), std::memory_order_relaxed);
  box.ready_ns.store(static_cast<std::uint64_t>(now_ns + transfer), std::memory_order_relaxed);
  // model: post.5
  count_up(box.posted);
  // model: post.6
  ring_doorbell(host.rings, faults_);
  ++statistics_.posted;
  return {PostStatus::posted, transfer};
}

PostResult EmiHost::post(const HandOver& hand_over, std::int64_t now_ns) noexcept {
  const std::size_t words = encode(hand_over, window_->staging);
  if (words == 0) {
    return {PostStatus::invalid, 0};
  }
  return post_words(MailKind::hand_over, std::span<const std::uint32_t>(window_->staging).first(words),
                    now_ns);
}

PostResult EmiHost::post(const TrimUpdate& trim, std::int64_t now_ns) noexcept {
  if (trim.channel_count > kTrimChannels) {
    return {PostStatus::invalid, 0};
  }
  return post_words(MailKind::trim, pack(trim), now_ns);
}

PostResult EmiHost::post(const UserCommandMail& command, std::int64_t now_ns) noexcept {
  return post_words(MailKind::user_command, pack(command), now_ns);
}

std::optional<Answer> EmiHost::take_answer(std::int64_t now_ns) noexcept {
  if (faults_.bus_stuck) {
    ++statistics_.stuck;
    return std::nullopt;
  }
  MessageRegion& message = window_->message();
  charge(1, now_ns);
  // model: take_answer.1
  if (const std::uint64_t rings = message.rings.load(std::memory_order_acquire); rings != rings_seen_) {
    rings_seen_ = rings;
    // model: take_answer.2
    answers_announced_ = message.answers_posted.load(std::memory_order_acquire);
  }
  HostRegion& host = window_->host();
  const std::uint64_t taken = host.answers_taken.load(std::memory_order_relaxed);
  if (taken == answers_announced_) {
    return std::nullopt;
  }
  if (answers_announced_ - taken > kAnswerSlots) {
    // More than there is room for, or less than were taken: the other side's count is broken.
    ++statistics_.corrupt_answers;
    host.answers_taken.store(answers_announced_, std::memory_order_release);
    return std::nullopt;
  }
  std::array<std::uint32_t, kAnswerWords> words{};
  const auto& slot = message.answers[taken % kAnswerSlots];
  for (std::size_t i = 0; i < words.size(); ++i) {
    // model: take_answer.3
    words[i] = slot[i].load(std::memory_order_relaxed);
  }
  charge(words.size() + 1, now_ns);
  // model: take_answer.4
  count_up(host.answers_taken);
  Answer answer;
  if (!unpack(words, answer)) {
    ++statistics_.corrupt_answers;
    return std::nullopt;
  }
  return answer;
}

std::optional<std::int64_t> EmiHost::charge_read(std::size_t bytes, std::int64_t now_ns) noexcept {
  if (faults_.bus_stuck) {
    ++statistics_.stuck;
    return std::nullopt;
  }
  return charge((bytes + 3) / 4, now_ns);
}

}  // namespace gaitway::msgclient

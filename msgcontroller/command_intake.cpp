// Commands in, answers out.
#include "gaitway/msgcontroller/command_intake.hpp"

namespace gaitway::msgcontroller {
namespace {

using Kind = msgclient::UserCommandKind;
using msgclient::Reason;

constexpr int kCommandsAMillisecond = 32;  // more than the queue holds: bounds the work, loses nothing

}  // namespace

CommandIntake::CommandIntake(msgclient::Client& client, msgclient::EmiMessage& adapter)
    : adapter_(adapter),
      commands_(client.read_queue<UserCommand>("user_command")),
      command_answers_(client.write_stream<UserCommandAnswer>("user_command_answer")),
      stop_requests_(client.read<StopRequest>("stop_request")),
      stop_answers_(client.write<StopRequest>("stop_answer")) {}

void CommandIntake::take_topics(CommandTaker& taker, std::int64_t now_ns) noexcept {
  take_queue(taker, now_ns);
  take_stops(taker, now_ns);
}

Reason CommandIntake::obey(CommandTaker& taker, const msgclient::UserCommandMail& mail,
                           std::int64_t now_ns) noexcept {
  const Reason problem = taker.obey(mail, now_ns);
  if (problem == Reason::none && listener_ != nullptr) listener_->on_command(mail.kind, now_ns);
  return problem;
}

void CommandIntake::take_mail(CommandTaker& taker, std::int64_t now_ns) noexcept {
  msgclient::UserCommandMail mail;
  if (adapter_.take_user_command(mail, now_ns) != msgclient::TakeStatus::mail) {
    return;
  }
  const Reason problem = obey(taker, mail, now_ns);
  if (mail.kind == Kind::release && problem == Reason::none) {
    answer_release(Reason::emergency_stopped, now_ns);  // a stop has ended the one before
    release_mail_ = mail.sequence;
  } else {
    answer_mail(mail.sequence, problem);
  }
}

void CommandIntake::take_queue(CommandTaker& taker, std::int64_t now_ns) noexcept {
  UserCommand command;
  for (int i = 0; i < kCommandsAMillisecond && commands_.pop(command); ++i) {
    const auto kind = static_cast<Kind>(command.kind);
    const Reason problem = obey(taker,
                                {.sequence = command.number,
                                 .kind = kind,
                                 .joint = command.joint,
                                 .position = static_cast<float>(command.position),
                                 .duration_slots = command.duration_slots},
                                now_ns);
    if (kind == Kind::release && problem == Reason::none) {
      ++releases_taken_;
      answer_release(Reason::emergency_stopped, now_ns);  // a stop has ended the one before
      release_command_ = command;
    } else {
      answer_command(command, problem, now_ns);
    }
  }
}

void CommandIntake::take_stops(CommandTaker& taker, std::int64_t now_ns) noexcept {
  if (stop_requests_.newest_sequence() == stop_request_seen_) {
    return;
  }
  StopRequest asked;
  const msgclient::ReadResult read = stop_requests_.read(asked);
  if (!read) {
    return;  // a newer one is being written: in the next millisecond
  }
  stop_request_seen_ = read.sequence;
  const bool soft = asked.softs != stops_obeyed_.softs;
  if (soft || asked.holds != stops_obeyed_.holds) {
    taker.obey({.kind = soft ? Kind::emergency_stop_soft : Kind::emergency_stop_hold}, now_ns);
  }
  if (asked.stops != stops_obeyed_.stops) {
    taker.obey({.kind = Kind::stop}, now_ns);
  }
  stops_obeyed_ = asked;
  stop_answers_.publish(stops_obeyed_, now_ns);
}

void CommandIntake::answer_release(Reason problem, std::int64_t now_ns) noexcept {
  if (release_mail_) {
    answer_mail(*release_mail_, problem);
  }
  if (release_command_) {
    answer_command(*release_command_, problem, now_ns);
  }
  release_mail_.reset();
  release_command_.reset();
}

// Whoever reads no answers has others to worry about than this one.
void CommandIntake::answer_mail(std::uint32_t sequence, Reason problem) noexcept {
  static_cast<void>(adapter_.answer(
      {.mail = msgclient::MailKind::user_command,
       .sequence = sequence,
       .verdict = problem == Reason::none ? msgclient::Verdict::accepted : msgclient::Verdict::refused,
       .reason = problem}));
}

void CommandIntake::answer_command(const UserCommand& command, Reason problem, std::int64_t now_ns) noexcept {
  UserCommandAnswer answer{};
  answer.number = command.number;
  answer.reason = static_cast<std::uint32_t>(problem);
  answer.command = command.kind;
  answer.joint = command.joint;
  answer.duration_slots = command.duration_slots;
  answer.position = command.position;
  command_answers_.publish(answer, now_ns);
}

}  // namespace gaitway::msgcontroller

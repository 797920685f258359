// People's commands, whichever way they come: through the mailbox, the queue `user_command` and, for stops,
// the topic `stop_request`. Each is answered the way that it came.
#pragma once

#include <cstdint>
#include <optional>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

// Who carries commands out.
class CommandTaker {
 public:
  // Reason::none: done, or of a release: begun, and CommandIntake::answer_release() tells how it ended.
  virtual msgclient::Reason obey(const msgclient::UserCommandMail& mail, std::int64_t now_ns) noexcept = 0;

 protected:
  ~CommandTaker() = default;
};

// Who wants to know what has been carried out, of what came through mailbox and queue: a stop's topic
// everybody can read.
class CommandListener {
 public:
  virtual void on_command(msgclient::UserCommandKind kind, std::int64_t now_ns) noexcept = 0;

 protected:
  ~CommandListener() = default;
};

class CommandIntake {
 public:
  CommandIntake(msgclient::Client& client, msgclient::EmiMessage& adapter);

  // nullptr: nobody wants to know.
  void tell(CommandListener* listener) noexcept { listener_ = listener; }

  // What the main controller posts; whenever its doorbell rings.
  void take_mail(CommandTaker& taker, std::int64_t now_ns) noexcept;
  // What lies in the topics: once a millisecond and never between two, so that a command's millisecond is all
  // that one has to know to give it again. Stops come last, so that they have the last word.
  void take_topics(CommandTaker& taker, std::int64_t now_ns) noexcept;
  // Releases out of the queue that have begun, whatever becomes of them.
  [[nodiscard]] std::uint64_t releases_taken() const noexcept { return releases_taken_; }
  void answer_release(msgclient::Reason problem, std::int64_t now_ns) noexcept;

 private:
  void take_queue(CommandTaker& taker, std::int64_t now_ns) noexcept;
  void take_stops(CommandTaker& taker, std::int64_t now_ns) noexcept;
  void answer_mail(std::uint32_t sequence, msgclient::Reason problem) noexcept;
  void answer_command(const UserCommand& command, msgclient::Reason problem, std::int64_t now_ns) noexcept;

  msgclient::Reason obey(CommandTaker& taker, const msgclient::UserCommandMail& mail,
                         std::int64_t now_ns) noexcept;

  msgclient::EmiMessage& adapter_;
  CommandListener* listener_ = nullptr;
  msgclient::QueueReader<UserCommand> commands_;
  msgclient::Writer<UserCommandAnswer> command_answers_;
  msgclient::Reader<StopRequest> stop_requests_;
  msgclient::Writer<StopRequest> stop_answers_;
  std::uint64_t stop_request_seen_ = 0;
  StopRequest stops_obeyed_{};
  std::optional<UserCommand> release_command_;  // that has no answer yet
  std::optional<std::uint32_t> release_mail_;   // likewise: its sequence
  std::uint64_t releases_taken_ = 0;
};

}  // namespace gaitway::msgcontroller

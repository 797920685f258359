// Who commands the robot: one connection at a time, by a lease that it keeps alive. Passive: told the time.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gaitway::api {

// A command that its sender may not give now; says why and what would help.
class CommandDenied : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// One connection, as the authority knows it.
struct Claimant {
  std::uint64_t number = 0;                // never 0, never given twice
  std::string name;                        // for people: its address, or as it calls itself
  std::uint64_t stops_seen = 0;            // up to which it may take the command without asking for it
  std::uint64_t absences_seen = 0;         // of the robot, likewise
  std::optional<std::int64_t> tried_ns{};  // its latest command, granted or not
  std::int64_t age_ns = 0;                 // so long ago, at most, it sent what is carried out now
  bool overtaken = false;                  // what it asks for was sent before a stop that it has called since
};

// The lease is bound to its connection: its id is worth nothing on another one. It ends when neither a
// command nor a keep-alive has come for its whole length, when the connection ends, when it is given back, or
// when somebody else stops the robot.
//
// After a stop, who was driving (or trying to) must let go first: as long as its commands keep coming without
// a pause of the lease's length, they are refused, unless it asks for the command by acquire(). So a stick
// that is still held does not undo a stop. Who called the stop, and who connects later, is not concerned.
class Authority {
 public:
  explicit Authority(std::int64_t lease_ns) noexcept : lease_ns_(lease_ns) {}

  // Takes the command, or renews it, and gives the lease's id. Throws CommandDenied while another has it.
  std::string acquire(Claimant& claimant, std::int64_t now_ns);
  // A command comes: allowed for the holder, whose lease it renews, and for anybody while the command is
  // free, who then holds it. Throws CommandDenied.
  void use(Claimant& claimant, std::int64_t now_ns);
  // Throws CommandDenied when the lease is not this connection's.
  void keep_alive(const Claimant& claimant, std::string_view lease, std::int64_t now_ns);
  // As keep_alive(); nobody has the command then.
  void release(const Claimant& claimant, std::string_view lease, std::int64_t now_ns);

  // The connection has ended. True: it had the command.
  bool leave(const Claimant& claimant) noexcept;
  // Somebody has stopped the robot: nobody else commands it any more.
  void stop(Claimant& by) noexcept;
  // No claimant of ours stopped it: nobody commands it any more.
  void end_all() noexcept;
  // The way to the robot was lost: nobody commands it any more.
  void lose_all() noexcept;
  // True: a lease has run out since this was asked last.
  bool lapse(std::int64_t now_ns) noexcept;

  [[nodiscard]] bool held_by(const Claimant& claimant) const noexcept;
  // Name of who commands; empty: nobody.
  [[nodiscard]] std::string_view holder() const noexcept;
  // So many stops and absences of the robot so far.
  [[nodiscard]] std::uint64_t stops() const noexcept { return stops_ + absences_; }
  // Of all of them, as of a claimant that is new.
  void see_all(Claimant& claimant) const noexcept;

 private:
  struct Lease {
    std::uint64_t claimant = 0;
    std::string name, id;
    std::int64_t ends_ns = 0;
  };
  void require_free_for(const Claimant& claimant) const;
  void expire(std::int64_t now_ns) noexcept;
  void grant(const Claimant& claimant, std::int64_t now_ns);
  void require(const Claimant& claimant, std::string_view lease, std::int64_t now_ns);

  std::int64_t lease_ns_;
  std::optional<Lease> lease_;
  bool lapsed_ = false;
  std::uint64_t stops_ = 0, absences_ = 0;
};

}  // namespace gaitway::api

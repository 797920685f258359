// Whether the two ends know each other: who they are, since when, and until when.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/link/link_settings.hpp"
#include "gaitway/link/messages.hpp"

namespace gaitway::link {

// What an end says of itself.
struct LinkIdentity {
  Role role = Role::module;
  std::uint64_t boot = 0;        // random and not 0: no two runs have the same
  std::uint32_t table_hash = 0;  // of the channels and orders: both ends must have been built with the same
  std::string_view name;         // of its software, process or robot; the first 24 bytes are told
  std::uint32_t robot_hash = 0;  // of the robot's description: both ends must have the same
  std::uint16_t calibration_hash = 0;  // of the robot's calibration: told, and nothing depends on it
};

// For LinkIdentity::boot: random and not 0.
[[nodiscard]] std::uint64_t random_boot();

// Why there is no session (any more).
enum class SessionEnd : std::uint8_t {
  none,           // it goes on
  not_begun,      // nobody was heard yet
  silence,        // nothing came for `silence_ns`
  cut,            // the carrier has nobody at its other end
  peer_anew,      // the other end was started again, or has ended the session
  wrong_version,  // the other end speaks another version of the protocol
  wrong_role,     // it has this end's own role: two modules, or two controllers
  wrong_table,    // it knows other channels or orders
  wrong_robot,    // it has another robot's description
  occupied        // the controller has a session with another module
};

// Whether it lasts until somebody does something about it; the others end by themselves.
[[nodiscard]] constexpr bool is_refusal(SessionEnd why) noexcept {
  return why >= SessionEnd::wrong_version;
}

//             hello that has heard this end
//   closed ───────────────────────────────► open
//     ▲  every hello_period_ns: hello         │ silence, cut, or a hello of another run or session of the
//     └───────────────────────────────────────┘ peer: the own session count rises, so that no frame of the
//                                               old session is taken any more
class Session {
 public:
  // Throws std::invalid_argument when boot is 0.
  Session(const LinkIdentity& identity, const LinkSettings& settings);

  // Ends a session that has been silent for too long.
  void step(std::int64_t now_ns) noexcept;
  void on_hello(const Hello& hello, std::int64_t now_ns) noexcept;
  // One that only its own version can read.
  void on_hello_of_version(std::uint16_t version) noexcept;
  // True: this frame belongs to the session, which it keeps alive.
  bool admits(std::uint32_t session, std::int64_t now_ns) noexcept;
  // Who was refused and is then cut off, was refused.
  void end(SessionEnd why) noexcept;

  [[nodiscard]] bool hello_due(std::int64_t now_ns) const noexcept;
  [[nodiscard]] Hello hello(std::int64_t now_ns) noexcept;  // counts as sent

  [[nodiscard]] bool open() const noexcept { return end_ == SessionEnd::none; }
  // In every frame of the session: the CRC-32 of both identities. Sessions that follow each other differ in
  // few neighbouring bits of these, which a CRC never maps to the same.
  [[nodiscard]] std::uint32_t tag() const noexcept { return tag_; }
  // How many sessions this end has begun.
  [[nodiscard]] std::uint32_t count() const noexcept { return begun_; }
  [[nodiscard]] std::uint64_t peer_boot() const noexcept { return peer_.boot; }
  [[nodiscard]] std::uint16_t peer_calibration_hash() const noexcept { return peer_calibration_hash_; }
  // As it calls itself, for people: printable.
  [[nodiscard]] std::string peer_name() const;
  [[nodiscard]] SessionEnd why() const noexcept { return end_; }
  // How many hellos were refused: whoever is refused and still there says one after the other.
  [[nodiscard]] std::uint32_t refusals() const noexcept { return refusals_; }
  // For a module that comes while the controller has a session with another one: what refuses it, with the
  // other one's name in the place of the own.
  [[nodiscard]] Hello refusal_of_another() const noexcept;
  // Whole frames that belonged to no session of now.
  [[nodiscard]] std::uint64_t strangers() const noexcept { return strangers_; }
  // Why there is no session, for people: what, both sides' values, remedy. Allocates.
  [[nodiscard]] std::string description() const;

 private:
  // The controller has a session with another module than this one.
  [[nodiscard]] bool has_another(const Hello& hello) const noexcept;
  [[nodiscard]] SessionEnd refusal_of(const Hello& hello) const noexcept;
  void begin(std::int64_t now_ns) noexcept;

  Hello self_;
  Identity peer_;
  std::array<char, 24> peer_name_{};
  std::uint16_t peer_calibration_hash_ = 0;
  Hello refused_;  // the last hello that did not fit
  std::int64_t hello_period_ns_, silence_ns_;
  SessionEnd end_ = SessionEnd::not_begun;
  std::uint32_t tag_ = 0, begun_ = 0, refusals_ = 0;
  std::int64_t heard_ns_ = 0;
  std::optional<std::int64_t> hello_sent_ns_;
  bool hello_wanted_ = true;
  std::uint64_t strangers_ = 0;
};

}  // namespace gaitway::link

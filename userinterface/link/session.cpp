// A hello carries both identities, so each end knows that the other means it, in this run and this session.
#include "gaitway/link/session.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <span>
#include <stdexcept>

#include "gaitway/link/byte_order.hpp"
#include "gaitway/process/crc32.hpp"

namespace gaitway::link {
namespace {

// The same at both ends: the module first.
std::uint32_t tag_of(const Identity& module, const Identity& controller) noexcept {
  std::array<std::uint8_t, 24> bytes{};
  ByteWriter(bytes).put(module.boot).put(module.sessions).put(controller.boot).put(controller.sessions);
  return process::crc32(std::as_bytes(std::span(bytes)));
}

std::string printable(const std::array<char, 24>& bytes) {
  const auto end = std::ranges::find(bytes, '\0');
  std::string name(bytes.begin(), end);
  std::ranges::replace_if(
      name, [](char letter) { return letter < ' ' || letter > '~'; }, '?');
  return name;
}

std::string hex(std::uint32_t number) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(2 * sizeof number, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, number >>= 4U) {
    *digit = kDigits[number & 0xFU];
  }
  return text;
}

std::string name_of(const Hello& hello) {
  return "'" + printable(hello.name) + "'";
}

// What is wrong with who was refused, and what to do about it.
std::string refusal_text(SessionEnd why, const Hello& self, const Hello& other) {
  switch (why) {
    case SessionEnd::occupied:
      return "refused: the main controller is linked to another module, " + name_of(other) +
             ", and a robot has one: end that one, or this one, " + name_of(self);
    case SessionEnd::wrong_version:
      return "refused: the other end speaks version " + std::to_string(other.version) +
             " of the link's protocol, and " + name_of(self) + " version " + std::to_string(self.version) +
             ": install the same version of Gaitway on both sides";
    case SessionEnd::wrong_role:
      return "refused: " + name_of(self) + " and the other end, " + name_of(other) + ", are both " +
             (self.role == Role::module ? "modules" : "controllers") +
             ": connect one module to one controller";
    case SessionEnd::wrong_table:
      return "refused: " + name_of(self) + " has the table of topics and orders " + hex(self.table_hash) +
             ", the other end, " + name_of(other) + ", has " + hex(other.table_hash) +
             ": they were built from different sources; install the same version of Gaitway on both sides";
    default:
      return "refused: " + name_of(self) + " has the robot's description " + hex(self.robot_hash) +
             ", the other end, " + name_of(other) + ", has " + hex(other.robot_hash) +
             ": give both the same robot.urdf and robot.yaml (--robot), and start the one anew that gets "
             "others";
  }
}

}  // namespace

std::uint64_t random_boot() {
  std::random_device random;
  const std::uint64_t high = random();
  return (high << 32U | random()) | 1U;
}

void check(const LinkSettings& settings) {
  const auto require = [](bool holds, const char* rule) {
    if (!holds) throw std::invalid_argument(std::string("link settings: ") + rule);
  };
  require(settings.hello_period_ns > 0, "hello_period_ns must be above 0");
  require(settings.status_period_ns > 0, "status_period_ns must be above 0");
  require(settings.silence_ns > settings.status_period_ns,
          "silence_ns must be longer than status_period_ns, else every pause ends the session");
  require(settings.resend_after_ns > 0, "resend_after_ns must be above 0");
  require(settings.stop_repeat_ns > 0, "stop_repeat_ns must be above 0");
  require(settings.answer_limit_ns >= 0, "answer_limit_ns must not be negative");
  require(settings.fragment_bytes >= 8 && settings.fragment_bytes <= kMostFragmentBytes,
          "fragment_bytes must be 8 to kMostFragmentBytes");
  require(settings.state_window >= 1 && settings.state_window <= kMostStateWindow,
          "state_window must be 1 to kMostStateWindow");
}

Session::Session(const LinkIdentity& identity, const LinkSettings& settings)
    : hello_period_ns_(settings.hello_period_ns), silence_ns_(settings.silence_ns) {
  check(settings);
  if (identity.boot == 0) {
    throw std::invalid_argument("link identity: boot must be random and not 0");
  }
  self_.role = identity.role;
  self_.self.boot = identity.boot;
  self_.table_hash = identity.table_hash;
  self_.robot_hash = identity.robot_hash;
  self_.calibration_hash = identity.calibration_hash;
  std::copy_n(identity.name.begin(), std::min(identity.name.size(), self_.name.size()), self_.name.begin());
}

void Session::step(std::int64_t now_ns) noexcept {
  if (open() && now_ns - heard_ns_ >= silence_ns_) {
    end(SessionEnd::silence);
  }
}

void Session::on_hello(const Hello& hello, std::int64_t now_ns) noexcept {
  if (const SessionEnd refusal = refusal_of(hello); refusal != SessionEnd::none) {
    ++refusals_;
    refused_ = hello;  // which bears that one's name, if it has a session with another
    end(has_another(hello) ? SessionEnd::occupied : refusal);
    return;
  }
  if (open() && hello.self != peer_) {
    end(SessionEnd::peer_anew);
  }
  if (!open() && has_another(hello)) {
    refused_ = hello;  // or it has not heard yet that this module was started anew
    end_ = SessionEnd::occupied;
  }
  peer_ = hello.self;
  peer_name_ = hello.name;
  peer_calibration_hash_ = hello.calibration_hash;
  const bool means_this = hello.heard == self_.self;
  if (!open() && means_this) {
    begin(now_ns);
  } else if (open() && means_this) {
    heard_ns_ = now_ns;
  }
  hello_wanted_ = hello_wanted_ || !hello.open || !means_this;
}

void Session::on_hello_of_version(std::uint16_t version) noexcept {
  ++refusals_;
  refused_ = {};
  refused_.version = version;
  end(SessionEnd::wrong_version);
}

bool Session::admits(std::uint32_t session, std::int64_t now_ns) noexcept {
  if (open() && session == tag_) {
    heard_ns_ = now_ns;
    return true;
  }
  ++strangers_;
  hello_wanted_ = hello_wanted_ || !open();  // who sends it believes in a session that this end does not have
  return false;
}

void Session::end(SessionEnd why) noexcept {
  if (why == SessionEnd::cut && is_refusal(end_)) {
    return;
  }
  if (open()) {
    ++self_.self.sessions;
    peer_ = {};
    hello_wanted_ = true;
  }
  end_ = why;
}

void Session::begin(std::int64_t now_ns) noexcept {
  const bool module = self_.role == Role::module;
  tag_ = module ? tag_of(self_.self, peer_) : tag_of(peer_, self_.self);
  end_ = SessionEnd::none;
  heard_ns_ = now_ns;
  ++begun_;
}

bool Session::has_another(const Hello& hello) const noexcept {
  return self_.role == Role::module && hello.role == Role::controller && hello.open &&
         hello.heard.boot != self_.self.boot;
}

SessionEnd Session::refusal_of(const Hello& hello) const noexcept {
  if (hello.role == self_.role) return SessionEnd::wrong_role;
  if (hello.table_hash != self_.table_hash) return SessionEnd::wrong_table;
  return hello.robot_hash == self_.robot_hash ? SessionEnd::none : SessionEnd::wrong_robot;
}

bool Session::hello_due(std::int64_t now_ns) const noexcept {
  // Also what is wanted at once keeps half a period: two ends that do not agree must not fill the carrier.
  const std::int64_t pause_ns = hello_wanted_ ? hello_period_ns_ / 2 : hello_period_ns_;
  return (hello_wanted_ || !open()) && (!hello_sent_ns_ || now_ns - *hello_sent_ns_ >= pause_ns);
}

Hello Session::hello(std::int64_t now_ns) noexcept {
  hello_sent_ns_ = now_ns;
  hello_wanted_ = false;
  Hello hello = self_;
  hello.open = open();
  hello.heard = peer_;
  hello.time_ns = now_ns;
  return hello;
}

Hello Session::refusal_of_another() const noexcept {
  Hello hello = self_;
  hello.open = true;
  hello.heard = peer_;
  hello.name = peer_name_;
  return hello;
}

std::string Session::peer_name() const {
  return printable(peer_name_);
}

std::string Session::description() const {
  switch (end_) {
    case SessionEnd::none:
      return "the session goes on";
    case SessionEnd::not_begun:
      return "nobody was heard yet";
    case SessionEnd::silence:
      return "nothing came for " + std::to_string(silence_ns_ / facts::kMillisecond_ns) + " ms";
    case SessionEnd::cut:
      return "the other end has closed the connection";
    case SessionEnd::peer_anew:
      return "the other end has begun anew";
    default:
      return refusal_text(end_, self_, refused_);
  }
}

}  // namespace gaitway::link

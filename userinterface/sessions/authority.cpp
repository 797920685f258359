#include "gaitway/api/authority.hpp"

#include <openssl/crypto.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace gaitway::api {
namespace {

// 32 hexadecimal digits that nobody can foresee. Throws std::system_error when the system gives no random
// bytes.
std::string random_id() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::system_error(errno, std::generic_category(), "no random bytes for a lease");
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string id;
  for (const unsigned char byte : bytes) {
    id += kDigits[byte >> 4U];
    id += kDigits[byte & 15U];
  }
  return id;
}

// Takes the same time wherever the two differ. Their length is no secret.
bool same_id(std::string_view a, std::string_view b) noexcept {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace

void Authority::require_free_for(const Claimant& claimant) const {
  if (lease_ && !held_by(claimant)) {
    throw CommandDenied("\"" + lease_->name +
                        "\" has the command: wait until it is given back, or stop the robot");
  }
}

std::string Authority::acquire(Claimant& claimant, std::int64_t now_ns) {
  expire(now_ns);
  require_free_for(claimant);
  claimant.tried_ns = now_ns;
  see_all(claimant);
  grant(claimant, now_ns);
  return lease_->id;
}

void Authority::use(Claimant& claimant, std::int64_t now_ns) {
  expire(now_ns);
  const bool let_go = !claimant.tried_ns || now_ns - *claimant.tried_ns >= lease_ns_;
  claimant.tried_ns = now_ns;
  require_free_for(claimant);
  if (!let_go && claimant.stops_seen != stops_) {
    throw CommandDenied(
        "the robot was stopped by somebody else: let go for a while, or call /command/acquire, to go on");
  }
  if (!let_go && claimant.absences_seen != absences_) {
    throw CommandDenied(
        "the robot was not there for a while: let go for a while, or call /command/acquire, to go on");
  }
  see_all(claimant);
  grant(claimant, now_ns);
}

void Authority::keep_alive(const Claimant& claimant, std::string_view lease, std::int64_t now_ns) {
  require(claimant, lease, now_ns);
  grant(claimant, now_ns);
}

void Authority::release(const Claimant& claimant, std::string_view lease, std::int64_t now_ns) {
  require(claimant, lease, now_ns);
  lease_.reset();
}

bool Authority::leave(const Claimant& claimant) noexcept {
  const bool held = held_by(claimant);
  if (held) {
    lease_.reset();
  }
  return held;
}

void Authority::stop(Claimant& by) noexcept {
  ++stops_;
  see_all(by);
  if (!held_by(by)) {
    lease_.reset();
  }
}

void Authority::end_all() noexcept {
  ++stops_;
  lease_.reset();
}

void Authority::lose_all() noexcept {
  ++absences_;
  lease_.reset();
}

void Authority::see_all(Claimant& claimant) const noexcept {
  claimant.stops_seen = stops_;
  claimant.absences_seen = absences_;
}

bool Authority::lapse(std::int64_t now_ns) noexcept {
  expire(now_ns);
  return std::exchange(lapsed_, false);
}

bool Authority::held_by(const Claimant& claimant) const noexcept {
  return lease_ && lease_->claimant == claimant.number;
}

std::string_view Authority::holder() const noexcept {
  return lease_ ? lease_->name : std::string_view();
}

void Authority::expire(std::int64_t now_ns) noexcept {
  if (lease_ && now_ns >= lease_->ends_ns) {
    lease_.reset();
    lapsed_ = true;
  }
}

void Authority::grant(const Claimant& claimant, std::int64_t now_ns) {
  if (!lease_) {
    lease_ = Lease{claimant.number, claimant.name, random_id(), 0};
  }
  lease_->name = claimant.name;
  lease_->ends_ns = now_ns + lease_ns_;
}

void Authority::require(const Claimant& claimant, std::string_view lease, std::int64_t now_ns) {
  expire(now_ns);
  if (!held_by(claimant) || !same_id(lease_->id, lease)) {
    throw CommandDenied("this lease is not, or no longer, this connection's: call /command/acquire");
  }
}

}  // namespace gaitway::api

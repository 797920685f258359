// For how long the server's certificate counts, and what people are told about it before it counts no more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

struct ssl_ctx_st;

namespace gaitway::api {

// Of the server's certificate and its issuers' beside it: those that begin last and end first. Times are
// seconds since 1970, UTC.
struct CertificateTerm {
  std::filesystem::path file;
  std::string begins_last = {}, ends_first = {};  // whose certificates
  std::int64_t begin_s = 0, end_s = 0;
};

// Of the certificates that have been put into the context out of `file`. Throws ServerSetupError when they
// have no readable dates.
[[nodiscard]] CertificateTerm term_of(ssl_ctx_st& context, const std::filesystem::path& file);

inline constexpr std::int64_t kDay_s = 24 * 60 * 60;
// So long before its end people are told.
inline constexpr std::int64_t kShortTerm_s = 14 * kDay_s;

// What is wrong with it at this time, for people; empty: it counts, and will for kShortTerm_s at least.
// Nobody is refused for it here: that is the clients' to decide.
[[nodiscard]] std::string trouble_of(const CertificateTerm& term, std::int64_t now_s);

// Says it when it begins, daily, and when handshakes fail; never more than once in ten minutes. Passive: told
// the time, by the computer's clock, which may be set meanwhile.
class CertificateWatch {
 public:
  explicit CertificateWatch(CertificateTerm term) : term_(std::move(term)) {}

  // `failed_handshakes`: so far, of TLS. Gives what is to be said now.
  [[nodiscard]] std::optional<std::string> look(std::int64_t now_s, std::uint64_t failed_handshakes);
  // As it was said last; empty: nothing is wrong.
  [[nodiscard]] const std::string& trouble() const noexcept { return told_; }

 private:
  CertificateTerm term_;
  std::string told_;
  bool told_in_term_ = true;  // it counted when it was said
  std::int64_t told_s_ = 0;
  std::uint64_t failed_ = 0;  // handshakes, when it was said
};

}  // namespace gaitway::api

// Dates out of the certificates, and dates into words.
#include "gaitway/api/certificate_term.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>

#include <array>
#include <ctime>
#include <memory>
#include <utility>

#include "gaitway/api/admission.hpp"

namespace gaitway::api {
namespace {

std::optional<std::int64_t> seconds_of(const ASN1_TIME* time) {
  std::tm utc{};
  return time != nullptr && ASN1_TIME_to_tm(time, &utc) == 1 ? std::optional<std::int64_t>(timegm(&utc))
                                                             : std::nullopt;
}

// Its common name, or all of its name where there is none, or its serial number where it has no name: its
// hosts stand elsewhere then.
std::string subject_of(const X509& certificate) {
  X509_NAME* const name = X509_get_subject_name(&certificate);
  std::array<char, 256> text{};
  if (X509_NAME_entry_count(name) == 0) {
    const std::unique_ptr<BIGNUM, decltype(&BN_free)> number(
        ASN1_INTEGER_to_BN(X509_get0_serialNumber(&certificate), nullptr), BN_free);
    const std::unique_ptr<char, void (*)(char*)> digits(number ? BN_bn2hex(number.get()) : nullptr,
                                                        [](char* taken) { OPENSSL_free(taken); });
    return fmt::format("no name, serial number {}", digits ? digits.get() : "unknown");
  }
  if (X509_NAME_get_text_by_NID(name, NID_commonName, text.data(), text.size()) <= 0) {
    X509_NAME_oneline(name, text.data(), static_cast<int>(text.size()));
  }
  for (char& letter : text) {
    letter = letter == '\0' || (letter >= ' ' && letter <= '~') ? letter : '?';
  }
  return text.data();
}

void narrow(CertificateTerm& term, const X509& certificate) {
  const auto begin_s = seconds_of(X509_get0_notBefore(&certificate));
  const auto end_s = seconds_of(X509_get0_notAfter(&certificate));
  if (!begin_s || !end_s) {
    throw ServerSetupError("certificate_file '" + term.file.native() + "': the certificate of '" +
                           subject_of(certificate) +
                           "' has no readable dates: have it issued anew, with notBefore and notAfter");
  }
  if (term.begins_last.empty() || *begin_s > term.begin_s) {
    term.begin_s = *begin_s;
    term.begins_last = subject_of(certificate);
  }
  if (term.ends_first.empty() || *end_s < term.end_s) {
    term.end_s = *end_s;
    term.ends_first = subject_of(certificate);
  }
}

std::string date(std::int64_t time_s) {
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(static_cast<std::time_t>(time_s)));
}

std::string days(std::int64_t duration_s) {
  const std::int64_t count = duration_s / kDay_s;
  return count == 0 ? "less than a day" : fmt::format("{} {}", count, count == 1 ? "day" : "days");
}

}  // namespace

CertificateTerm term_of(ssl_ctx_st& context, const std::filesystem::path& file) {
  CertificateTerm term{.file = file};
  if (const X509* const own = SSL_CTX_get0_certificate(&context)) {
    narrow(term, *own);
  }
  STACK_OF(X509)* issuers = nullptr;
  SSL_CTX_get0_chain_certs(&context, &issuers);
  for (int i = 0; i < sk_X509_num(issuers); ++i) {
    narrow(term, *sk_X509_value(issuers, i));
  }
  return term;
}

std::string trouble_of(const CertificateTerm& term, std::int64_t now_s) {
  const auto of = [&term](const std::string& subject) {
    return fmt::format("the certificate of '{}' in certificate_file '{}'", subject, term.file.native());
  };
  if (now_s > term.end_s) {
    return fmt::format(
        "{} expired on {}, {} ago: browsers and clients refuse it, or warn of it; renew it, and start the "
        "module anew",
        of(term.ends_first), date(term.end_s), days(now_s - term.end_s));
  }
  if (now_s < term.begin_s) {
    return fmt::format(
        "{} is not valid before {}, in {}: browsers and clients refuse it; set this computer's clock, which "
        "shows {}, or take a certificate that is valid now",
        of(term.begins_last), date(term.begin_s), days(term.begin_s - now_s), date(now_s));
  }
  if (term.end_s - now_s < kShortTerm_s) {
    return fmt::format("{} expires on {}, in {}: renew it before, and start the module anew",
                       of(term.ends_first), date(term.end_s), days(term.end_s - now_s));
  }
  return {};
}

std::optional<std::string> CertificateWatch::look(std::int64_t now_s, std::uint64_t failed_handshakes) {
  constexpr std::int64_t kBetween_s = 600;
  std::string trouble = trouble_of(term_, now_s);
  if (trouble.empty()) {
    told_.clear();
    failed_ = failed_handshakes;
    return std::nullopt;
  }
  const std::int64_t since_s = now_s < told_s_ ? kDay_s : now_s - told_s_;
  const std::uint64_t failed = failed_handshakes - failed_;
  const bool in_term = now_s >= term_.begin_s && now_s <= term_.end_s;
  const bool due =
      told_.empty() || in_term != told_in_term_ || since_s >= kDay_s || (failed > 0 && since_s >= kBetween_s);
  if (!due) {
    return std::nullopt;
  }
  failed_ = failed_handshakes;
  told_in_term_ = in_term;
  told_s_ = now_s;
  told_ = std::move(trouble);
  return failed == 0
             ? told_
             : fmt::format("{} ({} TLS handshakes have failed since this was said last)", told_, failed);
}

}  // namespace gaitway::api

// Compares origins in one spelling: lower case, without the scheme's own port (RFC 6454).
#include "gaitway/api/origin_rule.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "gaitway/api/access_token.hpp"

namespace gaitway::api {
namespace {

struct Origin {
  std::string scheme, host, port;  // the port: empty for the scheme's own

  [[nodiscard]] std::string text() const { return scheme + "://" + host + (port.empty() ? "" : ":" + port); }
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_host(std::string_view host) {
  const auto letter = [](char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || c == '-' || c == '.' || c == '_';
  };
  const auto address = [](char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || c == ':' || c == '.'; };
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
    host = host.substr(1, host.size() - 2);
    return std::all_of(host.begin(), host.end(), address);
  }
  return !host.empty() && std::all_of(host.begin(), host.end(), letter);
}

// Nothing for what is no origin of a web page.
std::optional<Origin> parse(std::string_view given) {
  std::string text(given);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const std::size_t colon = text.find("://");
  if (colon == std::string::npos) {
    return std::nullopt;
  }
  Origin origin{.scheme = text.substr(0, colon), .host = text.substr(colon + 3), .port = {}};
  if (const std::size_t end = origin.host.rfind(':');
      end != std::string::npos && origin.host.find(']', end) == std::string::npos) {
    origin.port = origin.host.substr(end + 1);
    origin.host.resize(end);
    if (origin.port.empty() || origin.port.size() > 5 ||
        !std::all_of(origin.port.begin(), origin.port.end(), is_digit)) {
      return std::nullopt;
    }
  }
  if ((origin.scheme != "http" && origin.scheme != "https") || !is_host(origin.host)) {
    return std::nullopt;
  }
  if (origin.port == (origin.scheme == "http" ? "80" : "443")) {
    origin.port.clear();
  }
  return origin;
}

}  // namespace

OriginRule::OriginRule(std::span<const std::string> allowed) {
  for (const std::string& entry : allowed) {
    const auto origin = parse(entry);
    if (!origin) {
      throw ServerSetupError("origins: '" + entry +
                             "' is no origin of a web page: name each as http://host, https://host or with "
                             ":port after it, without a path; there is no entry for all");
    }
    allowed_.push_back(origin->text());
  }
}

bool OriginRule::allows(std::string_view origin) const {
  static constexpr std::array<std::string_view, 3> kThisMachine{"localhost", "127.0.0.1", "[::1]"};
  const auto parsed = parse(origin);
  if (!parsed) {
    return false;
  }
  if (allowed_.empty()) {
    return std::find(kThisMachine.begin(), kThisMachine.end(), parsed->host) != kThisMachine.end();
  }
  return std::find(allowed_.begin(), allowed_.end(), parsed->text()) != allowed_.end();
}

}  // namespace gaitway::api

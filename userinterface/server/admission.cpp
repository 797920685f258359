// Reads the token with the file's rights checked on the opened file, so that nobody can swap it in between.
// Compares origins in one spelling: lower case, without the scheme's own port (RFC 6454).
#include "gaitway/api/admission.hpp"

#include <fcntl.h>
#include <openssl/crypto.h>
#include <openssl/sha.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::api {
namespace {

constexpr mode_t kGroupAndOthers = 0077;

std::array<std::uint8_t, 32> digest(std::string_view text) noexcept {
  std::array<std::uint8_t, 32> result{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), result.data());
  return result;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw ServerSetupError("token_file '" + file.native() + "': " + why);
}

std::string octal(mode_t mode) {
  std::string digits = "0";
  for (int shift = 6; shift >= 0; shift -= 3) {
    digits += static_cast<char>('0' + ((mode >> shift) & 7U));
  }
  return digits;
}

void check_rights(const std::filesystem::path& file, const struct stat& status) {
  if (!S_ISREG(status.st_mode)) {
    refuse(file, "is no regular file; the token must be in one");
  }
  if (status.st_uid != geteuid()) {
    refuse(file, "belongs to user " + std::to_string(status.st_uid) + ", but must belong to user " +
                     std::to_string(geteuid()) + ", who runs the robot API: run `chown " +
                     std::to_string(geteuid()) + " " + file.native() + "`");
  }
  if ((status.st_mode & kGroupAndOthers) != 0) {
    refuse(file, "has mode " + octal(status.st_mode) +
                     ", but group and others must have no rights to it: run `chmod 600 " + file.native() +
                     "`");
  }
}

std::string read_whole(const std::filesystem::path& file, int fd) {
  std::string text(AccessToken::kLongest + 2, '\0');  // one line end, and one more to see that it is too long
  std::size_t length = 0;
  while (length < text.size()) {
    const ssize_t got = ::read(fd, text.data() + length, text.size() - length);
    if (got < 0 && errno != EINTR) {
      refuse(file, std::string("cannot be read: ") + std::strerror(errno));
    }
    if (got == 0) {
      break;
    }
    length += got > 0 ? static_cast<std::size_t>(got) : 0;
  }
  text.resize(length);
  return text;
}

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
    return std::ranges::all_of(host, address);
  }
  return !host.empty() && std::ranges::all_of(host, letter);
}

// Nothing for what is no origin of a web page.
std::optional<Origin> parse(std::string_view given) {
  std::string text(given);
  std::ranges::transform(text, text.begin(),
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
    if (origin.port.empty() || origin.port.size() > 5 || !std::ranges::all_of(origin.port, is_digit)) {
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

// What browsers send for pages from files, and for frames that are kept apart from every origin.
bool is_of_files(std::string_view origin) {
  return origin == "null" || origin == "file://";
}

}  // namespace

AccessToken::AccessToken(std::string_view text) {
  if (text.size() < kShortest || text.size() > kLongest) {
    throw ServerSetupError("the token has " + std::to_string(text.size()) + " bytes, but must have " +
                           std::to_string(kShortest) + " to " + std::to_string(kLongest) +
                           ": make one with `openssl rand -hex 32`");
  }
  if (!std::ranges::all_of(text, [](char c) { return c > ' ' && c <= '~'; })) {
    throw ServerSetupError(
        "the token has other characters than visible ASCII (no spaces): make one with `openssl rand -hex "
        "32`");
  }
  digest_ = digest(text);
}

std::string read_token(const std::filesystem::path& file) {
  const process::FileDescriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (!opened || fstat(opened.get(), &status) != 0) {
    refuse(file, std::string("cannot be opened: ") + std::strerror(errno) +
                     ": make it with `(umask 077; openssl rand -hex 32 > " + file.native() + ")`");
  }
  check_rights(file, status);
  std::string text = read_whole(file, opened.get());
  if (text.ends_with('\n')) {
    text.pop_back();
  }
  if (text.ends_with('\r')) {
    text.pop_back();
  }
  return text;
}

AccessToken AccessToken::read(const std::filesystem::path& file) {
  std::string text = read_token(file);
  try {
    AccessToken token(text);
    OPENSSL_cleanse(text.data(), text.size());
    return token;
  } catch (const ServerSetupError& error) {
    refuse(file, error.what());
  }
}

bool AccessToken::matches(std::string_view offered) const noexcept {
  const auto other = digest(offered);
  return CRYPTO_memcmp(digest_.data(), other.data(), digest_.size()) == 0;
}

OriginRule::OriginRule(std::span<const std::string> allowed) {
  for (const std::string& entry : allowed) {
    const auto origin = parse(entry);
    if (!origin && !is_of_files(entry)) {
      throw ServerSetupError(
          "origins: '" + entry +
          "' is no origin of a web page: name each as http://host, https://host or with "
          ":port after it, without a path, and pages from files as null; there is no entry "
          "for all");
    }
    allowed_.push_back(origin ? origin->text() : entry);
  }
}

bool OriginRule::allows(std::string_view origin) const {
  static constexpr std::array<std::string_view, 3> kThisMachine{"localhost", "127.0.0.1", "[::1]"};
  const auto parsed = parse(origin);
  const bool is_local = parsed && std::ranges::find(kThisMachine, parsed->host) != kThisMachine.end();
  return is_local ||
         std::ranges::find(allowed_, parsed ? parsed->text() : std::string(origin)) != allowed_.end();
}

}  // namespace gaitway::api

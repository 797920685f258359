// Where the robot API listens and whom it lets in, and all that the server needs from the machine for it,
// opened before the process gives up the right to open anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/api/admission.hpp"
#include "gaitway/api/certificate_term.hpp"
#include "gaitway/api/limits.hpp"
#include "gaitway/process/file_descriptor.hpp"

struct ssl_ctx_st;

namespace gaitway::api {

struct ServerOptions {
  // A numeric IPv4 or IPv6 address, or localhost for 127.0.0.1. One that is not loopback wants TLS and a
  // token.
  std::string address = "127.0.0.1";
  std::uint16_t port = 9090;  // 0: any that is free
  // Web pages that may connect beside those that this machine serves itself, as `https://host:port`; `null`:
  // from files. Clients that are no web pages send no origin, and are not asked for one.
  std::vector<std::string> origins;
  std::filesystem::path token_file;        // empty: no token is wanted
  std::filesystem::path certificate_file;  // PEM, the server's first, then its issuers; empty: no TLS
  std::filesystem::path key_file;          // PEM
  Limits limits;
  std::size_t header_bytes = std::size_t{8} * 1024;  // of the request with which a client connects
  std::size_t send_buffer_bytes =
      std::size_t{64} * 1024;          // in the kernel, for each client: a slow one sees old data
  std::int64_t ping_ns = 100'000'000;  // between pings
  std::int64_t order_ping_ns =
      50'000'000;  // the same of clients that give orders: their answers date what comes after
  std::int64_t closing_ns = 500'000'000;       // from the decision to close a connection to its end
  std::int64_t page_ns = 20'000'000'000;       // in which a browser takes a file of the page
  std::int64_t accept_pause_ns = 100'000'000;  // before accepting again, when descriptors or memory ran out
  std::int64_t tick_ns = 10'000'000;
  std::int64_t poll_ns = 2'000'000;
};

struct TlsContextDeleter {
  void operator()(ssl_ctx_st* context) const noexcept;
};
using TlsContext = std::unique_ptr<ssl_ctx_st, TlsContextDeleter>;

class ServerSetup {
 public:
  // Reads token, certificate and key, and listens. Throws ServerSetupError.
  explicit ServerSetup(ServerOptions options);

  [[nodiscard]] const ServerOptions& options() const noexcept { return options_; }
  [[nodiscard]] const OriginRule& origins() const noexcept { return origins_; }
  [[nodiscard]] const std::optional<AccessToken>& token() const noexcept { return token_; }
  [[nodiscard]] bool has_tls() const noexcept { return !options_.certificate_file.empty(); }
  [[nodiscard]] bool is_ipv6() const noexcept { return ipv6_; }
  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  // Of the certificate; nothing without TLS.
  [[nodiscard]] const std::optional<CertificateTerm>& certificate_term() const noexcept {
    return certificate_term_;
  }
  // For people and clients: ws://127.0.0.1:9090
  [[nodiscard]] std::string url() const;

  // For the server, which owns them from now on.
  [[nodiscard]] process::FileDescriptor take_listener() noexcept { return std::move(listener_); }
  [[nodiscard]] TlsContext take_tls() noexcept { return std::move(tls_); }  // empty without TLS

 private:
  ServerOptions options_;
  OriginRule origins_;
  std::optional<AccessToken> token_;
  TlsContext tls_;
  std::optional<CertificateTerm> certificate_term_;
  process::FileDescriptor listener_;
  std::uint16_t port_ = 0;
  bool ipv6_ = false;
};

}  // namespace gaitway::api

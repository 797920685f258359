// All that the server needs from the machine, opened before the process gives up the right to open anything.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "gaitway/api/access_token.hpp"
#include "gaitway/api/origin_rule.hpp"
#include "gaitway/api/server_options.hpp"
#include "gaitway/process/file_descriptor.hpp"

struct ssl_ctx_st;

namespace gaitway::api {

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
  process::FileDescriptor listener_;
  std::uint16_t port_ = 0;
  bool ipv6_ = false;
};

}  // namespace gaitway::api

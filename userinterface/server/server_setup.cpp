// Refuses what is not safe, then opens token, certificate, key and socket.
#include "gaitway/api/server_setup.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

namespace gaitway::api {
namespace {

constexpr int kBacklog = 512;  // all clients come back at once when the API has been started again

struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t length = 0;

  [[nodiscard]] bool ipv6() const noexcept { return storage.ss_family == AF_INET6; }
  [[nodiscard]] sockaddr* get() noexcept { return reinterpret_cast<sockaddr*>(&storage); }
};

SocketAddress parse_address(const ServerOptions& options) {
  const std::string text = options.address == "localhost" ? "127.0.0.1" : options.address;
  SocketAddress address;
  auto* const v4 = reinterpret_cast<sockaddr_in*>(&address.storage);
  auto* const v6 = reinterpret_cast<sockaddr_in6*>(&address.storage);
  if (inet_pton(AF_INET, text.c_str(), &v4->sin_addr) == 1) {
    v4->sin_family = AF_INET;
    v4->sin_port = htons(options.port);
    address.length = sizeof *v4;
  } else if (inet_pton(AF_INET6, text.c_str(), &v6->sin6_addr) == 1) {
    v6->sin6_family = AF_INET6;
    v6->sin6_port = htons(options.port);
    address.length = sizeof *v6;
  } else {
    throw ServerSetupError("address '" + options.address +
                           "': must be a numeric IPv4 or IPv6 address or localhost: take 127.0.0.1 for this "
                           "machine only, or the address of the network card");
  }
  return address;
}

bool is_loopback(const SocketAddress& address) {
  if (address.ipv6()) {
    const auto& v6 = reinterpret_cast<const sockaddr_in6&>(address.storage);
    return IN6_IS_ADDR_LOOPBACK(&v6.sin6_addr);
  }
  const auto& v4 = reinterpret_cast<const sockaddr_in&>(address.storage);
  return (ntohl(v4.sin_addr.s_addr) >> 24U) == 127;
}

void check_exposure(const ServerOptions& options, const SocketAddress& address) {
  if (options.certificate_file.empty() != options.key_file.empty()) {
    const bool key = options.key_file.empty();
    throw ServerSetupError(std::string(key ? "key_file" : "certificate_file") + " '': must be given when " +
                           (key ? "certificate_file '" + options.certificate_file.native()
                                : "key_file '" + options.key_file.native()) +
                           "' is: name both for TLS, or none");
  }
  const bool tls = !options.certificate_file.empty();
  const bool token = !options.token_file.empty();
  if (is_loopback(address) || (tls && token)) {
    return;
  }
  std::string missing = tls ? "" : "certificate_file and key_file";
  missing += !tls && !token ? ", and " : "";
  missing += token ? "" : "token_file";
  throw ServerSetupError(
      "address '" + options.address +
      "': others than this machine can reach it, so TLS and a token are wanted, or anybody "
      "on the network could drive the robot: give " +
      missing + ", or take 127.0.0.1");
}

std::string tls_reason() {
  const unsigned long code = ERR_get_error();
  const char* const text = code == 0 ? nullptr : ERR_reason_error_string(code);
  ERR_clear_error();
  return text == nullptr ? std::strerror(errno) : text;
}

// A pipe would have the process wait for who writes to it.
void check_regular(const char* option, const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    throw ServerSetupError(std::string(option) + " '" + file.native() +
                           "': is no regular file: name the file with the PEM text");
  }
}

// There is nobody to ask.
int no_pass_phrase(char* /*room*/, int /*size*/, int /*writes*/, void* /*user*/) {
  return -1;
}

void check_key_rights(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) == 0 && (status.st_mode & 0007) != 0) {
    throw ServerSetupError("key_file '" + file.native() +
                           "': all users have rights to it, but a private key must be kept from them: run "
                           "`chmod o= " +
                           file.native() + "`");
  }
}

TlsContext open_tls(const ServerOptions& options) {
  if (options.certificate_file.empty()) {
    return {};
  }
  TlsContext tls(SSL_CTX_new(TLS_server_method()));
  if (!tls || SSL_CTX_set_min_proto_version(tls.get(), TLS1_2_VERSION) != 1) {
    throw ServerSetupError("TLS cannot be set up: " + tls_reason());
  }
  SSL_CTX_set_options(tls.get(), SSL_OP_NO_RENEGOTIATION | SSL_OP_CIPHER_SERVER_PREFERENCE);
  SSL_CTX_set_mode(tls.get(), SSL_MODE_RELEASE_BUFFERS);
  SSL_CTX_set_default_passwd_cb(tls.get(), no_pass_phrase);
  check_regular("certificate_file", options.certificate_file);
  check_regular("key_file", options.key_file);
  ERR_clear_error();
  if (SSL_CTX_use_certificate_chain_file(tls.get(), options.certificate_file.c_str()) != 1) {
    throw ServerSetupError("certificate_file '" + options.certificate_file.native() +
                           "': is no readable PEM certificate (" + tls_reason() +
                           "): give the server's certificate, followed by its issuers'");
  }
  check_key_rights(options.key_file);
  if (SSL_CTX_use_PrivateKey_file(tls.get(), options.key_file.c_str(), SSL_FILETYPE_PEM) != 1) {
    throw ServerSetupError("key_file '" + options.key_file.native() + "': is no readable PEM key (" +
                           tls_reason() + ") of the certificate in '" + options.certificate_file.native() +
                           "': give the one with which it was made, without a pass phrase");
  }
  return tls;
}

[[noreturn]] void refuse_listening(const ServerOptions& options, int error) {
  const std::string where =
      "port " + std::to_string(options.port) + " at address '" + options.address + "': ";
  if (error == EADDRINUSE) {
    throw ServerSetupError(where +
                           "is taken by another program (see `ss -ltnp`): end it, or take another port");
  }
  if (error == EADDRNOTAVAIL) {
    throw ServerSetupError(where + "this machine has no such address: see `ip address`");
  }
  if (error == EACCES) {
    throw ServerSetupError(where + "ports below 1024 are for privileged programs: take a higher one");
  }
  throw ServerSetupError(where + "cannot be listened at: " + std::strerror(error));
}

// Accepted sockets inherit these options.
void set_socket_options(int socket, const ServerOptions& options) {
  const int on = 1, off = 0;
  const int send_bytes = static_cast<int>(options.send_buffer_bytes);
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &off, sizeof off);
  setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &send_bytes, sizeof send_bytes);
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

process::FileDescriptor listen_at(const ServerOptions& options, SocketAddress& address) {
  process::FileDescriptor listener(
      socket(address.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, IPPROTO_TCP));
  if (!listener) {
    refuse_listening(options, errno);
  }
  set_socket_options(listener.get(), options);
  if (address.ipv6()) {
    const int only_ipv6 = 0;
    setsockopt(listener.get(), IPPROTO_IPV6, IPV6_V6ONLY, &only_ipv6, sizeof only_ipv6);
  }
  if (bind(listener.get(), address.get(), address.length) != 0 || listen(listener.get(), kBacklog) != 0 ||
      getsockname(listener.get(), address.get(), &address.length) != 0) {
    refuse_listening(options, errno);
  }
  return listener;
}

}  // namespace

void TlsContextDeleter::operator()(ssl_ctx_st* context) const noexcept {
  SSL_CTX_free(context);
}

ServerSetup::ServerSetup(ServerOptions options) : options_(std::move(options)), origins_(options_.origins) {
  SocketAddress address = parse_address(options_);
  check_exposure(options_, address);
  if (!options_.token_file.empty()) {
    token_ = AccessToken::read(options_.token_file);
  }
  tls_ = open_tls(options_);
  if (tls_) {
    certificate_term_ = term_of(*tls_, options_.certificate_file);
  }
  listener_ = listen_at(options_, address);
  ipv6_ = address.ipv6();
  port_ = ntohs(ipv6_ ? reinterpret_cast<const sockaddr_in6&>(address.storage).sin6_port
                      : reinterpret_cast<const sockaddr_in&>(address.storage).sin_port);
}

std::string ServerSetup::url() const {
  const std::string host = ipv6_ ? "[" + options_.address + "]" : options_.address;
  return (has_tls() ? "wss://" : "ws://") + host + ":" + std::to_string(port_);
}

}  // namespace gaitway::api

// Who gives way when all places are taken: those who have not shown yet that they may be here.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "client_link.hpp"
#include "raw_client.hpp"
#include "running_server.hpp"
#include "secret_files.hpp"
#include "server_core.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

using testing::StartsWith;

constexpr std::string_view kLetIn = "HTTP/1.1 101 ";
constexpr std::size_t kPlaces = 4;
constexpr std::int64_t kLong_ns = 600'000'000'000;  // nothing ends by its deadline here

class CrowdingTest : public testing::Test {
 protected:
  static ServerOptions options(bool token, const SecretFiles& files) {
    ServerOptions options = local();
    options.limits.connections = kPlaces;
    options.limits.handshake_ns = options.limits.silence_ns = kLong_ns;
    if (token) {
      options.token_file = files.token();
    }
    return options;
  }
  using Clients = std::vector<std::unique_ptr<RawClient>>;
  // They come one after the other, so that it is known who is the oldest.
  Clients silent_clients(RunningServer& server, std::size_t count) {
    Clients clients;
    for (std::size_t i = 0; i < count; ++i) {
      clients.push_back(std::make_unique<RawClient>(server.port()));
      ++accepted_;
      server.await(
          [this](const ServerStatistics& statistics, EchoHub&) { return statistics.accepted == accepted_; });
    }
    return clients;
  }
  // With the right token, and so authorised.
  std::unique_ptr<RawClient> let_in(RunningServer& server, process::FileDescriptor socket = tcp_socket()) {
    auto client = std::make_unique<RawClient>(std::move(socket), server.port());
    EXPECT_THAT(answer_to_token(*client), StartsWith(std::string(kLetIn)));
    return client;
  }
  // Likewise. One that is crowded out before it could say who it is, since the computer is busy, tries again.
  std::unique_ptr<RawClient> let_in_at_last(RunningServer& server) {
    constexpr int kTries = 3;
    std::unique_ptr<RawClient> client;
    bool is_in = false;
    for (int i = 0; i < kTries && !is_in; ++i) {
      client = std::make_unique<RawClient>(tcp_socket(), server.port());
      is_in = answer_to_token(*client).starts_with(kLetIn);
    }
    EXPECT_TRUE(is_in);
    return client;
  }
  std::string answer_to_token(RawClient& client) {
    ++accepted_;
    client.send(upgrade_request("Authorization: Bearer " + std::string(SecretFiles::kToken) + "\r\n"));
    return client.receive_header();
  }
  static bool echoes(RawClient& client) {
    client.send(masked_frame(kText, "hello"));
    const auto answer = client.receive_frame();
    return answer && answer->payload == "hello";
  }
  static process::FileDescriptor tcp_socket() {
    return process::FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  }
  // Of another address than the other clients.
  static process::FileDescriptor foreign_socket() {
    process::FileDescriptor result = tcp_socket();
    sockaddr_in from{};
    from.sin_family = AF_INET;
    inet_pton(AF_INET, "127.0.0.2", &from.sin_addr);
    EXPECT_EQ(bind(result.get(), reinterpret_cast<const sockaddr*>(&from), sizeof from), 0);
    return result;
  }

  const SecretFiles files_;
  std::uint64_t accepted_ = 0;
};

TEST_F(CrowdingTest, SilentConnectionsGiveWayToWhoHasTheToken) {
  RunningServer server(options(true, files_));
  const Clients silent = silent_clients(server, kPlaces);
  const auto client = let_in(server);
  EXPECT_TRUE(echoes(*client));
  EXPECT_EQ(silent.front()->receive_all(), "") << "the oldest";
  EXPECT_EQ(server.statistics().connected, kPlaces);
  EXPECT_EQ(server.statistics().of(Refusal::too_many), 1U);
}

TEST_F(CrowdingTest, HalfOpenTlsGivesWay) {
  ServerOptions with_tls = options(true, files_);
  with_tls.certificate_file = files_.certificate();
  with_tls.key_file = files_.key();
  RunningServer server(with_tls);
  const Clients silent = silent_clients(server, kPlaces);
  WebSocketClient client(
      server.port(),
      {.headers = {{"Authorization", "Bearer " + std::string(SecretFiles::kToken)}}, .tls = true});
  client.send("hello");
  EXPECT_EQ(client.receive().text, "hello");
  EXPECT_EQ(silent.front()->receive_all(), "");
}

TEST_F(CrowdingTest, WithoutATokenAFinishedHandshakeIsEnough) {
  RunningServer server(options(false, files_));
  RawClient first(server.port());
  ++accepted_;
  EXPECT_THAT(first.open_websocket(), StartsWith("HTTP/1.1 101 "));
  const Clients silent = silent_clients(server, 3 * kPlaces);
  EXPECT_EQ(silent.front()->receive_all(), "");
  EXPECT_TRUE(echoes(first)) << "older, but known";
  EXPECT_EQ(server.statistics().connected, kPlaces);
}

TEST_F(CrowdingTest, SessionsWithoutTheTokenGiveWay) {
  RunningServer server(options(true, files_));
  Clients strangers;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    strangers.push_back(std::make_unique<RawClient>(server.port()));
    ASSERT_THAT(strangers.back()->open_websocket(), StartsWith("HTTP/1.1 101 "));
  }
  Clients clients;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    clients.push_back(let_in(server));
    EXPECT_TRUE(echoes(*clients.back()));
  }
  RawClient late(server.port());
  EXPECT_THAT(late.open_websocket(), StartsWith("HTTP/1.1 503 ")) << "all have shown the token";
  for (const auto& client : clients) {
    EXPECT_TRUE(echoes(*client));
  }
  EXPECT_EQ(server.statistics().of(Closing::refused), kPlaces);
}

TEST_F(CrowdingTest, OneAddressTakesPlacesFromItselfOnly) {
  ServerOptions shared = options(true, files_);
  shared.limits.connections_of_one_address = kPlaces - 1;
  RunningServer server(shared);
  const auto foreigner = std::make_unique<RawClient>(foreign_socket(), server.port());
  ++accepted_;
  const Clients silent = silent_clients(server, 10 * kPlaces);
  foreigner->send(upgrade_request("Authorization: Bearer " + std::string(SecretFiles::kToken) + "\r\n"));
  EXPECT_THAT(foreigner->receive_header(), StartsWith("HTTP/1.1 101 "))
      << "the oldest of all, but of another";
  EXPECT_TRUE(echoes(*foreigner));
  EXPECT_EQ(server.statistics().connected, kPlaces);
}

TEST_F(CrowdingTest, StrangersOfOneAddressHaveFewPlaces) {
  ServerOptions few = options(true, files_);
  few.limits.connections = 2 * kPlaces;
  few.limits.strangers_of_one_address = 2;
  RunningServer server(few);
  const auto known = let_in(server);
  const Clients silent = silent_clients(server, 10);
  EXPECT_EQ(silent.front()->receive_all(), "");
  EXPECT_EQ(server.statistics().connected, 3U);
  const auto foreigner = let_in(server, foreign_socket());
  EXPECT_TRUE(echoes(*foreigner));
  EXPECT_TRUE(echoes(*known));
}

TEST_F(CrowdingTest, WhereMostStrangersAreOneGivesWay) {
  RunningServer server(options(true, files_));
  RawClient foreigner(foreign_socket(), server.port());
  ++accepted_;
  const Clients silent = silent_clients(server, kPlaces - 1);
  const auto client = let_in(server, foreign_socket());
  EXPECT_EQ(silent.front()->receive_all(), "");
  foreigner.send(upgrade_request("Authorization: Bearer " + std::string(SecretFiles::kToken) + "\r\n"));
  EXPECT_THAT(foreigner.receive_header(), StartsWith("HTTP/1.1 101 ")) << "the oldest of all";
}

// So many sockets without a word, each opened again as it is cut.
class Renewing {
 public:
  Renewing(std::uint16_t port, std::size_t count)
      : port_(port), sockets_(count), thread_([this] { renew(); }) {}
  ~Renewing() {
    end_ = true;
    thread_.join();
  }
  Renewing(const Renewing&) = delete;
  Renewing& operator=(const Renewing&) = delete;

 private:
  void open(process::FileDescriptor& at) const {
    at = process::FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in server{};
    server.sin_family = AF_INET;
    server.sin_port = htons(port_);
    server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    static_cast<void>(connect(at.get(), reinterpret_cast<const sockaddr*>(&server), sizeof server));
  }
  void renew() {
    std::vector<pollfd> polled(sockets_.size());
    while (!end_) {
      for (std::size_t i = 0; i < sockets_.size(); ++i) {
        if (!sockets_[i] || polled[i].revents != 0) {
          open(sockets_[i]);
        }
        polled[i] = {sockets_[i].get(), POLLIN, 0};
      }
      poll(polled.data(), polled.size(), 10);
    }
  }

  std::uint16_t port_;
  std::vector<process::FileDescriptor> sockets_;
  std::atomic<bool> end_ = false;
  std::thread thread_;
};

TEST_F(CrowdingTest, WhoRenewsHisSocketsLocksNobodyOut) {
  constexpr std::size_t kStrangers = 300, kTries = 20;
  ServerOptions many = options(true, files_);
  many.limits.connections = Limits{}.connections;
  RunningServer server(many);
  const Renewing strangers(server.port(), kStrangers);
  server.await(
      [](const ServerStatistics& statistics, EchoHub&) { return statistics.accepted > 2 * kStrangers; });
  Clients clients;
  for (std::size_t count = 0; count < kTries; ++count) {
    const auto begin = std::chrono::steady_clock::now();
    clients.push_back(let_in_at_last(server));
    EXPECT_TRUE(echoes(*clients.back())) << count;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
  }
  EXPECT_LE(server.statistics().connected, kTries + Limits{}.strangers_of_one_address);
  for (const auto& client : clients) {
    EXPECT_TRUE(echoes(*client));
  }
}

// Connections as of addresses that this computer has not.
class CrowdOfAddresses : public testing::Test {
 protected:
  explicit CrowdOfAddresses() : setup_(few_strangers()), core_(hub_, setup_, {}) {}
  ~CrowdOfAddresses() override {
    while (!core_.links().empty()) {
      core_.links().back()->cut(Closing::shut_down);
    }
    core_.io.poll();
  }
  // Nothing: there is no place for it.
  std::shared_ptr<ClientLink> come(const char* from) {
    const auto address = boost::asio::ip::make_address(from);
    if (!core_.make_room_for(address)) {
      return nullptr;
    }
    auto link =
        make_plain_connection(core_, TcpSocket(core_.io, boost::asio::ip::tcp::v6()), {address, 1}, false);
    core_.add(link);
    return link;
  }
  [[nodiscard]] bool is_there(const std::shared_ptr<ClientLink>& link) const {
    return std::ranges::find(core_.links(), link) != core_.links().end();
  }

 private:
  static ServerOptions few_strangers() {
    ServerOptions options = local();
    options.limits.strangers_of_one_address = 2;
    return options;
  }
  EchoHub hub_;
  const ServerSetup setup_;
  ServerCore core_;
};

TEST_F(CrowdOfAddresses, AddressesOfOneIpv6NetworkAreOne) {
  const auto first = come("2001:db8:0:1::1"), second = come("2001:db8:0:1:ffff:ffff:ffff:ffff");
  const auto foreigner = come("2001:db8:0:2::1");
  EXPECT_TRUE(is_there(first));
  const auto third = come("2001:db8:0:1::2");
  EXPECT_FALSE(is_there(first)) << "the oldest of the network that has its places";
  EXPECT_TRUE(is_there(second));
  EXPECT_TRUE(is_there(third));
  EXPECT_TRUE(is_there(foreigner));
}

TEST_F(CrowdOfAddresses, AddressesOfIpv4AreEachItsOwn) {
  const auto first = come("192.0.2.1"), second = come("192.0.2.2"), third = come("192.0.2.3");
  EXPECT_TRUE(is_there(first));
  EXPECT_TRUE(is_there(second));
  EXPECT_TRUE(is_there(third));
}

TEST_F(CrowdingTest, OneAddressCannotHaveAllPlacesUnlessAsked) {
  EXPECT_LT(Limits{}.connections_of_one_address, Limits{}.connections);
}

}  // namespace
}  // namespace gaitway::api

// The process bounds its memory by the sum of its limits, and clients who fill all buffers that there are do
// not get it there.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "gaitway/api/limits.hpp"
#include "module_process.hpp"
#include "raw_client.hpp"
#include "secret_files.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

using testing::HasSubstr;

constexpr int kClients = 250;  // of `connections`, 256
constexpr int kWaves = 3;      // who leaves most unread is cut, and comes again

// Of all that makes the module keep something for a client that reads nothing.
std::vector<std::string> greed() {
  constexpr int kCalls = 40, kTopics = 16, kKept_bytes = 15'000;
  std::vector<std::string> messages{
      R"({"op": "subscribe", "topic": "/robot_description"})",
      R"({"op": "subscribe", "topic": "/robot_description", "id": "c", "compression": "cbor"})",
      R"({"op": "subscribe", "topic": "/robot_description", "id": "f", "fragment_size": 256})"};
  for (int i = 0; i < kCalls; ++i) {
    messages.emplace_back(
        R"({"op": "call_service", "service": "/rosapi/topics_and_raw_types", "fragment_size": 256})");
  }
  for (int i = 0; i < kTopics; ++i) {
    const std::string topic = R"("topic": "/greed/)" + std::to_string(i) + '"';
    messages.push_back(R"({"op": "advertise", "latch": true, "type": "std_msgs/msg/String", )" + topic + "}");
    messages.push_back(R"({"op": "publish", )" + topic + R"(, "msg": {"data": ")" +
                       std::string(kKept_bytes, 'x') + "\"}}");
  }
  return messages;
}

// Of every second client another address, since one alone does not get all places. What it does not read
// stays with the server.
process::FileDescriptor narrow_socket(int number) {
  constexpr int kReceived_bytes = 2048;
  process::FileDescriptor result(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  setsockopt(result.get(), SOL_SOCKET, SO_RCVBUF, &kReceived_bytes, sizeof kReceived_bytes);
  sockaddr_in from{};
  from.sin_family = AF_INET;
  from.sin_addr.s_addr = htonl(INADDR_LOOPBACK + static_cast<unsigned>(number % 2));
  bind(result.get(), reinterpret_cast<const sockaddr*>(&from), sizeof from);
  return result;
}

// A text frame whose end never comes.
std::string begun_message() {
  const std::size_t most_bytes = Limits{}.message_bytes;
  return masked_frame(kText, std::string(most_bytes, ' ')).substr(0, most_bytes - 1);
}

// Tries again while there is no place.
bool answers_somebody(const ModuleProcess& module) {
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries && module.runs(); ++i) {
    RawClient client(module.port());
    client.open_websocket();
    client.send(masked_frame(kText, R"({"op": "call_service", "service": "/rosapi/get_time"})"));
    const auto answer = client.receive_frame();
    if (answer && answer->payload.find("service_response") != std::string::npos) {
      return true;
    }
  }
  return false;
}

TEST(MemoryBound, IsTheSumOfTheLimits) {
  const ModuleProcess shipped({});
  EXPECT_EQ(shipped.most_data_bytes(), most_memory_bytes({}));
  const SecretFiles files;
  const ModuleProcess other({"--limits", files.write("limits.yaml", "connections: 100\n").string()});
  Limits fewer;
  fewer.connections = 100;
  EXPECT_EQ(other.most_data_bytes(), most_memory_bytes(fewer));
}

TEST(MemoryBound, IsNotReachedByClientsWhoReadNothing) {
  const ModuleProcess module({});
  std::vector<std::unique_ptr<RawClient>> clients(kClients);
  for (int wave = 0; wave < kWaves; ++wave) {
    for (int i = 0; i < kClients; ++i) {
      auto& client = clients[static_cast<std::size_t>(i)];
      client = std::make_unique<RawClient>(narrow_socket(i), module.port());
      client->open_websocket();
      for (const std::string& message : greed()) {
        client->send(masked_frame(kText, message));
      }
      client->send(begun_message());
    }
    EXPECT_LT(module.data_bytes(), most_memory_bytes({}));
    RecordProperty("bytes_" + std::to_string(wave), std::to_string(module.data_bytes()));
  }
  EXPECT_TRUE(module.runs());
  clients.clear();
  EXPECT_TRUE(answers_somebody(module)) << "once it has done what they left it to do";
}

TEST(MemoryBound, IsNotReachedOverTlsEither) {
  const SecretFiles files;
  const ModuleProcess module(
      {"--token-file", files.token(), "--certificate-file", files.certificate(), "--key-file", files.key()});
  const WebSocketClient::Options options{
      .headers = {{"Authorization", "Bearer " + std::string(SecretFiles::kToken)}}, .tls = true};
  // One address has fewer places than there are, and the last one is for who comes then.
  std::vector<std::unique_ptr<WebSocketClient>> clients(Limits{}.connections_of_one_address - 1);
  for (auto& client : clients) {
    client = std::make_unique<WebSocketClient>(module.port(), options);
    try {
      for (const std::string& message : greed()) {
        client->send(message);
      }
    } catch (const std::system_error&) {
      // It was cut: for it most waited.
    }
  }
  EXPECT_LT(module.data_bytes(), most_memory_bytes({}));
  RecordProperty("bytes", std::to_string(module.data_bytes()));
  EXPECT_TRUE(module.runs());
  WebSocketClient another(module.port(), options);
  another.send(R"({"op": "call_service", "service": "/rosapi/get_time"})");
  EXPECT_THAT(another.receive().text, HasSubstr("service_response"));
}

}  // namespace
}  // namespace gaitway::api

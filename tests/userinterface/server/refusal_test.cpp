// What becomes of those who guess tokens, and of pages that may not talk to the robot: each is written down,
// but in few lines, and waits the longer for his answer the more often he comes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "address_patience.hpp"
#include "raw_client.hpp"
#include "refusal_log.hpp"
#include "running_server.hpp"
#include "secret_files.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::string answer_to(const RunningServer& server, const std::string& more) {
  RawClient client(server.port());
  client.send(upgrade_request(more));
  return client.receive_all();
}

TEST(Refusals, AreWrittenDownWithAddressAndOrigin) {
  const SecretFiles files;
  ServerOptions options = local();
  options.token_file = files.token();
  RunningServer server(options);
  EXPECT_THAT(answer_to(server, "Origin: http://evil.example\r\n"), StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(answer_to(server, "Authorization: Bearer guess\r\n"), StartsWith("HTTP/1.1 401 "));
  static_cast<void>(server.refusals());
  EXPECT_THAT(server.refusals(), ElementsAre(AllOf(HasSubstr("127.0.0.1"), HasSubstr("http://evil.example"),
                                                   HasSubstr("origins")),
                                             AllOf(HasSubstr("127.0.0.1"), HasSubstr("wrong token"))));
}

TEST(Refusals, OfManyOneLineTells) {
  RefusalLog log;
  log.note(Refusal::wrong_token, "10.0.0.1");
  EXPECT_THAT(log.take(0).value(), HasSubstr("10.0.0.1"));
  for (int count = 0; count < 5900; ++count) {
    log.note(Refusal::wrong_token, "10.0.0.2");
  }
  EXPECT_FALSE(log.take(RefusalLog::kPeriod_ns - 1));
  log.note(Refusal::foreign_origin, "10.0.0.3");
  EXPECT_THAT(log.take(RefusalLog::kPeriod_ns - 1).value(), HasSubstr("10.0.0.3")) << "of another cause";
  EXPECT_THAT(log.take(RefusalLog::kPeriod_ns).value(), AllOf(HasSubstr("10.0.0.2"), HasSubstr("of 5900")));
  EXPECT_FALSE(log.take(3 * RefusalLog::kPeriod_ns));
}

TEST(Refusals, WaitTheLongerTheMoreThereAre) {
  AddressPatience patience;
  const auto address = boost::asio::ip::make_address("10.0.0.1");
  std::vector<std::int64_t> waits_ms;
  for (int count = 0; count < 11; ++count) {
    waits_ms.push_back(patience.refused(address, 0) / 1'000'000);
  }
  EXPECT_THAT(waits_ms, ElementsAre(0, 0, 0, 50, 100, 200, 400, 800, 1600, 2000, 2000));
  EXPECT_EQ(patience.refused(boost::asio::ip::make_address("10.0.0.2"), 0), 0) << "of another address";
  EXPECT_EQ(patience.refused(address, 60 * kSecond_ns), 0) << "forgotten";
}

TEST(Refusals, WaitWhateverAddressOfItsNetworkAnIpv6ClientTakes) {
  AddressPatience patience;
  std::int64_t wait_ns = 0;
  for (unsigned char count = 0; count < 20; ++count) {
    boost::asio::ip::address_v6::bytes_type bytes{0x20, 0x01, 0x0d, 0xb8};
    bytes[15] = count;
    wait_ns = patience.refused(boost::asio::ip::address_v6(bytes), 0);
  }
  EXPECT_EQ(wait_ns, AddressPatience::kLongestWait_ns);
  EXPECT_EQ(patience.refused(boost::asio::ip::make_address("2001:db8:0:1::1"), 0), 0) << "of another network";
}

TEST(Refusals, AddressesAreNotRememberedWithoutLimit) {
  AddressPatience patience;
  for (std::uint32_t count = 0; count < 5000; ++count) {
    static_cast<void>(patience.refused(boost::asio::ip::address_v4(count), count));
  }
  EXPECT_EQ(patience.addresses(), AddressPatience::kMostAddresses);
}

TEST(Refusals, WhoGuessesWaitsAndWhoKnowsDoesNot) {
  const SecretFiles files;
  ServerOptions options = local();
  options.token_file = files.token();
  RunningServer server(options);
  const auto begin = std::chrono::steady_clock::now();
  for (int count = 0; count < 6; ++count) {
    EXPECT_THAT(answer_to(server, "Authorization: Bearer guess\r\n"), StartsWith("HTTP/1.1 401 "));
  }
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(200));
  RawClient waiting(server.port()), knowing(server.port());
  waiting.send(upgrade_request("Authorization: Bearer guess\r\n"));
  server.await(
      [](const ServerStatistics& statistics, EchoHub&) { return statistics.of(Refusal::wrong_token) == 7; });
  knowing.send(upgrade_request("Authorization: Bearer " + std::string(SecretFiles::kToken) + "\r\n"));
  EXPECT_THAT(knowing.receive_header(), StartsWith("HTTP/1.1 101 "));
  EXPECT_EQ(server.statistics().connected, 2U) << "the other one still waits";
}

}  // namespace
}  // namespace gaitway::api

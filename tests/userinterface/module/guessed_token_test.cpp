// Who guesses tokens waits for being told so, whichever way he shows them: with the handshake, by `auth`, or
// as the view's first message.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <chrono>
#include <string>

#include "module_process.hpp"
#include "raw_client.hpp"
#include "secret_files.hpp"

namespace gaitway::api {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

enum class Way : std::uint8_t { handshake, operation, view };

class GuessedToken : public testing::TestWithParam<Way> {
 protected:
  // Each way from an address of its own, so that what one has guessed is not the other's.
  [[nodiscard]] RawClient client() const {
    process::FileDescriptor result(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in from{};
    from.sin_family = AF_INET;
    from.sin_addr.s_addr = htonl(INADDR_LOOPBACK + 1U + static_cast<unsigned>(GetParam()));
    EXPECT_EQ(bind(result.get(), reinterpret_cast<const sockaddr*>(&from), sizeof from), 0);
    return {std::move(result), module_.port()};
  }
  // Until the server has said what it thinks of it.
  [[nodiscard]] std::string show(const std::string& token) const {
    RawClient client = this->client();
    if (GetParam() == Way::handshake) {
      client.send(upgrade_request("Authorization: Bearer " + token + "\r\n"));
      return client.receive_header();
    }
    client.send(upgrade_request("", GetParam() == Way::view ? "/view" : "/"));
    EXPECT_THAT(client.receive_header(), StartsWith("HTTP/1.1 101 "));
    client.send(masked_frame(
        kText, GetParam() == Way::view ? token : R"({"op": "auth", "token": ")" + token + "\"}"));
    auto frame = client.receive_frame();
    while (frame && frame->opcode != kClose) {
      frame = client.receive_frame();
    }
    return frame ? close_reason(*frame) : "";
  }

  const SecretFiles files_;
  const ModuleProcess module_{{"--token-file", files_.token().string()}};
};

TEST_P(GuessedToken, IsAnsweredLaterAndLater) {
  constexpr int kGuesses = 6;
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kGuesses; ++i) {
    EXPECT_THAT(show("a-guess-of-some-length"), HasSubstr(GetParam() == Way::handshake ? "401 " : "wrong"));
  }
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(300))
      << "50, 100 and 200 ms, less what is forgotten meanwhile";
}

TEST_P(GuessedToken, KeepsNobodyWaitingWhoKnowsIt) {
  constexpr int kGuesses = 8;
  for (int i = 0; i < kGuesses; ++i) {
    static_cast<void>(show("a-guess-of-some-length"));
  }
  const auto begin = std::chrono::steady_clock::now();
  RawClient knowing = client();
  knowing.send(upgrade_request("Authorization: Bearer " + std::string(SecretFiles::kToken) + "\r\n"));
  EXPECT_THAT(knowing.receive_header(), StartsWith("HTTP/1.1 101 "));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(500));
}

std::string name_of(const testing::TestParamInfo<Way>& way) {
  return way.param == Way::handshake ? "Handshake" : way.param == Way::operation ? "Operation" : "View";
}
INSTANTIATE_TEST_SUITE_P(EachWay, GuessedToken, testing::Values(Way::handshake, Way::operation, Way::view),
                         name_of);

}  // namespace
}  // namespace gaitway::api

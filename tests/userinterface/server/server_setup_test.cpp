// What the server refuses to start with, and how it says so.
#include "gaitway/api/server_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "running_server.hpp"
#include "secret_files.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// The error's text, empty when the setup succeeds.
std::string refusal(const ServerOptions& options) {
  try {
    const ServerSetup setup(options);
    return "";
  } catch (const ServerSetupError& error) {
    return error.what();
  }
}

class ServerSetupTest : public testing::Test {
 protected:
  [[nodiscard]] ServerOptions exposed() const {
    ServerOptions options = local();
    options.address = "0.0.0.0";
    options.token_file = files_.token();
    options.certificate_file = files_.certificate();
    options.key_file = files_.key();
    return options;
  }
  SecretFiles files_;
};

TEST_F(ServerSetupTest, ListensAtTheLoopbackAddressUnlessTold) {
  EXPECT_EQ(ServerOptions{}.address, "127.0.0.1");
  const ServerSetup setup(local());
  EXPECT_GT(setup.port(), 0);
  EXPECT_EQ(setup.url(), "ws://127.0.0.1:" + std::to_string(setup.port()));
  EXPECT_FALSE(setup.token());
}

TEST_F(ServerSetupTest, OtherAddressesNeedTlsAndToken) {
  for (const auto* const address : {"0.0.0.0", "192.168.1.2", "::", "fe80::1", "::ffff:127.0.0.1"}) {
    ServerOptions options = local();
    options.address = address;
    EXPECT_THAT(refusal(options), AllOf(StartsWith("address '" + std::string(address) + "'"),
                                        HasSubstr("give certificate_file and key_file, and token_file"),
                                        HasSubstr("127.0.0.1")));
  }
  ServerOptions options = exposed();
  options.token_file.clear();
  EXPECT_THAT(refusal(options), AllOf(HasSubstr("give token_file"), Not(HasSubstr("certificate_file"))));
  options = exposed();
  options.certificate_file.clear();
  options.key_file.clear();
  EXPECT_THAT(refusal(options),
              AllOf(HasSubstr("give certificate_file and key_file"), Not(HasSubstr("token_file"))));
  EXPECT_EQ(refusal(exposed()), "");
}

TEST_F(ServerSetupTest, AddressesMustBeNumeric) {
  for (const auto* const address : {"", "robot.example", "127.0.0", "1.2.3.4.5", "[::1]"}) {
    ServerOptions options = local();
    options.address = address;
    EXPECT_THAT(refusal(options),
                AllOf(StartsWith("address '" + std::string(address) + "'"), HasSubstr("numeric")));
  }
}

TEST_F(ServerSetupTest, ATakenPortIsNamed) {
  const ServerSetup first(local());
  ServerOptions options = local();
  options.port = first.port();
  EXPECT_THAT(refusal(options), AllOf(StartsWith("port " + std::to_string(first.port())),
                                      HasSubstr("taken by another program")));
}

TEST_F(ServerSetupTest, CertificateAndKeyComeTogether) {
  ServerOptions options = local();
  options.certificate_file = files_.certificate();
  EXPECT_THAT(refusal(options), AllOf(StartsWith("key_file ''"), HasSubstr(files_.certificate().native())));
  options = local();
  options.key_file = files_.key();
  EXPECT_THAT(refusal(options), AllOf(StartsWith("certificate_file ''"), HasSubstr(files_.key().native())));
}

TEST_F(ServerSetupTest, CertificateAndKeyMustBelongTogether) {
  ServerOptions options = exposed();
  options.key_file = files_.other_key();
  EXPECT_THAT(refusal(options), AllOf(StartsWith("key_file '" + files_.other_key().native()),
                                      HasSubstr(files_.certificate().native())));
  options = exposed();
  options.certificate_file = files_.write("nonsense.pem", "no certificate");
  EXPECT_THAT(refusal(options), StartsWith("certificate_file '" + options.certificate_file.native()));
  options.certificate_file = "/nowhere/certificate.pem";
  EXPECT_THAT(refusal(options), StartsWith("certificate_file '/nowhere/certificate.pem'"));
}

// A pipe, say, of which nobody says anything.
TEST_F(ServerSetupTest, CertificateAndKeyAreRegularFiles) {
  ServerOptions options = exposed();
  options.certificate_file = "/dev/null";
  EXPECT_THAT(refusal(options), StartsWith("certificate_file '/dev/null': is no regular file"));
  options = exposed();
  options.key_file = "/dev/null";
  EXPECT_THAT(refusal(options), StartsWith("key_file '/dev/null': is no regular file"));
}

TEST_F(ServerSetupTest, AKeyThatEverybodyCanReadIsRefused) {
  ASSERT_EQ(chmod(files_.key().c_str(), 0644), 0);
  EXPECT_THAT(refusal(exposed()),
              AllOf(StartsWith("key_file"), HasSubstr("chmod o= " + files_.key().native())));
}

TEST_F(ServerSetupTest, ATokenThatOthersCanReadIsRefused) {
  for (const mode_t mode : {0640U, 0604U, 0660U, 0601U}) {
    ASSERT_EQ(chmod(files_.token().c_str(), mode), 0);
    EXPECT_THAT(refusal(exposed()), AllOf(StartsWith("token_file '" + files_.token().native()),
                                          HasSubstr("`chmod 600 " + files_.token().native() + "`")))
        << mode;
  }
  ASSERT_EQ(chmod(files_.token().c_str(), 0400), 0);
  EXPECT_EQ(refusal(exposed()), "");
}

TEST_F(ServerSetupTest, ATokenHas16To4096VisibleCharacters) {
  ServerOptions options = exposed();
  const auto with = [&](const std::string& text) {
    options.token_file = files_.write("tried", text);
    return refusal(options);
  };
  EXPECT_EQ(with(std::string(16, 't')), "");
  EXPECT_EQ(with(std::string(4096, 't') + "\n"), "");
  EXPECT_THAT(with(std::string(15, 't') + "\n"), AllOf(StartsWith("token_file"), HasSubstr("has 15 bytes")));
  EXPECT_THAT(with(std::string(4097, 't')), HasSubstr("has 4097 bytes"));
  EXPECT_THAT(with(std::string(100'000, 't')), HasSubstr("16 to 4096"));
  EXPECT_THAT(with("two words are no token"), HasSubstr("visible ASCII"));
  EXPECT_THAT(with(std::string(16, 't') + "\n\n"), HasSubstr("visible ASCII"));
  options.token_file = "/nowhere/token";
  EXPECT_THAT(refusal(options), AllOf(StartsWith("token_file '/nowhere/token'"), HasSubstr("umask 077")));
  options.token_file = "/tmp";
  EXPECT_THAT(refusal(options), HasSubstr("no regular file"));
}

TEST_F(ServerSetupTest, TheTokenIsTheFilesContentWithoutItsLineEnd) {
  const ServerSetup setup(exposed());
  ASSERT_TRUE(setup.token());
  EXPECT_TRUE(setup.token()->matches(SecretFiles::kToken));
  const std::string token(SecretFiles::kToken);
  for (const std::string& wrong :
       {token + "\n", token + "x", token.substr(1), std::string(), "X" + token.substr(1)}) {
    EXPECT_FALSE(setup.token()->matches(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace gaitway::api

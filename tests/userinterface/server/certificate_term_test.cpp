// What people are told of a certificate that does not count, or will not for long.
#include "gaitway/api/certificate_term.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

#include "gaitway/api/server_setup.hpp"
#include "running_server.hpp"
#include "secret_files.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::int64_t kNewYear_s = 1'767'225'600;  // 2026-01-01 00:00 UTC
constexpr std::int64_t kHour_s = 3600;

const CertificateTerm kTerm{.file = "/etc/cert.pem",
                            .begins_last = "robot.local",
                            .ends_first = "robot.local",
                            .begin_s = kNewYear_s,
                            .end_s = kNewYear_s + 90 * kDay_s};

TEST(CertificateTerm, NamesFileSubjectDateDaysAndRemedy) {
  EXPECT_THAT(trouble_of(kTerm, kNewYear_s), IsEmpty());
  EXPECT_THAT(trouble_of(kTerm, kTerm.end_s - kShortTerm_s), IsEmpty());
  EXPECT_THAT(trouble_of(kTerm, kTerm.end_s - kShortTerm_s + kHour_s),
              AllOf(HasSubstr("certificate_file '/etc/cert.pem'"), HasSubstr("of 'robot.local'"),
                    HasSubstr("expires on 2026-04-01 00:00 UTC, in 13 days"), HasSubstr("renew it before")));
  EXPECT_THAT(
      trouble_of(kTerm, kTerm.end_s + 3 * kDay_s),
      AllOf(HasSubstr("expired on 2026-04-01 00:00 UTC, 3 days ago"), HasSubstr("start the module anew")));
  EXPECT_THAT(trouble_of(kTerm, kNewYear_s - kHour_s),
              AllOf(HasSubstr("is not valid before 2026-01-01 00:00 UTC, in less than a day"),
                    HasSubstr("clock, which shows 2025-12-31 23:00 UTC")));
}

TEST(CertificateTerm, IsReadFromTheFileAndRefusesNobody) {
  const SecretFiles files(SecretFiles::KeyKind::elliptic, {-10 * SecretFiles::kDay, -SecretFiles::kDay});
  ServerOptions options = local();
  options.token_file = files.token();
  options.certificate_file = files.certificate();
  options.key_file = files.key();
  {
    const ServerSetup setup(options);
    ASSERT_TRUE(setup.certificate_term());
    EXPECT_THAT(
        trouble_of(*setup.certificate_term(), std::time(nullptr)),
        AllOf(HasSubstr(files.certificate().native()), HasSubstr("of 'localhost' in certificate_file"),
              HasSubstr("expired on"), HasSubstr("1 day ago")));
  }
  RunningServer server(options);
  WebSocketClient client(server.port(),
                         {.headers = {{"Authorization", "Bearer " + std::string(SecretFiles::kToken)}},
                          .tls = true,
                          .highest_tls = 0});
  client.send("as ever");
  EXPECT_EQ(client.receive().text, "as ever");
}

// Its issuer's dates are not taken for its own.
TEST(CertificateTerm, OneWithoutANameBeforeItsIssuerIsSpokenOf) {
  const SecretFiles own(SecretFiles::KeyKind::elliptic, {-10 * SecretFiles::kDay, -SecretFiles::kDay}, "");
  const SecretFiles issuer(SecretFiles::KeyKind::elliptic, {-10 * SecretFiles::kDay, 90 * SecretFiles::kDay});
  std::ostringstream chain;
  for (const SecretFiles* files : {&own, &issuer}) {
    chain << std::ifstream(files->certificate()).rdbuf();
  }
  ServerOptions options = local();
  options.token_file = own.token();
  options.certificate_file = own.write("chain.pem", chain.str());
  options.key_file = own.key();
  const ServerSetup setup(options);
  ASSERT_TRUE(setup.certificate_term());
  EXPECT_THAT(trouble_of(*setup.certificate_term(), std::time(nullptr)),
              AllOf(HasSubstr("of 'no name, serial number 01'"), HasSubstr("1 day ago")));
}

TEST(CertificateTerm, OfNoCertificateThereIsNone) {
  EXPECT_FALSE(ServerSetup(local()).certificate_term());
}

TEST(CertificateWatch, SaysItWhenItBeginsDailyAndWhenItEnds) {
  CertificateWatch watch(kTerm);
  const std::int64_t short_s = kTerm.end_s - kShortTerm_s + 1;
  EXPECT_FALSE(watch.look(short_s - kHour_s, 0));
  EXPECT_THAT(watch.look(short_s, 0).value(), HasSubstr("in 13 days"));
  EXPECT_FALSE(watch.look(short_s + kDay_s - 1, 0));
  EXPECT_THAT(watch.look(short_s + kDay_s, 0).value(), HasSubstr("in 12 days"));
  EXPECT_TRUE(watch.look(kTerm.end_s - kHour_s, 0));
  EXPECT_THAT(watch.look(kTerm.end_s + 1, 0).value(), HasSubstr("expired on"))
      << "though a day has not passed";
  EXPECT_THAT(watch.trouble(), HasSubstr("expired on"));
}

TEST(CertificateWatch, CountsNoHandshakesThatFailedWhileNothingWasWrong) {
  CertificateWatch watch(kTerm);
  EXPECT_FALSE(watch.look(kNewYear_s + kDay_s, 50));
  EXPECT_THAT(watch.look(kTerm.end_s + kDay_s, 52).value(), HasSubstr("(2 TLS handshakes"));
}

TEST(CertificateWatch, SaysItAgainWhenHandshakesFailAndNeverInAFlood) {
  CertificateWatch watch(kTerm);
  const std::int64_t late_s = kTerm.end_s + kDay_s;
  EXPECT_TRUE(watch.look(late_s, 0));
  EXPECT_FALSE(watch.look(late_s + 599, 5));
  EXPECT_THAT(watch.look(late_s + 600, 7).value(), HasSubstr("7 TLS handshakes have failed"));
  EXPECT_FALSE(watch.look(late_s + 1300, 7));
}

TEST(CertificateWatch, FollowsAClockThatIsSet) {
  CertificateWatch watch(kTerm);
  EXPECT_THAT(watch.look(0, 0).value(), HasSubstr("is not valid before"));
  EXPECT_FALSE(watch.look(kNewYear_s + kDay_s, 0));
  EXPECT_THAT(watch.trouble(), IsEmpty());
}

}  // namespace
}  // namespace gaitway::api

// Which web pages may connect.
#include "gaitway/api/admission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gaitway::api {
namespace {

TEST(OriginRule, LetsInPagesOfThisMachineOnAnyPort) {
  const OriginRule rule;
  for (const auto* const origin :
       {"http://localhost", "http://localhost:8080", "https://localhost:1", "http://127.0.0.1:3000",
        "HTTP://LocalHost:80", "https://[::1]:9090", "http://[::1]"}) {
    EXPECT_TRUE(rule.allows(origin)) << origin;
  }
}

TEST(OriginRule, RefusesAllOthers) {
  const OriginRule rule;
  for (const auto* const origin :
       {"null", "file://", "", "http://", "http://evil.example", "http://localhost.evil.example",
        "http://evil.example/http://localhost", "http://localhost@evil.example", "ftp://localhost",
        "localhost", "http://localhost:", "http://localhost:80x", "http://localhost:123456",
        "http://127.0.0.2", "http://[::2]", "http://localhost http://evil.example",
        "chrome-extension://localhost"}) {
    EXPECT_FALSE(rule.allows(origin)) << origin;
  }
}

TEST(OriginRule, LetsInExactlyThoseListed) {
  const std::vector<std::string> listed{"https://Robot.example:8443", "http://dashboard.example:80"};
  const OriginRule rule(listed);
  EXPECT_TRUE(rule.allows("https://robot.example:8443"));
  EXPECT_TRUE(rule.allows("http://dashboard.example"));
  EXPECT_FALSE(rule.allows("https://robot.example"));
  EXPECT_FALSE(rule.allows("http://robot.example:8443"));
  EXPECT_FALSE(rule.allows("null"));
}

TEST(OriginRule, PagesOfThisMachineNeedNotBeListed) {
  const std::vector<std::string> listed{"https://robot.example:8443"};
  const OriginRule rule(listed);
  EXPECT_TRUE(rule.allows("http://localhost:8080"));
  EXPECT_TRUE(rule.allows("http://[::1]"));
}

TEST(OriginRule, PagesFromFilesAreLetInWhereTheyAreListed) {
  const std::vector<std::string> listed{"null", "file://"};
  const OriginRule rule(listed);
  EXPECT_TRUE(rule.allows("null"));
  EXPECT_TRUE(rule.allows("file://"));
  EXPECT_FALSE(rule.allows("file:///page.html"));
  EXPECT_FALSE(rule.allows(""));
}

TEST(OriginRule, RefusesEntriesThatAreNoOrigins) {
  for (const auto* const entry :
       {"*", "Null", "robot.example", "https://robot.example/page", "file:///page"}) {
    const std::vector<std::string> listed{entry};
    try {
      const OriginRule rule(listed);
      ADD_FAILURE() << entry;
    } catch (const ServerSetupError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("origins: '" + std::string(entry) + "'"));
    }
  }
}

}  // namespace
}  // namespace gaitway::api

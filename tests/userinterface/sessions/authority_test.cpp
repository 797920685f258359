// One commander at a time: the lease by itself, told the time.
#include "gaitway/api/authority.hpp"

#include <gtest/gtest.h>

#include <set>

namespace gaitway::api {
namespace {

constexpr std::int64_t kLease_ns = 1'000;

class AuthorityTest : public testing::Test {
 protected:
  Authority authority{kLease_ns};
  Claimant anna{.number = 1, .name = "anna"};
  Claimant bert{.number = 2, .name = "bert"};
};

TEST_F(AuthorityTest, GivesTheCommandToOneOnly) {
  const std::string lease = authority.acquire(anna, 0);
  EXPECT_EQ(authority.holder(), "anna");
  EXPECT_THROW(authority.acquire(bert, 1), CommandDenied);
  EXPECT_THROW(authority.use(bert, 1), CommandDenied);
  EXPECT_TRUE(authority.held_by(anna));
  EXPECT_FALSE(authority.held_by(bert));
}

TEST_F(AuthorityTest, SaysWhoHasTheCommand) {
  authority.use(anna, 0);
  try {
    authority.use(bert, 0);
    FAIL() << "two commanders";
  } catch (const CommandDenied& denied) {
    EXPECT_NE(std::string(denied.what()).find("\"anna\""), std::string::npos) << denied.what();
  }
}

TEST_F(AuthorityTest, LapsesAfterALeaseWithoutASign) {
  authority.acquire(anna, 0);
  EXPECT_FALSE(authority.lapse(kLease_ns - 1));
  EXPECT_TRUE(authority.lapse(kLease_ns));
  EXPECT_FALSE(authority.lapse(kLease_ns + 1)) << "told once";
  EXPECT_EQ(authority.holder(), "");
  authority.use(bert, kLease_ns + 1);
  EXPECT_TRUE(authority.held_by(bert));
}

TEST_F(AuthorityTest, TellsOfALapseThatSomebodyElsesCommandFound) {
  authority.use(anna, 0);
  authority.use(bert, kLease_ns);
  EXPECT_TRUE(authority.lapse(kLease_ns));
  EXPECT_TRUE(authority.held_by(bert));
}

TEST_F(AuthorityTest, EachCommandAndEachKeepAliveRenewsTheLease) {
  const std::string lease = authority.acquire(anna, 0);
  authority.use(anna, 900);
  EXPECT_FALSE(authority.lapse(1800));
  authority.keep_alive(anna, lease, 1800);
  EXPECT_FALSE(authority.lapse(2700));
  EXPECT_TRUE(authority.lapse(2800));
}

TEST_F(AuthorityTest, ALeaseIsWorthNothingOnAnotherConnection) {
  const std::string lease = authority.acquire(anna, 0);
  EXPECT_THROW(authority.keep_alive(bert, lease, 1), CommandDenied);
  EXPECT_THROW(authority.release(bert, lease, 1), CommandDenied);
  EXPECT_TRUE(authority.held_by(anna));
}

TEST_F(AuthorityTest, AnOldLeaseIsWorthNothing) {
  const std::string old = authority.acquire(anna, 0);
  authority.release(anna, old, 1);
  EXPECT_THROW(authority.keep_alive(anna, old, 2), CommandDenied);
  const std::string fresh = authority.acquire(anna, 3);
  EXPECT_NE(fresh, old);
  EXPECT_THROW(authority.keep_alive(anna, old, 4), CommandDenied);
  EXPECT_NO_THROW(authority.keep_alive(anna, fresh, 4));
  EXPECT_THROW(authority.keep_alive(anna, fresh, 4 + kLease_ns), CommandDenied) << "it has lapsed";
}

TEST_F(AuthorityTest, LeasesAreLongAndNeverTheSame) {
  std::set<std::string> leases;
  for (int i = 0; i < 1000; ++i) {
    const std::string lease = authority.acquire(anna, i);
    EXPECT_EQ(lease.size(), 32U);
    leases.insert(lease);
    authority.release(anna, lease, i);
  }
  EXPECT_EQ(leases.size(), 1000U);
}

TEST_F(AuthorityTest, AskingAgainGivesTheSameLease) {
  const std::string lease = authority.acquire(anna, 0);
  EXPECT_EQ(authority.acquire(anna, 10), lease);
}

TEST_F(AuthorityTest, EndsWithItsConnection) {
  authority.use(anna, 0);
  EXPECT_FALSE(authority.leave(bert));
  EXPECT_TRUE(authority.leave(anna));
  EXPECT_FALSE(authority.leave(anna));
  EXPECT_NO_THROW(authority.use(bert, 1));
}

TEST_F(AuthorityTest, AStickThatIsStillHeldDoesNotUndoSomebodyElsesStop) {
  authority.use(anna, 0);
  authority.stop(bert);
  EXPECT_EQ(authority.holder(), "");
  for (std::int64_t now_ns = 100; now_ns < 10 * kLease_ns; now_ns += 100) {
    EXPECT_THROW(authority.use(anna, now_ns), CommandDenied);
  }
  EXPECT_NO_THROW(authority.use(anna, 9900 + kLease_ns)) << "let go for a lease's length";
}

TEST_F(AuthorityTest, AStopConcernsAlsoWhoWasWaitingForTheCommand) {
  Claimant carl{.number = 3, .name = "carl"};
  authority.use(anna, 0);
  EXPECT_THROW(authority.use(carl, 0), CommandDenied);
  authority.stop(bert);
  EXPECT_THROW(authority.use(carl, 100), CommandDenied);
}

TEST_F(AuthorityTest, AfterAStopWhoAsksForTheCommandHasIt) {
  authority.use(anna, 0);
  authority.stop(bert);
  EXPECT_THROW(authority.use(anna, 100), CommandDenied);
  authority.acquire(anna, 200);
  EXPECT_NO_THROW(authority.use(anna, 210));
}

TEST_F(AuthorityTest, WhoStopsKeepsTheCommand) {
  authority.use(anna, 0);
  authority.stop(anna);
  EXPECT_TRUE(authority.held_by(anna));
  EXPECT_NO_THROW(authority.use(anna, 10));
}

}  // namespace
}  // namespace gaitway::api

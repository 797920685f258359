// What people are told of the link, and when.
#include "gaitway/api/link_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

using facts::kMillisecond_ns;
using facts::kSecond_ns;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class LinkWatchTest : public testing::Test {
 protected:
  // So long it is so.
  void pass(const LinkSight& sight, std::int64_t duration_ns) {
    for (const std::int64_t end_ns = now_ns_ + duration_ns; now_ns_ < end_ns;) {
      now_ns_ += kMillisecond_ns;
      if (auto line = watch_.look(sight, now_ns_)) lines_.push_back(*line);
    }
  }
  [[nodiscard]] ros::LinkState state() const {
    return link_state_of(watch_.report(), "unix:/run/link", now_ns_);
  }

  std::int64_t now_ns_ = 5 * kSecond_ns;
  LinkWatch watch_{{.kind = link::LinkAddress::Kind::unix_socket, .path = "/run/link"}, 5 * kSecond_ns};
  std::vector<std::string> lines_;
  const LinkSight up_{.open = true, .why = link::SessionEnd::none};
  const LinkSight cut_{.why = link::SessionEnd::cut,
                       .description = "the other end has closed the connection"};
  const LinkSight nobody_{
      .why = link::SessionEnd::cut, .description = "-", .error = "link '/run/link': nobody listens"};
  const LinkSight refused_{.why = link::SessionEnd::occupied, .description = "refused: by name"};
};

TEST_F(LinkWatchTest, TellsWhyThereIsNoneOnceItLasts) {
  EXPECT_THAT(state().text, HasSubstr("connecting to the main controller at unix:/run/link"));
  pass(nobody_, kSecond_ns);
  EXPECT_THAT(lines_, IsEmpty());
  pass(nobody_, 3 * kSecond_ns);
  EXPECT_THAT(lines_, ElementsAre("no link to the main controller: link '/run/link': nobody listens"));
  EXPECT_EQ(state().state, "down");
  EXPECT_EQ(state().text, "link '/run/link': nobody listens");
  EXPECT_EQ(state().link, "unix:/run/link");
  EXPECT_NEAR(state().seconds, 4.0, 1e-9);
}

TEST_F(LinkWatchTest, ALostLinkIsToldAtOnceAndOneThatIsSoonBackIsToldOfNoMore) {
  pass(up_, kSecond_ns);
  EXPECT_EQ(state().state, "up");
  pass(cut_, kMillisecond_ns);
  EXPECT_EQ(state().state, "down");
  EXPECT_THAT(state().text, AllOf(HasSubstr("is lost"), HasSubstr("closed the connection")));
  pass(nobody_, 400 * kMillisecond_ns);
  pass(refused_, 400 * kMillisecond_ns);
  pass(nobody_, 400 * kMillisecond_ns);
  pass(up_, kMillisecond_ns);
  EXPECT_THAT(lines_, ElementsAre("linked to the main controller", HasSubstr("is lost"),
                                  "linked to the main controller"));
  EXPECT_EQ(state().state, "up");
  EXPECT_THAT(state().text, IsEmpty());
}

TEST_F(LinkWatchTest, ARefusalIsAStateOfItsOwnSinceTheLinkWasLost) {
  pass(up_, kSecond_ns);
  pass(cut_, kSecond_ns / 2);
  pass(refused_, 2 * kSecond_ns);
  EXPECT_EQ(state().state, "refused");
  EXPECT_EQ(state().text, "refused: by name");
  EXPECT_NEAR(state().seconds, 2.5, 0.01);
  pass(nobody_, 2 * kSecond_ns);
  EXPECT_EQ(state().state, "down") << "who refused it is gone";
}

TEST_F(LinkWatchTest, WhoConnectsAndHearsNobodyIsToldWhatToLookFor) {
  pass({.why = link::SessionEnd::not_begun, .description = "nobody was heard yet"}, 2 * kSecond_ns);
  EXPECT_THAT(state().text,
              AllOf(HasSubstr("'unix:/run/link': nobody was heard yet"), HasSubstr("plug-in api")));
}

TEST_F(LinkWatchTest, AnotherCalibrationIsToldOfALinkThatIsUp) {
  LinkSight other = up_;
  other.same_calibration = false;
  pass(other, kSecond_ns);
  EXPECT_EQ(state().state, "up");
  EXPECT_THAT(state().text,
              AllOf(HasSubstr("another calibration.yaml"), HasSubstr("Copy the main controller's")));
  EXPECT_THAT(lines_,
              ElementsAre(AllOf(HasSubstr("linked to the main controller, but"), HasSubstr("calibration"))));
}

}  // namespace
}  // namespace gaitway::api

// A plug-in whose answer comes with the next step: what meets its step while that is under way, and what
// becomes of its fault and of what it published.
#include <gmock/gmock.h>

#include "isolation/local_sockets_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::HasSubstr;

class NextStepOfAServer : public LocalSockets {};

TEST_F(NextStepOfAServer, InRealTimeNoTickWaitsForOneThatAnswersNextStep) {
  isolation.lock_step = false;
  manager = load(relays() + server(", answer: next_step, budget: 25 ms"));
  ASSERT_EQ(ask("step wait"), 0);
  ASSERT_EQ(step(), 0);
  while (ask("waits") != 1) {  // its thread tells when its step has begun
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(step(), 0) << "within its budget it is left alone";
    EXPECT_EQ(relayed(), 100.0 + number);
  }
  EXPECT_EQ(step(), 1);
  EXPECT_THAT(fault(), HasSubstr("did not answer within 25 ms"));
  EXPECT_EQ(step(), 1);
  EXPECT_THAT(fault(), HasSubstr("has not answered for 40 ms"));
  EXPECT_EQ(relayed(), 100.0 + number);
  EXPECT_EQ(service(), ServiceState::failing);
}

}  // namespace
}  // namespace gaitway::core

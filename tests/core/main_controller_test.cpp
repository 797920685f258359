// Hand-overs, trims, local refusals and answers, with a message controller played by the test.
#include "gaitway/core/main_controller.hpp"

#include <gmock/gmock.h>

#include "main_controller_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::HasSubstr;

class MainControllerTest : public MainControllerFixture {};

TEST_F(MainControllerTest, HandsOverTheBatchOfTheNextCycle) {
  start("none");
  for (std::uint32_t cycle = 1; cycle <= 3; ++cycle) {
    const TickReport report = batch_tick();
    EXPECT_TRUE(report.handed_over);
    EXPECT_GT(report.transfer_ns, 0);
    EXPECT_EQ(now_ns, std::int64_t{cycle} * 80'000'000 - 16'000'000);
    ASSERT_TRUE(batch_taken);
    EXPECT_EQ(batch->sequence, cycle);
    EXPECT_EQ(batch->joint_count, 22U);
    EXPECT_EQ(batch->point_count, 24U);
    EXPECT_EQ(batch->support[0], 2);
    EXPECT_EQ(batch->position_at(23, 3), static_cast<float>(robot.joints[3].home_rad));
    EXPECT_EQ(batch->trim.channel_count, 8U);
    EXPECT_EQ(batch->trim.gain[0][2][1], 0.25F);
    answer(msgclient::Verdict::accepted);
  }
  tick();
  const MainControllerStatistics statistics = controller->statistics();
  EXPECT_EQ(statistics.handed_over, 3U);
  EXPECT_EQ(statistics.answers[0], 3U);
  EXPECT_EQ(statistics.ticks, 24U);  // ticks 0 to 22 and one more
  EXPECT_GT(statistics.batch_compute_us.max, 0.0);
  EXPECT_LE(statistics.batch_compute_us.p50, statistics.batch_compute_us.max);
}

TEST_F(MainControllerTest, PostsNewTrimsAtEveryTick) {
  start("none");
  for (int i = 0; i < 5; ++i) {
    const TickReport report = tick();
    EXPECT_TRUE(report.posted);
    EXPECT_FALSE(report.handed_over);
    ASSERT_TRUE(trim_taken);
    EXPECT_EQ(trim.stamp_ns, now_ns);
    EXPECT_EQ(trim.channel_count, 8U);
    EXPECT_EQ(trim.angle[3], 0.01F);
  }
  EXPECT_EQ(controller->statistics().trims_posted, 5U);
}

TEST_F(MainControllerTest, FaultOfThePlannerHoldsTheBatchBack) {
  start("throw");
  EXPECT_FALSE(batch_tick().handed_over);
  EXPECT_FALSE(batch_taken);
  const MainControllerStatistics statistics = controller->statistics();
  EXPECT_EQ(statistics.spoiled, 1U);
  EXPECT_EQ(statistics.handed_over, 0U);
  EXPECT_EQ(statistics.plugins[0].faults, 1U);
  EXPECT_EQ(statistics.last_refusal, "batch 1 is not handed over: plug-in 'planner' failed");
}

TEST_F(MainControllerTest, PlanThatBreaksARuleIsRefusedHere) {
  start("not_a_number");
  EXPECT_FALSE(batch_tick().handed_over);
  const MainControllerStatistics statistics = controller->statistics();
  EXPECT_EQ(statistics.refused_locally, 1U);
  EXPECT_EQ(statistics.refused_points, 1U);
  EXPECT_THAT(statistics.last_refusal, HasSubstr("batch 1: joint 'left_ankle_roll', point 3 (batch)"));
  ASSERT_EQ(controller->events().total(), 1U);
  EXPECT_EQ(controller->events()[0].kind, EventKind::refusal);
}

TEST_F(MainControllerTest, PlanThatDoesNotGoOnFromTheReferenceIsRefusedHere) {
  start("jump");
  EXPECT_FALSE(batch_tick().handed_over);
  EXPECT_THAT(controller->statistics().last_refusal, HasSubstr("must go on from the joint's reference"));
}

TEST_F(MainControllerTest, PlanOfAnotherCycleIsNoPlan) {
  start("old_sequence");
  EXPECT_FALSE(batch_tick().handed_over);
  EXPECT_EQ(controller->statistics().without_plan, 1U);
}

// What a new planner is for is a plan: without one for the batch it has failed its trial.
TEST_F(MainControllerTest, NewPlannerWithoutAPlanFailsItsTrialAndTheOldOnePlansOn) {
  start("none");
  ASSERT_TRUE(batch_tick().handed_over);
  answer(msgclient::Verdict::accepted);
  PluginManager& plugins = controller->plugins();
  for (const char* const defect : {"silent", "old_sequence"}) {
    ASSERT_TRUE(plugins.changes().schedule(plugins.changes().prepare_replacement(
        {.name = "planner", .library = "joint_planner.so", .parameters = {{"defect", defect, 0}}})));
    EXPECT_TRUE(batch_tick().handed_over) << defect;
    answer(msgclient::Verdict::accepted);
    const auto result = plugins.changes().take_result();
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->done) << result->text;
    EXPECT_THAT(std::string(result->text), HasSubstr("no plug-in has a plan for it"));
    EXPECT_TRUE(batch_tick().handed_over) << defect;
    answer(msgclient::Verdict::accepted);
  }
  EXPECT_EQ(controller->statistics().without_plan, 0U);
}

TEST_F(MainControllerTest, PlugInThatIsNotBehindThePlanIsNotToBlameForIt) {
  start("none");
  ASSERT_TRUE(batch_tick().handed_over);
  answer(msgclient::Verdict::accepted);
  PluginManager& plugins = controller->plugins();
  ASSERT_TRUE(plugins.changes().schedule(
      plugins.changes().prepare_addition({.name = "counter", .library = "counter.so"})));
  states.joint_count = 0;
  network.mode = 0;
  publish();
  batch_tick();
  const auto result = plugins.changes().take_result();
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->done) << result->text;
}

TEST_F(MainControllerTest, ARowOfBatchesWithoutAPlanIsSaidOnce) {
  start("stops_after_two");
  for (int i = 0; i < 5; ++i) {
    if (batch_tick().handed_over) {
      answer(msgclient::Verdict::accepted);
    }
  }
  EXPECT_EQ(controller->statistics().without_plan, 3U);
  ASSERT_EQ(controller->events().total(), 1U);
  EXPECT_EQ(controller->events()[0].text(),
            "batch 3 is not handed over: no plug-in has a plan for it; the newest is of batch 2");
}

// 0.001 rad a point, the batch's eight: the next batch goes on from there, not from where the joints stood.
TEST_F(MainControllerTest, ContinuityIsCheckedAgainstTheAcceptedBatchWhileItPlays) {
  start("drift");
  ASSERT_TRUE(batch_tick().handed_over);
  answer(msgclient::Verdict::accepted);
  network.mode = 0;
  states.reference_position[3] += 1.0;  // must not count while a batch plays
  publish();
  EXPECT_TRUE(batch_tick().handed_over) << controller->statistics().last_refusal;
  answer(msgclient::Verdict::accepted);
  network.mode = 2;
  publish();
  EXPECT_FALSE(batch_tick().handed_over);
  EXPECT_THAT(controller->statistics().last_refusal, HasSubstr("'left_knee', point 0"));
}

TEST_F(MainControllerTest, AnswersAreCountedByVerdict) {
  start("none");
  batch_tick();
  answer(msgclient::Verdict::late, msgclient::Reason::too_late);
  batch_tick();
  answer(msgclient::Verdict::refused, msgclient::Reason::jump);
  tick();
  const MainControllerStatistics statistics = controller->statistics();
  EXPECT_EQ(statistics.answers[static_cast<std::size_t>(msgclient::Verdict::late)], 1U);
  EXPECT_EQ(statistics.answers[static_cast<std::size_t>(msgclient::Verdict::refused)], 1U);
  EXPECT_THAT(statistics.last_refusal, HasSubstr("batch 2 refused"));
  EXPECT_THAT(statistics.last_refusal, HasSubstr(" (joint 3, point 0, 0)"));
}

TEST_F(MainControllerTest, ARefusalThatIsAboutNoJointNamesNone) {
  start("none");
  batch_tick();
  ASSERT_TRUE(emi.message().answer({.mail = msgclient::MailKind::hand_over,
                                    .sequence = batch->sequence,
                                    .verdict = msgclient::Verdict::late,
                                    .reason = msgclient::Reason::too_late}));
  tick();
  EXPECT_THAT(controller->statistics().last_refusal, HasSubstr("batch 1 late: "));
  EXPECT_THAT(controller->statistics().last_refusal, testing::Not(HasSubstr("joint")));
}

TEST_F(MainControllerTest, DamagedMailIsAnsweredAsCorrupt) {
  start("none");
  emi.host().faults().flip_next = msgclient::EmiFaults::Flip{msgclient::MailKind::hand_over, 40, 0x10};
  EXPECT_TRUE(batch_tick().handed_over);
  EXPECT_FALSE(batch_taken);
  tick();
  EXPECT_EQ(controller->statistics().answers[static_cast<std::size_t>(msgclient::Verdict::corrupt)], 1U);
}

TEST_F(MainControllerTest, StuckBusIsCounted) {
  start("none");
  emi.host().faults().bus_stuck = true;
  EXPECT_FALSE(batch_tick().posted);
  const MainControllerStatistics statistics = controller->statistics();
  EXPECT_EQ(statistics.not_posted, 1U);
  EXPECT_EQ(statistics.trims_not_posted, 7U);
  EXPECT_THAT(statistics.last_refusal, HasSubstr("bus is stuck"));
}

TEST_F(MainControllerTest, MeasuresNothingWithoutAClock) {
  start("none", nullptr);
  batch_tick();
  EXPECT_EQ(controller->statistics().batch_compute_us.max, 0.0);
  EXPECT_EQ(controller->statistics().plugins[0].step_us.max, 0.0);
}

TEST_F(MainControllerTest, MissingConfigurationIsAnError) {
  MainControllerOptions options;
  options.configuration = "/nowhere/walk.yaml";
  EXPECT_THROW(MainController(robot, client, emi.host(), options), ConfigurationError);
}

std::string text_of(const gaitway::Event& event) {
  return std::string(reinterpret_cast<const char*>(event.source)) + ": " +
         reinterpret_cast<const char*>(event.text);
}

TEST_F(MainControllerTest, PublishesItsEventsInOrderAFewATick) {
  start("none");
  auto reader = message_client.read_stream<gaitway::Event>("events");
  EXPECT_EQ(message_client.find("events")->writer, "main_controller");
  EventLog& events = controller->plugins().events();
  for (int i = 0; i < 40; ++i) {
    events.add(1000 + i, 0, EventKind::warning, "leg", "line " + std::to_string(i));
  }
  gaitway::Event event{};
  int next = 0;
  for (const int published : {16, 32, 40, 40}) {
    controller->maintain(now_ns);
    for (; reader.read(event); ++next) {
      EXPECT_EQ(text_of(event), "leg: line " + std::to_string(next));
      EXPECT_EQ(event.stamp_ns, 1000 + next);
      EXPECT_EQ(event.kind, static_cast<std::uint32_t>(EventKind::warning));
    }
    EXPECT_EQ(next, published);
  }
  EXPECT_EQ(controller->statistics().events_missed, 0U);
}

TEST_F(MainControllerTest, CountsEventsThatWereTooManyToPublish) {
  start("none");
  auto reader = message_client.read_stream<gaitway::Event>("events");
  for (std::size_t i = 0; i < EventLog::kCapacity + 10; ++i) {
    controller->plugins().events().add(0, 0, EventKind::info, "leg", std::to_string(i));
  }
  controller->maintain(now_ns);
  gaitway::Event event{};
  ASSERT_TRUE(reader.read(event));
  EXPECT_EQ(text_of(event), "leg: 10");
  EXPECT_EQ(controller->statistics().events_missed, 10U);
}

TEST_F(MainControllerTest, PublishesEventsToAReaderThatCameFirst) {
  auto reader = message_client.read_stream<gaitway::Event>("events");
  start("throw");
  batch_tick();
  controller->maintain(now_ns);
  gaitway::Event event{};
  ASSERT_TRUE(reader.read(event));
  EXPECT_THAT(text_of(event), testing::StartsWith("planner: "));
}

}  // namespace
}  // namespace gaitway::core

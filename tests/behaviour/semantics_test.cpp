// What each node does, tick by tick. Each row was written from the reference, BehaviorTree.CPP 4.10, ticked
// by tickExactlyOnce(); rows of the second table are where README.md says that trees differ here.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "scripted_leaves.hpp"

namespace gaitway::behaviour::test {
namespace {

struct Row {
  const char* name;
  const char* nodes;
  const char* trace;  // see scripted_leaves.hpp
};
std::ostream& operator<<(std::ostream& stream, const Row& row) {
  return stream << row.name;
}

int ticks_of(const std::string& trace) {
  return static_cast<int>(std::count(trace.begin(), trace.end(), '='));
}

class Semantics : public testing::TestWithParam<Row> {};

TEST_P(Semantics, OfTheNodeTickByTick) {
  Script script;
  Tree tree(described(GetParam().nodes, script), script.registry());
  EXPECT_EQ(trace(tree, script, ticks_of(GetParam().trace)), GetParam().trace) << GetParam().nodes;
}

const Row kAsTheReference[] = {
    {"SequenceGoesOnAtTheRunningChild", R"(<Sequence><P/><A does="RRS"/><B does="RS"/></Sequence>)",
     "P?S A+R =R | A.R =R | A.S B+R =R | B.S =S | P?S A+R =R"},
    {"SequenceFailsAndBeginsAnew", R"(<Sequence><A/><B does="RF"/><C/></Sequence>)",
     "A+S B+R =R | B.F =F | A+S B+R =R"},
    {"SequencePassesOverSkipped", R"(<Sequence><A does="K"/><B/></Sequence>)", "A+K B+S =S"},
    {"SequenceOfSkippedIsSkipped", R"(<Sequence><A does="K"/><B does="K"/></Sequence>)", "A+K B+K =K"},
    {"SequenceWithMemoryYieldsAfterWhatEndsAtOnce", R"(<SequenceWithMemory><A/><B/></SequenceWithMemory>)",
     "A+S =R | B+S =S | A+S =R"},
    {"SequenceWithMemoryGoesOnAtOnceAfterWhatRan",
     R"(<SequenceWithMemory><A does="RS"/><B/></SequenceWithMemory>)", "A+R =R | A.S B+S =S"},
    {"SequenceWithMemoryRemembersAFailure",
     R"(<SequenceWithMemory><A/><B does="FS"/><C/></SequenceWithMemory>)",
     "A+S =R | B+F =F | B+S =R | C+S =S | A+S =R"},
    {"SequenceWithMemoryRemembersOverAHalt",
     R"(<ReactiveSequence><P does="SSFS"/><SequenceWithMemory><A/><B does="R"/></SequenceWithMemory></ReactiveSequence>)",
     "P?S A+S =R | P?S B+R =R | P?F B- =F | P?S B+R =R"},
    {"ReactiveSequenceAsksAgain", R"(<ReactiveSequence><P does="SSF"/><A does="R"/></ReactiveSequence>)",
     "P?S A+R =R | P?S A.R =R | P?F A- =F | P?S A+R =R"},
    {"ReactiveSequenceHaltsWhatRunsBehind",
     R"(<ReactiveSequence><A does="SRS"/><B does="R"/></ReactiveSequence>)",
     "A+S B+R =R | A+R B- =R | A.S B+R =R"},
    {"ReactiveSequenceOfSkippedIsSkipped",
     R"(<ReactiveSequence><A does="K"/><B does="K"/></ReactiveSequence>)", "A+K B+K =K"},
    {"FallbackGoesOnAtTheRunningChild", R"(<Fallback><P does="F"/><A does="RF"/><B/></Fallback>)",
     "P?F A+R =R | A.F B+S =S | P?F A+R =R"},
    {"FallbackFailsWithItsLast", R"(<Fallback><P does="F"/><A does="F"/></Fallback>)", "P?F A+F =F"},
    {"FallbackOfSkippedIsSkipped", R"(<Fallback><A does="K"/><B does="K"/></Fallback>)", "A+K B+K =K"},
    {"FallbackPassesOverSkipped", R"(<Fallback><A does="K"/><B does="F"/></Fallback>)", "A+K B+F =F"},
    {"ReactiveFallbackAsksAgain", R"(<ReactiveFallback><P does="FFS"/><A does="R"/></ReactiveFallback>)",
     "P?F A+R =R | P?F A.R =R | P?S A- =S | P?F A+R =R"},
    {"ReactiveFallbackBeginsTheFirstBeforeItHaltsTheLast",
     R"(<ReactiveFallback><Sequence><P does="FS"/><A does="R"/></Sequence><B does="R"/></ReactiveFallback>)",
     "P?F B+R =R | P?S A+R B- =R"},
    {"ParallelWaitsForAll", R"(<Parallel><A does="RS"/><B/><C does="RRS"/></Parallel>)",
     "A+R B+S C+R =R | A.S C.R =R | C.S =S | A+R B+S C+R =R"},
    {"ParallelFailsWithTheFirst", R"(<Parallel><A does="R"/><B does="RF"/><C does="R"/></Parallel>)",
     "A+R B+R C+R =R | A.R B.F A- C- =F"},
    {"ParallelSucceedsWithEnough",
     R"(<Parallel success_count="2"><A does="RS"/><B does="RS"/><C does="R"/></Parallel>)",
     "A+R B+R C+R =R | A.S B.S C- =S"},
    {"ParallelDoesNotVisitBehindItsDecision", R"(<Parallel success_count="1"><A/><B does="R"/></Parallel>)",
     "A+S =S"},
    {"ParallelFailsWhenTooFewAreLeft",
     R"(<Parallel success_count="2" failure_count="3"><A does="F"/><B does="F"/><C/></Parallel>)",
     "A+F B+F =F"},
    {"ParallelOfSkippedCountsThem", R"(<Parallel><A does="K"/><B/></Parallel>)", "A+K B+S =S"},
    {"ParallelOfAllSkippedSucceedsWhereAllAreWanted", R"(<Parallel><A does="K"/><B does="K"/></Parallel>)",
     "A+K B+K =S"},
    {"ParallelOfAllSkippedIsSkippedWhereANumberIsWanted",
     R"(<Parallel success_count="2"><A does="K"/><B does="K"/></Parallel>)", "A+K B+K =K"},
    {"ParallelAllLetsAllEnd", R"(<ParallelAll><A does="F"/><B does="RS"/></ParallelAll>)",
     "A+F B+R =R | B.S =F"},
    {"ParallelAllBearsFailures", R"(<ParallelAll max_failures="2"><A does="F"/><B/></ParallelAll>)",
     "A+F B+S =S"},
    {"ParallelAllWithEveryFailure",
     R"(<ParallelAll max_failures="-1"><A does="F"/><B does="F"/></ParallelAll>)", "A+F B+F =F"},
    {"ParallelAllOfSkippedIsSkipped", R"(<ParallelAll><A does="K"/><B does="K"/></ParallelAll>)",
     "A+K B+K =K"},
    {"IfThenElseAsksOnce", R"(<IfThenElse><P does="SF"/><A does="RS"/><B/></IfThenElse>)",
     "P?S A+R =R | A.S =S | P?F B+S =S"},
    {"IfThenElseWithoutElseFails", R"(<IfThenElse><P does="F"/><A/></IfThenElse>)", "P?F =F"},
    {"IfThenElseWaitsForItsCondition", R"(<IfThenElse><C does="RS"/><A/></IfThenElse>)",
     "C+R =R | C.S A+S =S"},
    {"WhileDoElseChangesOver", R"(<WhileDoElse><P does="SSFS"/><A does="R"/><B does="R"/></WhileDoElse>)",
     "P?S A+R =R | P?S A.R =R | P?F A- B+R =R | P?S B- A+R =R"},
    {"WhileDoElseWithoutElseFails", R"(<WhileDoElse><P does="SF"/><A does="R"/></WhileDoElse>)",
     "P?S A+R =R | P?F A- =F"},
    {"InverterTurnsRound", R"(<Inverter><A does="RSF"/></Inverter>)", "A+R =R | A.S =F | A+F =S"},
    {"InverterOfSkippedIsSkipped", R"(<Inverter><A does="K"/></Inverter>)", "A+K =K"},
    {"ForceSuccess", R"(<ForceSuccess><A does="RFSK"/></ForceSuccess>)", "A+R =R | A.F =S | A+S =S | A+K =K"},
    {"ForceFailure", R"(<ForceFailure><A does="RFSK"/></ForceFailure>)", "A+R =R | A.F =F | A+S =F | A+K =K"},
    {"RepeatCountsSuccesses", R"(<Repeat num_cycles="2"><A/></Repeat>)", "A+S =R | A+S =S | A+S =R"},
    {"RepeatEndsWithAFailure", R"(<Repeat num_cycles="3"><A does="SF"/></Repeat>)",
     "A+S =R | A+F =F | A+S =R"},
    {"RepeatOfNothing", R"(<Repeat num_cycles="0"><A/></Repeat>)", "=S"},
    {"RepeatWithoutEnd", R"(<Repeat num_cycles="-1"><A/></Repeat>)", "A+S =R | A+S =R | A+S =R"},
    {"RepeatOfSkippedIsSkipped", R"(<Repeat num_cycles="2"><A does="K"/></Repeat>)", "A+K =K"},
    {"RetryCountsFailures", R"(<RetryUntilSuccessful num_attempts="2"><A does="F"/></RetryUntilSuccessful>)",
     "A+F =R | A+F =F | A+F =R"},
    {"RetryEndsWithASuccess",
     R"(<RetryUntilSuccessful num_attempts="3"><A does="FRS"/></RetryUntilSuccessful>)",
     "A+F =R | A+R =R | A.S =S"},
    {"RetryOfNothing", R"(<RetryUntilSuccessful num_attempts="0"><A/></RetryUntilSuccessful>)", "=F"},
    {"KeepRunningUntilFailure", R"(<KeepRunningUntilFailure><A does="SRSF"/></KeepRunningUntilFailure>)",
     "A+S =R | A+R =R | A.S =R | A+F =F"},
    {"KeepRunningOverSkipped", R"(<KeepRunningUntilFailure><A does="K"/></KeepRunningUntilFailure>)",
     "A+K =R | A+K =R"},
    {"RunOnceThenSkips", R"(<RunOnce><A does="RS"/></RunOnce>)", "A+R =R | A.S =S | =K | =K"},
    {"RunOnceThenRepeatsItsAnswer", R"(<RunOnce then_skip="false"><A does="F"/></RunOnce>)",
     "A+F =F | =F | =F"},
    {"RunOnceIsNotDoneByAHalt",
     R"(<ReactiveSequence><P does="SFS"/><RunOnce><A does="RR"/></RunOnce></ReactiveSequence>)",
     "P?S A+R =R | P?F A- =F | P?S A+R =R"},
    {"TimeoutHaltsWhatTakesTooLong", R"(<Timeout msec="20"><A does="R"/></Timeout>)",
     "A+R =R | A.R =R | A- =F | A+R =R"},
    {"TimeoutIsNotMetByWhatEndsInTime", R"(<Timeout msec="20"><A does="RS"/></Timeout>)",
     "A+R =R | A.S =S | A+R =R"},
    {"TimeoutOfNothingIsNone", R"(<Timeout msec="0"><A does="RRRS"/></Timeout>)",
     "A+R =R | A.R =R | A.R =R | A.S =S"},
    {"DelayComesFirst", R"(<Delay delay_msec="20"><A does="RS"/></Delay>)", "=R | =R | A+R =R | A.S =S | =R"},
    {"DelayBeginsAnewAfterAHalt",
     R"(<ReactiveSequence><P does="SFSSS"/><Delay delay_msec="20"><A/></Delay></ReactiveSequence>)",
     "P?S =R | P?F =F | P?S =R | P?S =R | P?S A+S =S"},
    {"SleepSucceedsAfterItsTime", R"(<Sequence><Sleep msec="20"/><A/></Sequence>)", "=R | =R | A+S =S"},
    {"AlwaysSuccess", R"(<Sequence><AlwaysSuccess/><A/></Sequence>)", "A+S =S"},
    {"AlwaysFailure", R"(<Fallback><AlwaysFailure/><A/></Fallback>)", "A+S =S"},
    {"SwitchChoosesItsCase",
     R"(<Sequence><SetBlackboard value="b" output_key="v"/><Switch2 variable="{v}" case_1="a" case_2="b"><A/><B/><C/></Switch2></Sequence>)",
     "B+S =S"},
    {"SwitchHasADefault",
     R"(<Sequence><SetBlackboard value="x" output_key="v"/><Switch2 variable="{v}" case_1="a" case_2="b"><A/><B/><C/></Switch2></Sequence>)",
     "C+S =S"},
    {"SwitchOfNothingIsTheDefault", R"(<Switch2 variable="{v}" case_1="a" case_2="b"><A/><B/><C/></Switch2>)",
     "C+S =S"},
    {"SetBlackboardTellsAnActionWhatToDo",
     R"(<Sequence><SetBlackboard value="F" output_key="v"/><A does="{v}"/></Sequence>)", "A+F =F"},
    {"SetBlackboardCopies",
     R"(<Sequence><SetBlackboard value="RS" output_key="v"/><SetBlackboard value="{v}" output_key="w"/><A does="{w}"/></Sequence>)",
     "A+R =R | A.S =S"},
};
INSTANTIATE_TEST_SUITE_P(AsTheReference, Semantics, testing::ValuesIn(kAsTheReference),
                         [](const auto& row) { return std::string(row.param.name); });

const Row kDifferent[] = {
    {"RepeatVisitsItsChildOnceATick", R"(<Repeat num_cycles="2"><A does="RS"/></Repeat>)",
     "A+R =R | A.S =R | A+R =R | A.S =S"},
    {"RetryVisitsItsChildOnceATick",
     R"(<RetryUntilSuccessful num_attempts="2"><A does="RF"/></RetryUntilSuccessful>)",
     "A+R =R | A.F =R | A+R =R | A.F =F"},
    {"IfThenElseOfASkippedConditionIsSkipped", R"(<IfThenElse><A does="K"/><B/></IfThenElse>)", "A+K =K"},
    {"WhileDoElseOfASkippedConditionIsSkipped", R"(<WhileDoElse><A does="K"/><B/></WhileDoElse>)", "A+K =K"},
    {"WhileDoElseAsksAnActionAnew", R"(<WhileDoElse><A does="SF"/><B does="R"/></WhileDoElse>)",
     "A+S B+R =R | A+F B- =F"},
    {"IfThenElseAsksAnActionAnew", R"(<IfThenElse><A does="FS"/><B/></IfThenElse>)", "A+F =F | A+S B+S =S"},
    {"WhatIsSkippedAfterItRanHasEnded", R"(<Sequence><A does="RK"/><B does="RS"/></Sequence>)",
     "A+R =R | A.K B+R =R | B.S =S | A+R =R"},
    {"RepeatCountsAnewAfterItWasSkipped", R"(<Repeat num_cycles="2"><A does="SKSS"/></Repeat>)",
     "A+S =R | A+K =K | A+S =R | A+S =S"},
    {"SetBlackboardOfNothingFails", R"(<SetBlackboard value="{v}" output_key="w"/>)", "=F"},
    {"RepeatOfAnEntryThatIsNotSetFails", R"(<Repeat num_cycles="{n}"><A/></Repeat>)", "=F"},
    {"DelayOfNothingIsNone", R"(<Delay delay_msec="0"><A/></Delay>)", "A+S =S"},
    {"CooldownFailsUntilItIsOver", R"(<Cooldown msec="20"><A does="RS"/></Cooldown>)",
     "A+R =R | A.S =S | =F | A+R =R"},
};
INSTANTIATE_TEST_SUITE_P(Different, Semantics, testing::ValuesIn(kDifferent),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace gaitway::behaviour::test

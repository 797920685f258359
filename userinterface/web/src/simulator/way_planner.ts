// A goal that a person has chosen and the robot does not walk to yet, and the way that it walks: which of their footsteps are to be shown.
// Passive: whoever has it asks the planner by `plan`.
import { Refused } from "../rosbridge.ts";
import { givenSteps, progressOf, type FootstepPlan, type Goal, type Progress } from "./footstep_plan.ts";
import { sameGoal, type WayState } from "./way_state.ts";

export interface Draft {
  goal: Goal;
  plan?: FootstepPlan;
  refusal?: string; // why there is no plan: the planner's reason, or that it was not heard of
}

export class WayPlanner {
  draft: Draft | undefined;
  way: WayState | undefined;
  private walked: { goal: Goal; plan: FootstepPlan; progress: Progress } | undefined;
  private place: Pick<Goal, "x" | "y"> | undefined; // of the robot
  private walkedTo: Goal | undefined; // the last goal that it was told to walk to here
  private asked: { goal: Goal; replans: number } | undefined; // for which way that is walked a plan was asked for
  onChange: () => void = () => {};

  constructor(private readonly plan: (goal: Goal) => Promise<FootstepPlan>) {}

  // A goal that is only chosen; its plan, or why there is none, comes later, unless another goal comes before.
  async choose(goal: Goal): Promise<void> {
    const draft: Draft = { goal };
    this.draft = draft;
    this.onChange();
    try {
      draft.plan = await this.plan(goal);
    } catch (error) {
      draft.refusal = `${error instanceof Refused ? "No way leads there" : "No plan has come"}: ${(error as Error).message}`;
    }
    if (this.draft === draft) this.onChange();
  }
  discard(): void {
    if (!this.draft) return;
    this.draft = undefined;
    this.onChange();
  }
  // The robot was told to walk there.
  begun(): void {
    const { draft } = this;
    this.walkedTo = draft?.goal ?? this.walkedTo;
    if (draft?.plan) {
      this.walked = this.beginning(draft.goal, draft.plan);
      this.asked = { goal: draft.goal, replans: this.way?.replans ?? 0 };
    }
    this.draft = undefined;
    this.onChange();
  }

  // The robot was put to another instant: its feet are elsewhere.
  jumped(): void {
    this.walked = this.asked = this.way = undefined; // whether it walks there, it will tell
    if (this.draft) void this.choose(this.draft.goal);
    this.onChange();
  }

  take(way: WayState): void {
    this.way = way;
    if (way.goes && way.goal) this.keepWalked(way.goal, way.replans);
    else if (!way.goes) this.walked = this.asked = undefined;
    this.onChange();
  }

  // The robot is there.
  at(place: Pick<Goal, "x" | "y">): void {
    this.place = place;
    const { walked, way } = this;
    if (!walked || !way?.goes) return;
    const progress = progressOf(walked.plan, place, walked.progress.passed);
    progress.passed = Math.max(Math.min(progress.passed, givenSteps(walked.plan, way.stepsLeft)), walked.progress.passed); // those that turn on the spot lie at one place
    walked.progress = progress;
    this.onChange();
  }

  // The goal that is chosen, or was walked to last; undefined: there was none.
  get goal(): Goal | undefined {
    return this.draft?.goal ?? this.walkedTo;
  }

  // What is to be drawn: of a draft all, of a way that is walked those that are still to come.
  get shown(): { goal: Goal; plan: FootstepPlan | undefined; passed: number } | undefined {
    const { draft, way, walked } = this;
    if (draft) return { goal: draft.goal, plan: draft.plan, passed: 0 };
    if (walked) return { goal: walked.goal, plan: walked.plan, passed: walked.progress.passed };
    return way?.goes && way.goal ? { goal: way.goal, plan: undefined, passed: 0 } : undefined;
  }

  // Of the way that is walked.
  get left(): { steps: number; distance_m: number } | undefined {
    const { way, walked } = this;
    if (!way?.goes) return undefined;
    if (!walked) return { steps: way.stepsLeft, distance_m: way.distanceLeft_m };
    return { steps: walked.plan.steps.length - walked.progress.passed, distance_m: walked.progress.left_m };
  }

  private beginning(goal: Goal, plan: FootstepPlan): { goal: Goal; plan: FootstepPlan; progress: Progress } {
    return { goal, plan, progress: progressOf(plan, this.place ?? plan.feet[0]) };
  }

  // No topic tells the steps of the way that is walked. Where it is another's, or the robot has planned anew, the planner is asked for them.
  private keepWalked(goal: Goal, replans: number): void {
    const { asked } = this;
    if (asked && sameGoal(asked.goal, goal) && asked.replans === replans) return;
    if (asked && sameGoal(asked.goal, goal) && this.walked && replans === 0) { // its counter began anew with the way
      this.asked = { goal, replans };
      return;
    }
    const mine = { goal, replans };
    this.asked = mine;
    this.plan(goal).then((plan) => {
      if (this.asked !== mine) return;
      this.walked = this.beginning(goal, plan);
      this.onChange();
    }, () => {}); // then only the goal is drawn
  }
}

// A goal that a person has chosen and the robot does not walk to yet, and the way that it walks: which of their footsteps are to be shown.
// Passive: whoever has it asks the planner by `plan`.
import { passedSteps, type FootstepPlan, type Goal } from "./footstep_plan.ts";
import { sameGoal, type WayState } from "./way_state.ts";

export interface Draft {
  goal: Goal;
  plan?: FootstepPlan;
  refusal?: string; // the planner's reason why there is no way
}

export class WayPlanner {
  draft: Draft | undefined;
  way: WayState | undefined;
  private walked: { goal: Goal; plan: FootstepPlan } | undefined;
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
      draft.refusal = (error as Error).message;
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
    if (draft?.plan) {
      this.walked = { goal: draft.goal, plan: draft.plan };
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

  // What is to be drawn: of a draft all, of a way that is walked those that are still to come.
  get shown(): { goal: Goal; plan: FootstepPlan | undefined; passed: number } | undefined {
    if (this.draft) return { goal: this.draft.goal, plan: this.draft.plan, passed: 0 };
    if (this.way?.goes && this.way.goal) return { goal: this.walked?.goal ?? this.way.goal, plan: this.walked?.plan, passed: this.walked ? passedSteps(this.walked.plan, this.way.stepsLeft) : 0 };
    return this.walked ? { ...this.walked, passed: 0 } : undefined;
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
      this.walked = { goal, plan };
      this.onChange();
    }, () => {}); // then only the goal is drawn
  }
}

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "push_recording.h"

namespace contact_shapelets::simulation {
namespace {

constexpr double kDuration = 4.33;

PushCondition ConditionFor(Outcome outcome) {
  PushCondition condition;
  condition.outcome = outcome;
  condition.jam_travel = 0.03;
  if (outcome == Outcome::kSlippedOff) condition.engagement = -0.004;
  return condition;
}

double GreatestContactForce(const PushRecording& recording) {
  double greatest = 0.0;
  for (const CellState& state : recording.states) greatest = std::max(greatest, state.contact_force.norm());
  return greatest;
}

class EveryOutcome : public testing::TestWithParam<Outcome> {};

TEST_P(EveryOutcome, FollowsFromItsCondition) {
  EXPECT_EQ(NameOf(RecordPush(ConditionFor(GetParam()), kDuration).outcome), NameOf(GetParam()));
}

TEST_P(EveryOutcome, HasTheSameForcesIfRoundingDiffers) {
  // Another machine rounds differently, by some 1e-16. A push must not magnify that, not even a million times as much.
  constexpr double kDifference = 1e-10;
  SimulatedCell cell(ConditionFor(GetParam()));
  SimulatedCell other(ConditionFor(GetParam()));
  for (int joint = 0; joint <= kArmJoints; ++joint) {
    other.model().data()->qpos[joint] += joint % 2 == 0 ? kDifference : -kDifference;
  }
  cell.BeginPush();
  other.BeginPush();
  double greatest = 0.0;
  while (cell.state().time < kDuration) {
    greatest = std::max(greatest, (cell.Step().wrench - other.Step().wrench).head<3>().cwiseAbs().maxCoeff());
  }
  EXPECT_GT(greatest, 0.0);
  EXPECT_LT(greatest, 0.01);
}

INSTANTIATE_TEST_SUITE_P(SimulatedPush, EveryOutcome, testing::ValuesIn(AllOutcomes()),
                         [](const auto& info) { return NameOf(info.param); });

TEST(SimulatedPush, SnapsAwayFromTheFingerAndMeetsItAgainAtTheStop) {
  const PushRecording recording = RecordPush(ConditionFor(Outcome::kSwitched), kDuration);
  const auto& states = recording.states;
  const auto after = [&states](double angle) {
    return std::find_if(states.begin(), states.end(),
                        [&](const CellState& state) { return state.lever_angle > angle; });
  };
  const auto snap = after(0.0);
  const auto stop = after(0.95 * CellModel::kStop);
  ASSERT_NE(stop, states.end());
  EXPECT_LT(stop->time - snap->time, 0.03);
  const auto met =
      std::find_if(stop, states.end(), [](const CellState& state) { return state.contact_force.norm() > 2.0; });
  ASSERT_NE(met, states.end());
  EXPECT_LT(met->time - snap->time, 0.15);
  const auto free = std::min_element(snap, met, [](const CellState& one, const CellState& other) {
    return one.contact_force.norm() < other.contact_force.norm();
  });
  EXPECT_EQ(free->contact_force.norm(), 0.0);
}

TEST(SimulatedPush, EndsThePushOfAJammedLeverAtTheForceLimit) {
  const PushRecording recording = RecordPush(ConditionFor(Outcome::kBroken), kDuration);
  EXPECT_GT(GreatestContactForce(recording), recording.condition.force_limit);
  EXPECT_LT(GreatestContactForce(recording), 1.6 * recording.condition.force_limit);
}

TEST(SimulatedPush, TouchesNothingIfTheLeverIsMissing) {
  EXPECT_EQ(GreatestContactForce(RecordPush(ConditionFor(Outcome::kMissing), kDuration)), 0.0);
}

TEST(WrenchEstimate, EqualsTheContactForceAtRestForAPerfectRobot) {
  PushCondition condition = ConditionFor(Outcome::kAlreadyOn);
  condition.hold = 1.0;
  SimulatedCell cell(condition);
  cell.BeginPush();
  double held = 0.0;
  while (held < 0.9) {
    if (cell.Step().phase == PushMotion::Phase::kHold) held += SimulatedCell::kPeriod;
    ASSERT_LT(cell.state().time, 10.0) << "the push does not reach its end";
  }
  const Eigen::Vector3d estimate = cell.model().Flange().orientation * cell.state().wrench.head<3>();
  EXPECT_GT(cell.state().contact_force.norm(), 5.0);
  EXPECT_LT((estimate - cell.state().contact_force).norm(), 0.02 * cell.state().contact_force.norm());
}

TEST(WrenchEstimate, IsOneToFiveNewtonsOffInFreeAirOnAverage) {
  core::Random random(1);
  double sum = 0.0;
  constexpr int kDraws = 20;
  for (int draw = 0; draw < kDraws; ++draw) {
    sum += SimulatedCell(SamplePushCondition(Outcome::kSwitched, &random)).state().wrench.head<3>().norm();
  }
  EXPECT_GT(sum / kDraws, 1.0);
  EXPECT_LT(sum / kDraws, 5.0);
}

TEST(RecordOutcome, GivesTheSamePushForTheSameSeed) {
  core::Random one(5);
  core::Random other(5);
  const PushRecording first = RecordOutcome(Outcome::kSwitched, kDuration, &one);
  const PushRecording second = RecordOutcome(Outcome::kSwitched, kDuration, &other);
  ASSERT_EQ(first.states.size(), second.states.size());
  for (std::size_t index = 0; index < first.states.size(); ++index) {
    ASSERT_EQ(first.states[index].wrench, second.states[index].wrench) << "at state " << index;
  }
}

TEST(SimulatedCell, DoesTheNextPushFromWhereTheLastOneEnded) {
  SimulatedCell cell(ConditionFor(Outcome::kSwitched));
  for (const Outcome outcome : {Outcome::kSwitched, Outcome::kBroken, Outcome::kSwitched}) {
    PushCondition condition = ConditionFor(outcome);
    condition.approach = outcome == Outcome::kBroken ? 0.045 : 0.07;
    cell.SetUp(condition);
    cell.BeginPush();
    while (!cell.ObservedOutcome()) {
      cell.Step();
      ASSERT_LT(cell.state().time, 30.0) << "a push does not end";
    }
    EXPECT_EQ(NameOf(*cell.ObservedOutcome()), NameOf(outcome));
  }
}

}  // namespace
}  // namespace contact_shapelets::simulation

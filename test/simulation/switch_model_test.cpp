#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cell_model.h"

namespace contact_shapelets::simulation {
namespace {

constexpr int kLever = kArmJoints;  // index of the lever's degree of freedom, after those of the arm

void PlaceLever(CellModel* cell, double angle) {
  cell->data()->qpos[kLever] = angle;
  mj_forward(cell->model(), cell->data());
}

double SpringEnergy(const CellModel& cell) {
  const double stretch = cell.data()->ten_length[0] - cell.model()->tendon_lengthspring[0];
  return 0.5 * cell.model()->tendon_stiffness[0] * stretch * stretch;
}

double LeverEnergy(const CellModel& cell) {
  Eigen::Matrix<double, kArmJoints + 1, kArmJoints + 1> mass;
  mj_fullM(cell.model(), mass.data(), cell.data()->qM);
  const double speed = cell.data()->qvel[kLever];
  return 0.5 * mass(kLever, kLever) * speed * speed + SpringEnergy(cell);
}

/// Returns the energy that the spring takes up from a stop to dead centre.
double SpringBarrier(CellModel* cell) {
  PlaceLever(cell, 0.0);
  const double top = SpringEnergy(*cell);
  PlaceLever(cell, -CellModel::kStop);
  return top - SpringEnergy(*cell);
}

TEST(ArmModel, IsAsLongAsTheIiwa7) {
  CellModel cell;
  Eigen::Map<JointVector>(cell.data()->qpos).setZero();
  mj_forward(cell.model(), cell.data());
  EXPECT_NEAR(cell.Flange().position.z(), 0.340 + 0.400 + 0.400 + 0.126, 1e-9);
  EXPECT_NEAR(cell.Flange().position.head<2>().norm(), 0.0, 1e-9);
}

TEST(ArmModel, HasTheTorqueLimitsOfTheIiwa7) {
  const CellModel cell;
  const JointErrors limits{176.0, 176.0, 110.0, 110.0, 110.0, 40.0, 40.0};
  for (int joint = 0; joint < kArmJoints; ++joint) {
    EXPECT_EQ(cell.model()->actuator_ctrlrange[2 * joint + 1], limits[static_cast<std::size_t>(joint)]);
  }
}

TEST(OverCentreSpring, HasTheTorqueOverAngleThatWasDesigned) {
  CellModel cell;
  PushCondition condition;
  condition.lever_force = 12.0;
  cell.SetUp(condition);
  const double greatest = CellModel::GreatestUnitSpringTorque();
  for (int tenth = -10; tenth <= 10; ++tenth) {
    const double angle = 0.1 * tenth * CellModel::kStop;
    PlaceLever(&cell, angle);
    const double designed = 12.0 * CellModel::kLeverLength / greatest * CellModel::UnitSpringTorque(angle);
    EXPECT_NEAR(cell.data()->qfrc_passive[kLever], designed, 1e-9) << "at " << angle << " rad";
    EXPECT_NEAR(cell.SpringTorque(), designed, 1e-9) << "at " << angle << " rad";
  }
}

TEST(OverCentreSpring, ResistsMostWithinTheTravelAndLeastAtDeadCentre) {
  const double at_stop = CellModel::UnitSpringTorque(CellModel::kStop);
  EXPECT_GT(at_stop, 0.0);
  EXPECT_GT(CellModel::GreatestUnitSpringTorque(), 1.5 * at_stop);
  EXPECT_EQ(CellModel::UnitSpringTorque(0.0), 0.0);
}

/// Removes everything that takes energy from the lever, except its stops.
void RemoveLosses(CellModel* cell) {
  cell->model()->opt.gravity[2] = 0.0;
  cell->model()->dof_frictionloss[kLever] = 0.0;
  cell->model()->dof_damping[kLever] = 0.0;
}

/// Returns the lever's energy at each crossing of dead centre. The lever starts there with `energy` above that of the
/// spring. A cycle has two crossings.
std::vector<double> EnergiesAtDeadCentre(CellModel* cell, double energy, std::size_t crossings) {
  PlaceLever(cell, 0.0);
  cell->data()->qvel[kLever] = 1.0;
  const double inertia = 2.0 * (LeverEnergy(*cell) - SpringEnergy(*cell));
  cell->data()->qvel[kLever] = std::sqrt(2.0 * energy / inertia);
  mj_forward(cell->model(), cell->data());
  std::vector<double> energies{LeverEnergy(*cell)};
  while (energies.size() < crossings && cell->data()->time < 5.0) {
    const double last = cell->LeverAngle();
    mj_step(cell->model(), cell->data());
    if (last * cell->LeverAngle() > 0.0 || last == 0.0) continue;
    mj_fwdPosition(cell->model(), cell->data());
    energies.push_back(LeverEnergy(*cell));
  }
  return energies;
}

class LeverSwing : public testing::TestWithParam<double> {};

TEST_P(LeverSwing, KeepsItsEnergyOverEveryCycleWithoutStopsAndLosses) {
  CellModel cell;
  RemoveLosses(&cell);
  cell.model()->jnt_limited[kLever] = 0;
  const double barrier = SpringBarrier(&cell);
  const std::vector<double> energies = EnergiesAtDeadCentre(&cell, GetParam() * barrier, 21);
  ASSERT_EQ(energies.size(), 21U) << "the lever does not swing";
  for (std::size_t crossing = 2; crossing < energies.size(); ++crossing) {
    EXPECT_NEAR(energies[crossing], energies[crossing - 2], 0.01 * barrier) << "crossing " << crossing;
  }
  EXPECT_NEAR(energies.back(), energies.front(), 0.01 * barrier) << "over ten cycles";
}

INSTANTIATE_TEST_SUITE_P(OverCentreSpring, LeverSwing, testing::Values(0.05, 0.2, 0.5, 1.0, 2.0));

TEST(OverCentreSpring, TakesWorkOverACycleWithStopsAndFriction) {
  CellModel cell;
  const double barrier = SpringBarrier(&cell);
  cell.data()->qvel[kLever] = 0.0;
  double work = 0.0;
  for (const double way : {1.0, -1.0}) {
    // A hand pushes as slowly as the spring allows, and lets go at dead centre.
    for (int place = -2000; place < 0; ++place) {
      const double wanted = way * CellModel::kStop * place / 2000.0;
      const double torque = 20.0 * (wanted - cell.LeverAngle());
      if (way * cell.LeverAngle() > 0.0) break;
      cell.data()->qfrc_applied[kLever] = way * std::max(0.0, way * torque);
      const double before = cell.LeverAngle();
      mj_step(cell.model(), cell.data());
      work += cell.data()->qfrc_applied[kLever] * (cell.LeverAngle() - before);
    }
    cell.data()->qfrc_applied[kLever] = 0.0;
    for (int step = 0; step < 2000; ++step) mj_step(cell.model(), cell.data());
    EXPECT_NEAR(way * cell.LeverAngle(), CellModel::kStop, 0.02) << "the lever did not snap over";
  }
  EXPECT_GT(work, -0.01 * barrier);
  EXPECT_GT(work, barrier) << "the stops must take the energy of both snaps";
}

}  // namespace
}  // namespace contact_shapelets::simulation

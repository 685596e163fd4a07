#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>

#include "push_condition.h"

/// \file
/// The MuJoCo model of the cell, its state, and access to the parts that the simulation needs.

namespace contact_shapelets::simulation {

using JointVector = Eigen::Matrix<double, kArmJoints, 1>;
using JointMatrix = Eigen::Matrix<double, kArmJoints, kArmJoints>;
using Jacobian = Eigen::Matrix<double, 6, kArmJoints>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Position and orientation of a site in the world.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d orientation = Eigen::Matrix3d::Identity();
};

/// The cell's model and state. Instances share nothing.
class CellModel {
 public:
  /// Compiles the model that was built into the program. \throws std::runtime_error with MuJoCo's message.
  CellModel();

  /// MuJoCo's model.
  mjModel* model() { return model_.get(); }
  /// MuJoCo's model.
  const mjModel* model() const { return model_.get(); }
  /// MuJoCo's state.
  mjData* data() { return data_.get(); }
  /// MuJoCo's state.
  const mjData* data() const { return data_.get(); }

  /// Pose of the tool's tip: the centre of the finger's round end.
  Pose Tip() const { return PoseOf(tip_site_); }
  /// Pose of the flange. The robot reports its wrench in the flange's frame.
  Pose Flange() const { return PoseOf(flange_site_); }
  /// Jacobian [6, 7] of the tip, translation first, in the world's frame.
  Jacobian TipJacobian() const { return JacobianOf(tip_site_); }
  /// Jacobian [6, 7] of the flange, translation first, in the world's frame.
  Jacobian FlangeJacobian() const { return JacobianOf(flange_site_); }
  /// Mass matrix [7, 7] of the arm at the last position that MuJoCo computed.
  JointMatrix MassMatrix() const;
  /// Joint angles [rad] of the arm.
  JointVector JointAngles() const;
  /// Joint speeds [rad/s] of the arm.
  JointVector JointSpeeds() const;
  /// Joint torques [Nm] by which the environment moves the arm: inertial, Coriolis and gravity torques by the model,
  /// minus the motors' torques. Valid after a step.
  JointVector ExternalTorques() const;
  /// Joint torques [Nm] that hold the arm and its tool against gravity at the present position.
  JointVector GravityTorques() const;
  /// Joint torques [Nm] by which gravity moves one kilogram more at the tool's centre of mass.
  JointVector PayloadTorques() const;

  /// Angle [rad] of the lever; below 0 is off.
  double LeverAngle() const;
  /// Torque [Nm] of the over-centre spring on the lever at the present position.
  double SpringTorque() const;
  /// Total force [N] of all contacts on the finger, in the world's frame.
  Eigen::Vector3d ContactForce() const;
  /// Returns true if the finger touches something.
  bool InContact() const { return data_->ncon > 0; }

  /// Sets up switch and obstacle for a push, and turns the lever to its angle before the push.
  void SetUp(const PushCondition& condition);
  /// Places the arm at rest with its tip at `position` [m], pointing at the cabinet.
  /// \throws std::runtime_error if the arm does not reach it.
  void PlaceTip(const Eigen::Vector3d& position);

  /// Returns the centre of the finger's end [m] when it touches a lever that is off, for the taught place of the
  /// switch.
  Eigen::Vector3d TaughtContact(double engagement) const;
  /// Returns the height [m] from that contact up to the contact with a lever at its far stop.
  double LeverTravel(double engagement) const;
  /// Orientation of the tool towards the cabinet.
  static Eigen::Matrix3d ToolOrientation();
  /// Joint angles [rad] near which the arm works.
  static JointVector HomeAngles();

  /// Returns the torque [Nm] of an over-centre spring of stiffness 1 N/m on the lever at `angle` [rad].
  static double UnitSpringTorque(double angle);
  /// Returns the greatest UnitSpringTorque() over the lever's travel.
  static double GreatestUnitSpringTorque();

  static constexpr double kStop = 28.0 * 3.14159265358979323846 / 180.0;  ///< [rad] lever's travel to either side
  static constexpr double kLeverLength = 0.018;                           ///< [m] from the hinge to the toggle's end
  static constexpr double kFingerRadius = 0.004;                          ///< [m]
  static constexpr double kLeverRadius = 0.003;                           ///< [m]

 private:
  struct DeleteModel {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  struct DeleteData {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };

  int Find(mjtObj type, const char* name) const;
  Pose PoseOf(int site) const;
  Jacobian JacobianOf(int site) const;

  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
  Eigen::Vector3d taught_switch_ = Eigen::Vector3d::Zero();
  int tip_site_ = 0;
  int flange_site_ = 0;
  int tool_body_ = 0;
  int switch_body_ = 0;
  int lever_geom_ = 0;
  int lever_joint_ = 0;
  int obstacle_body_ = 0;
  int obstacle_geom_ = 0;
  int spring_ = 0;
  int lever_pair_ = 0;
};

}  // namespace contact_shapelets::simulation

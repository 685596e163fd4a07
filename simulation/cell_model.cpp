#include "cell_model.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <string>

#include "iiwa7_cell_xml.h"

namespace contact_shapelets::simulation {
namespace {

constexpr double kPinRadius = 0.008;          // [m] from the hinge to the spring's pin
constexpr double kAnchorDistance = 0.014;     // [m] from the hinge to the spring's anchor
constexpr double kSpringFreeLength = 0.0086;  // [m]
constexpr double kLeverFriction = 0.005;      // [Nm] least friction of the hinge

using RowJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;

/// MuJoCo's own handlers wait for a key and write a file into the working directory.
void ReportToStandardError() {
  mju_user_warning = [](const char* message) { std::fprintf(stderr, "MuJoCo: %s\n", message); };
  mju_user_error = [](const char* message) {
    std::fprintf(stderr, "MuJoCo: %s\n", message);
    std::abort();
  };
}

mjModel* CompileModel() {
  static std::once_flag reported;
  std::call_once(reported, ReportToStandardError);
  // It is too large for the stack.
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const std::string text = kIiwa7CellXml;
  if (mj_makeEmptyFileVFS(files.get(), "iiwa7_cell.xml", static_cast<int>(text.size())) != 0) {
    throw std::runtime_error("MuJoCo refused the file with the model of the cell");
  }
  std::memcpy(files->filedata[0], text.data(), text.size());
  char message[1000] = "";
  mjModel* model = mj_loadXML("iiwa7_cell.xml", files.get(), message, sizeof(message));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error("the model of the cell has a fault: " + std::string(message));
  return model;
}

}  // namespace

CellModel::CellModel() : model_(CompileModel()), data_(mj_makeData(model_.get())) {
  tip_site_ = Find(mjOBJ_SITE, "tip");
  flange_site_ = Find(mjOBJ_SITE, "flange");
  tool_body_ = Find(mjOBJ_BODY, "tool");
  switch_body_ = Find(mjOBJ_BODY, "switch");
  lever_geom_ = Find(mjOBJ_GEOM, "lever");
  lever_joint_ = Find(mjOBJ_JOINT, "lever");
  obstacle_body_ = Find(mjOBJ_BODY, "obstacle");
  obstacle_geom_ = Find(mjOBJ_GEOM, "obstacle");
  spring_ = Find(mjOBJ_TENDON, "over_centre");
  lever_pair_ = Find(mjOBJ_PAIR, "finger_lever");
  taught_switch_ = Eigen::Map<const Eigen::Vector3d>(model_->body_pos + 3 * switch_body_);
  SetUp(PushCondition{});
}

int CellModel::Find(mjtObj type, const char* name) const {
  const int id = mj_name2id(model_.get(), type, name);
  if (id < 0) throw std::runtime_error("the model of the cell has no " + std::string(name));
  return id;
}

Pose CellModel::PoseOf(int site) const {
  Pose pose;
  pose.position = Eigen::Map<const Eigen::Vector3d>(data_->site_xpos + 3 * site);
  pose.orientation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->site_xmat + 9 * site);
  return pose;
}

Jacobian CellModel::JacobianOf(int site) const {
  Eigen::Matrix<double, 3, kArmJoints + 1, Eigen::RowMajor> translation;
  Eigen::Matrix<double, 3, kArmJoints + 1, Eigen::RowMajor> rotation;
  mj_jacSite(model_.get(), data_.get(), translation.data(), rotation.data(), site);
  Jacobian jacobian;
  jacobian << translation.leftCols<kArmJoints>(), rotation.leftCols<kArmJoints>();
  return jacobian;
}

JointMatrix CellModel::MassMatrix() const {
  Eigen::Matrix<double, kArmJoints + 1, kArmJoints + 1> full;
  mj_fullM(model_.get(), full.data(), data_->qM);
  return full.topLeftCorner<kArmJoints, kArmJoints>();
}

JointVector CellModel::JointAngles() const { return Eigen::Map<const JointVector>(data_->qpos); }

JointVector CellModel::JointSpeeds() const { return Eigen::Map<const JointVector>(data_->qvel); }

JointVector CellModel::ExternalTorques() const {
  Eigen::Matrix<double, kArmJoints + 1, 1> inertial;
  mj_mulM(model_.get(), data_.get(), inertial.data(), data_->qacc);
  return inertial.head<kArmJoints>() + Eigen::Map<const JointVector>(data_->qfrc_bias) -
         Eigen::Map<const JointVector>(data_->qfrc_actuator);
}

JointVector CellModel::GravityTorques() const {
  JointVector torques = JointVector::Zero();
  Eigen::Matrix<double, 3, kArmJoints + 1, Eigen::RowMajor> translation;
  for (int body = 1; body <= tool_body_; ++body) {
    mj_jacBodyCom(model_.get(), data_.get(), translation.data(), nullptr, body);
    torques += -model_->body_mass[body] * model_->opt.gravity[2] * translation.row(2).head<kArmJoints>().transpose();
  }
  return torques;
}

JointVector CellModel::PayloadTorques() const {
  Eigen::Matrix<double, 3, kArmJoints + 1, Eigen::RowMajor> translation;
  mj_jacBodyCom(model_.get(), data_.get(), translation.data(), nullptr, tool_body_);
  return model_->opt.gravity[2] * translation.row(2).head<kArmJoints>().transpose();
}

double CellModel::LeverAngle() const { return data_->qpos[model_->jnt_qposadr[lever_joint_]]; }

double CellModel::SpringTorque() const {
  const double stretch = data_->ten_length[spring_] - model_->tendon_lengthspring[spring_];
  const double moment = data_->ten_J[spring_ * model_->nv + model_->jnt_dofadr[lever_joint_]];
  return -model_->tendon_stiffness[spring_] * stretch * moment;
}

Eigen::Vector3d CellModel::ContactForce() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int index = 0; index < data_->ncon; ++index) {
    const mjContact& contact = data_->contact[index];
    double force[6];
    mj_contactForce(model_.get(), data_.get(), index, force);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(contact.frame);
    // The frame's first axis points from the first geom to the second; the force pushes the second.
    const double sign = model_->geom_bodyid[contact.geom1] == tool_body_ ? -1.0 : 1.0;
    sum += sign * frame.transpose() * Eigen::Map<const Eigen::Vector3d>(force);
  }
  return sum;
}

void CellModel::SetUp(const PushCondition& condition) {
  Eigen::Map<Eigen::Vector3d> place(model_->body_pos + 3 * switch_body_);
  place = taught_switch_ + Eigen::Vector3d(0.0, condition.side_error, condition.height_error);

  const int dof = model_->jnt_dofadr[lever_joint_];
  model_->tendon_stiffness[spring_] = condition.lever_force * kLeverLength / GreatestUnitSpringTorque();
  model_->dof_frictionloss[dof] = kLeverFriction + condition.lever_friction * kLeverLength;
  const bool jammed = condition.outcome == Outcome::kBroken;
  model_->jnt_range[2 * lever_joint_ + 1] = jammed ? -kStop + condition.jam_travel : kStop;
  model_->pair_friction[5 * lever_pair_] = condition.finger_friction;
  model_->pair_friction[5 * lever_pair_ + 1] = condition.finger_friction;

  // A missing lever has a margin below 0, at which contacts do not arise. An obstacle that is not there is far away.
  const bool missing = condition.outcome == Outcome::kMissing;
  model_->pair_margin[lever_pair_] = missing ? -1.0 : 0.0;
  model_->geom_rgba[4 * lever_geom_ + 3] = missing ? 0.0F : 1.0F;
  const Eigen::Vector3d taught = TaughtContact(condition.engagement);
  const double thickness = model_->geom_size[3 * obstacle_geom_ + 2];
  Eigen::Map<Eigen::Vector3d> obstacle(model_->body_pos + 3 * obstacle_body_);
  obstacle =
      condition.outcome == Outcome::kCollision
          ? Eigen::Vector3d(taught.x(), 0.0, taught.z() + kFingerRadius + thickness - condition.obstacle_distance)
          : Eigen::Vector3d(0.0, 0.0, -5.0);

  data_->qpos[model_->jnt_qposadr[lever_joint_]] = condition.outcome == Outcome::kAlreadyOn ? kStop : -kStop;
  data_->qvel[dof] = 0.0;
  mj_forward(model_.get(), data_.get());
}

void CellModel::PlaceTip(const Eigen::Vector3d& position) {
  Eigen::Map<JointVector> angles(data_->qpos);
  angles = HomeAngles();
  Eigen::Map<JointVector>(data_->qvel).setZero();
  for (int round = 0; round < 200; ++round) {
    mj_forward(model_.get(), data_.get());
    const Pose tip = Tip();
    const Eigen::AngleAxisd turn(ToolOrientation() * tip.orientation.transpose());
    Vector6 error;
    error << position - tip.position, turn.angle() * turn.axis();
    if (error.norm() < 1e-10) return;
    const Jacobian jacobian = TipJacobian();
    const Matrix6 squared = jacobian * jacobian.transpose() + 1e-8 * Matrix6::Identity();
    angles += jacobian.transpose() * squared.ldlt().solve(error);
  }
  throw std::runtime_error("the arm does not reach the start of the push");
}

Eigen::Vector3d CellModel::TaughtContact(double engagement) const {
  // The lowest part of a lever that is off is its round end.
  const Eigen::Vector3d toggle(-kLeverLength * std::cos(kStop), 0.0, -kLeverLength * std::sin(kStop));
  return taught_switch_ + toggle + Eigen::Vector3d(engagement, 0.0, -kFingerRadius - kLeverRadius);
}

double CellModel::LeverTravel(double engagement) const {
  // At the far stop the finger's round end touches the lever's straight underside.
  const double reach = kLeverLength * std::cos(kStop) - engagement;
  const double height = reach * std::tan(kStop) - (kFingerRadius + kLeverRadius) / std::cos(kStop);
  return taught_switch_.z() + height - TaughtContact(engagement).z();
}

Eigen::Matrix3d CellModel::ToolOrientation() {
  return Eigen::AngleAxisd(0.5 * 3.14159265358979323846, Eigen::Vector3d::UnitY()).toRotationMatrix();
}

JointVector CellModel::HomeAngles() {
  JointVector angles;
  angles << 0.0, 0.43, 0.0, -1.68, 0.0, -0.53, 0.0;
  return angles;
}

double CellModel::UnitSpringTorque(double angle) {
  const double length = std::sqrt(kPinRadius * kPinRadius + kAnchorDistance * kAnchorDistance -
                                  2.0 * kPinRadius * kAnchorDistance * std::cos(angle));
  return (kSpringFreeLength - length) * kPinRadius * kAnchorDistance * std::sin(angle) / length;
}

double CellModel::GreatestUnitSpringTorque() {
  constexpr int kSteps = 2000;
  double greatest = 0.0;
  for (int step = 0; step <= kSteps; ++step) greatest = std::max(greatest, UnitSpringTorque(kStop * step / kSteps));
  return greatest;
}

}  // namespace contact_shapelets::simulation

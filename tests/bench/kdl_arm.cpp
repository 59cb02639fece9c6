#include "tests/bench/kdl_arm.h"

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainjnttojacsolver.hpp>

namespace rob::bench {
namespace {

KDL::Chain chain_of(const motion::ArmParameters& p) {
  using KDL::Frame;
  using KDL::Joint;
  using KDL::Segment;
  using KDL::Vector;
  KDL::Chain chain;
  chain.addSegment(Segment(Joint(Joint::RotZ), Frame(Vector(p.a1, 0, p.c1))));
  chain.addSegment(Segment(Joint(Joint::RotY), Frame(Vector(0, 0, p.c2))));
  chain.addSegment(Segment(Joint(Joint::RotY), Frame(Vector(p.a2, p.b, p.c3))));
  chain.addSegment(Segment(Joint(Joint::RotZ)));
  chain.addSegment(Segment(Joint(Joint::RotY)));
  chain.addSegment(Segment(Joint(Joint::RotZ), Frame(Vector(0, 0, p.c4))));
  return chain;
}

// In place, so that no call takes memory that KDL itself would not take.
void put(const motion::JointVector& theta, KDL::JntArray& q) {
  for (int i = 0; i < 6; ++i) q(static_cast<unsigned>(i)) = theta[i];
}

}  // namespace

struct KdlArm::Solvers {
  explicit Solvers(const motion::ArmParameters& p)
      : chain(chain_of(p)), forward(chain), inverse(chain, 1e-9), jacobian(chain) {}

  KDL::Chain chain;
  KDL::ChainFkSolverPos_recursive forward;
  KDL::ChainIkSolverPos_LMA inverse;
  KDL::ChainJntToJacSolver jacobian;
  KDL::JntArray q{6};
  KDL::JntArray found{6};
  KDL::Frame frame;
  KDL::Jacobian matrix{6};
};

KdlArm::KdlArm(const motion::ArmParameters& parameters)
    : solvers_(std::make_unique<Solvers>(parameters)) {}

KdlArm::~KdlArm() = default;

motion::Pose KdlArm::forward(const motion::JointVector& theta) {
  put(theta, solvers_->q);
  solvers_->forward.JntToCart(solvers_->q, solvers_->frame);
  motion::Pose pose;
  pose.position = {solvers_->frame.p.x(), solvers_->frame.p.y(), solvers_->frame.p.z()};
  Eigen::Quaterniond& turn = pose.orientation;
  solvers_->frame.M.GetQuaternion(turn.x(), turn.y(), turn.z(), turn.w());
  return pose;
}

bool KdlArm::inverse(const motion::Pose& pose, const motion::JointVector& from,
                     motion::JointVector& theta) {
  put(from, solvers_->q);
  const Eigen::Quaterniond& turn = pose.orientation;
  const KDL::Frame wanted(KDL::Rotation::Quaternion(turn.x(), turn.y(), turn.z(), turn.w()),
                          KDL::Vector(pose.position.x(), pose.position.y(), pose.position.z()));
  if (solvers_->inverse.CartToJnt(solvers_->q, wanted, solvers_->found) < 0) return false;
  theta.resize(6);
  for (int i = 0; i < 6; ++i) theta[i] = solvers_->found(static_cast<unsigned>(i));
  return true;
}

Eigen::Matrix<double, 6, 6> KdlArm::jacobian(const motion::JointVector& theta) {
  put(theta, solvers_->q);
  solvers_->jacobian.JntToJac(solvers_->q, solvers_->matrix);
  return solvers_->matrix.data;
}

}  // namespace rob::bench

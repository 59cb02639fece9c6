#pragma once

#include <vector>

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include "motion/kinematics/joint_chain.h"
#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

/// Published arms under KDL (Orocos Kinematics and Dynamics Library), which shares no code with
/// Rob: the oracle of its chains.
namespace rob::test {

/// A row of a Denavit-Hartenberg table: m, rad.
struct TableRow {
  double a;
  double alpha;
  double d;
};

inline constexpr double kQuarter = 1.57079632679489662;

/// Universal Robots, support article "DH parameters"; standard convention.
inline std::vector<TableRow> ur5e_table() {
  return {{0, kQuarter, 0.1625}, {-0.425, 0, 0},         {-0.3922, 0, 0},
          {0, kQuarter, 0.1333}, {0, -kQuarter, 0.0997}, {0, 0, 0.0996}};
}
inline std::vector<TableRow> ur10e_table() {
  return {{0, kQuarter, 0.1807},  {-0.6127, 0, 0},         {-0.57155, 0, 0},
          {0, kQuarter, 0.17415}, {0, -kQuarter, 0.11985}, {0, 0, 0.11655}};
}
/// Corke, Armstrong-Hélouvry 1994; standard convention.
inline std::vector<TableRow> puma_table() {
  return {{0, kQuarter, 0},      {0.4318, 0, 0},    {0.0203, -kQuarter, 0.15005},
          {0, kQuarter, 0.4318}, {0, -kQuarter, 0}, {0, 0, 0}};
}
/// Franka, "Robot and interface specifications"; Craig's convention, the flange as a last row.
inline std::vector<TableRow> fr3_table() {
  return {{0, 0, 0.333},
          {0, -kQuarter, 0},
          {0, kQuarter, 0.316},
          {0.0825, kQuarter, 0},
          {-0.0825, -kQuarter, 0.384},
          {0, kQuarter, 0},
          {0.088, kQuarter, 0},
          {0, 0, 0.107}};
}

class KdlChain {
 public:
  static KdlChain standard(const std::vector<TableRow>& rows) {
    KDL::Chain chain;
    for (const TableRow& row : rows)
      chain.addSegment(
          KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame::DH(row.a, row.alpha, row.d, 0)));
    return KdlChain(chain);
  }
  /// The last row is the flange.
  static KdlChain craig(const std::vector<TableRow>& rows) {
    KDL::Chain chain;
    const auto frame = [](const TableRow& row) {
      return KDL::Frame::DH_Craig1989(row.a, row.alpha, row.d, 0);
    };
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame(rows.front())));
    for (std::size_t i = 1; i < rows.size(); ++i)
      chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), frame(rows[i])));
    return KdlChain(chain);
  }

  /// The same frames and axes as a chain of Rob's.
  static KdlChain of(const motion::JointChain& joints) {
    KDL::Chain chain;
    const auto frame = [](const motion::Pose& pose) {
      const Eigen::Quaterniond& turn = pose.orientation;
      return KDL::Frame(KDL::Rotation::Quaternion(turn.x(), turn.y(), turn.z(), turn.w()),
                        KDL::Vector(pose.position.x(), pose.position.y(), pose.position.z()));
    };
    for (int i = 0; i < joints.size(); ++i) {
      const auto& joint = joints.joint(i);
      chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame(joint.place)));
      chain.addSegment(
          KDL::Segment(KDL::Joint(joint.linear ? KDL::Joint::TransZ : KDL::Joint::RotZ),
                       KDL::Frame::Identity()));
    }
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame(joints.flange())));
    return KdlChain(chain);
  }

  motion::Pose forward(const motion::JointVector& q) {
    KDL::Frame frame;
    forward_.JntToCart(array(q), frame);
    motion::Pose pose;
    pose.position = {frame.p.x(), frame.p.y(), frame.p.z()};
    Eigen::Quaterniond& turn = pose.orientation;
    frame.M.GetQuaternion(turn.x(), turn.y(), turn.z(), turn.w());
    return pose;
  }
  /// [velocity; angular velocity], a column a joint.
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(const motion::JointVector& q) {
    KDL::Jacobian matrix(chain_.getNrOfJoints());
    jacobian_.JntToJac(array(q), matrix);
    return matrix.data;
  }
  /// KDL's own iteration (Levenberg-Marquardt) from `near`; false: not found.
  bool inverse(const motion::Pose& pose, const motion::JointVector& near,
               motion::JointVector& found) {
    const Eigen::Quaterniond& turn = pose.orientation;
    const KDL::Frame wanted(KDL::Rotation::Quaternion(turn.x(), turn.y(), turn.z(), turn.w()),
                            KDL::Vector(pose.position.x(), pose.position.y(), pose.position.z()));
    KDL::JntArray q(chain_.getNrOfJoints());
    if (inverse_.CartToJnt(array(near), wanted, q) < 0) return false;
    found = q.data;
    return true;
  }

 private:
  explicit KdlChain(const KDL::Chain& chain)
      : chain_(chain), forward_(chain_), jacobian_(chain_), inverse_(chain_, 1e-9) {}

  KDL::JntArray array(const motion::JointVector& q) const {
    KDL::JntArray values(chain_.getNrOfJoints());
    for (unsigned i = 0; i < chain_.getNrOfJoints(); ++i) values(i) = q[i];
    return values;
  }

  KDL::Chain chain_;
  KDL::ChainFkSolverPos_recursive forward_;
  KDL::ChainJntToJacSolver jacobian_;
  KDL::ChainIkSolverPos_LMA inverse_;
};

}  // namespace rob::test

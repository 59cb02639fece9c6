#pragma once

#include <string>
#include <vector>

#include "motion/path/tool_arc.h"
#include "motion/path/tool_line.h"
#include "motion/path/tool_spline.h"
#include "motion/space/rotation.h"
#include "tests/motion/generate/gantry_run.h"

namespace rob::test {

/// A GantryRun of an arm, commanded along paths of its flange.
class ArmRun : public GantryRun {
 public:
  explicit ArmRun(const std::string& name) : GantryRun(motion::embedded_robot(name)) {}

  motion::Pose here() { return planner().tool_pose(); }
  motion::Pose beside(double x_mm, double y_mm, double z_mm,
                      const Eigen::Vector3d& turned = Eigen::Vector3d::Zero()) {
    const motion::Pose from = here();
    return {from.position + Eigen::Vector3d(x_mm, y_mm, z_mm) / 1000,
            motion::rotation_by(turned) * from.orientation};
  }

  motion::PlannedSegment along(const motion::ToolPath& path, const motion::MotionRequest& how) {
    auto planned = std::get<motion::PlannedSegment>(planner().plan(how, path));
    push(planned.segment);
    return planned;
  }
  motion::PlannedSegment line(const motion::Pose& to, const motion::MotionRequest& how = {}) {
    return along(motion::ToolLine::between(here(), to).value(), how);
  }

  Eigen::Vector3d place(const motion::GeneratorSample& sample) const {
    return robot().kinematics->forward(sample.reference.q).position;
  }
};

/// AT so many mm/s.
inline motion::MotionRequest at(double mm_per_s) {
  motion::MotionRequest request;
  request.pace = motion::MotionRequest::Pace::ToolSpeed;
  request.pace_value = mm_per_s / 1000;
  return request;
}

inline motion::MotionRequest zoned(motion::MotionRequest request, double mm) {
  request.zone = motion::MotionRequest::Zone::Length;
  request.zone_value = mm / 1000;
  return request;
}

inline motion::MotionRequest profiled(motion::MotionRequest request, motion::Profile shape) {
  request.profile = shape;
  return request;
}

/// Away from the start along every coordinate.
inline motion::MotionRequest turned_from_start(const motion::RobotModel& robot, double rad) {
  motion::JointVector q = robot.start;
  for (int i = 0; i < q.size(); ++i) q[i] += i % 2 == 0 ? rad : -rad;
  return move_to(q);
}

}  // namespace rob::test

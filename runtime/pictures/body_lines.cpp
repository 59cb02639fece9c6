#include "runtime/pictures/body_lines.h"

#include <cmath>
#include <numbers>

namespace rob::runtime {

namespace {

using Eigen::Vector3d;
using Lines = std::vector<BodyLine>;

void add_bodies(Lines& lines, const motion::RobotModel& robot, const motion::LinkFrames& frames) {
  for (const motion::Body& body : robot.collision.bodies) {
    const motion::Pose frame =
        body.frame == 0 ? motion::Pose{} : frames[static_cast<std::size_t>(body.frame - 1)];
    for (const motion::Capsule& shape : body.shapes) {
      const motion::Capsule placed = motion::moved(shape, frame);
      lines.push_back({placed.from, placed.to, placed.radius});
    }
  }
}

/// From the base over the frames of the axes to the flange.
void add_skeleton(Lines& lines, const motion::RobotModel& robot, const motion::LinkFrames& frames) {
  Vector3d from = Vector3d::Zero();
  for (int i = 0; i <= robot.axis_count(); ++i) {
    const Vector3d& to = frames[static_cast<std::size_t>(i)].position;
    lines.push_back({from, to, 0});
    from = to;
  }
}

struct ObstacleLines {
  Lines operator()(const motion::Box& box) const {
    Lines lines;
    for (int axis = 0; axis < 3; ++axis)
      for (const double u : {-1.0, 1.0})
        for (const double v : {-1.0, 1.0}) {
          Vector3d from;
          from[axis] = -box.half[axis];
          from[(axis + 1) % 3] = u * box.half[(axis + 1) % 3];
          from[(axis + 2) % 3] = v * box.half[(axis + 2) % 3];
          Vector3d to = from;
          to[axis] = box.half[axis];
          lines.push_back({place_of(from, box.centre), place_of(to, box.centre), 0});
        }
    return lines;
  }
  Lines operator()(const motion::Sphere& sphere) const {
    constexpr int kChords = 24;  // [choice]
    Lines lines;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kChords; ++i) {
        const auto on_circle = [&](int corner) {
          const double turn = 2 * std::numbers::pi * corner / kChords;
          Vector3d place = sphere.centre;
          place[(axis + 1) % 3] += sphere.radius * std::cos(turn);
          place[(axis + 2) % 3] += sphere.radius * std::sin(turn);
          return place;
        };
        lines.push_back({on_circle(i), on_circle(i + 1), 0});
      }
    return lines;
  }
  Lines operator()(const motion::Capsule& capsule) const {
    return {{capsule.from, capsule.to, capsule.radius}};
  }
  Lines operator()(const std::shared_ptr<const motion::ConvexBody>& body) const {
    Lines lines;
    for (const auto& [from, to] : body->edges()) lines.push_back({from, to, 0});
    return lines;
  }
  Lines operator()(const motion::HalfSpace& table) const {
    constexpr double kHalf = 0.5;  // m [choice] of the square that stands for the plane
    Lines lines;
    const auto corner = [&](int i) {
      return Vector3d(i == 1 || i == 2 ? kHalf : -kHalf, i >= 2 ? kHalf : -kHalf, table.height);
    };
    for (int i = 0; i < 4; ++i) lines.push_back({corner(i), corner((i + 1) % 4), 0});
    return lines;
  }
};

}  // namespace

Lines lines_of_robot(const motion::RobotModel& robot, const motion::JointVector& q) {
  Lines lines;
  const motion::LinkFrames frames = robot.kinematics->frames(q);
  if (robot.collision.bodies.empty()) {
    add_skeleton(lines, robot, frames);
  } else {
    add_bodies(lines, robot, frames);
  }
  return lines;
}

Lines lines_of_obstacle(const motion::Obstacle& obstacle) {
  return std::visit(ObstacleLines{}, obstacle.shape);
}

}  // namespace rob::runtime

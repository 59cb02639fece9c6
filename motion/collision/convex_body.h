#pragma once

#include <utility>
#include <vector>

#include "motion/collision/shapes.h"

namespace rob::motion {

/// A convex body of any form. It can be asked from several threads.
class ConvexBody {
 public:
  virtual ~ConvexBody() = default;
  /// As the distances of distance.h; m. From afar it may tell less than there is.
  virtual double distance(const Capsule& capsule) const noexcept = 0;
  /// For pictures: both ends of each edge, m.
  virtual std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> edges() const = 0;

 protected:
  ConvexBody() = default;
  ConvexBody(const ConvexBody&) = default;
  ConvexBody& operator=(const ConvexBody&) = default;
};

}  // namespace rob::motion

#include "tests/support/rounded_polyline.h"

#include <algorithm>

namespace rob::test {

namespace {

using Eigen::Vector3d;

AxisValues values(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Nodes in their order; σ is the length on lines and as much in corners as they leave out.
class NodeList {
 public:
  void add(double sigma, const Vector3d& q, const Vector3d& dq, const Vector3d& ddq) {
    nodes_.push_back({sigma, values(q), values(dq), values(ddq)});
  }
  double sigma() const { return nodes_.empty() ? 0 : nodes_.back().sigma; }
  std::vector<ToppNode> take() { return std::move(nodes_); }

 private:
  std::vector<ToppNode> nodes_;
};

}  // namespace

std::vector<ToppNode> rounded_polyline(const std::vector<Vector3d>& places, double zone) {
  NodeList nodes;
  Vector3d from = places.front();  // where the line that is being made begins
  const Vector3d none = Vector3d::Zero();
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Vector3d leg = places[i] - places[i - 1];
    const Vector3d d1 = leg.normalized();
    const bool last = i + 1 == places.size();
    const Vector3d next = last ? d1 : Vector3d(places[i + 1] - places[i]);
    const Vector3d turn = next.normalized() - d1;
    // In its middle a parabola that takes l of each leg is l·|turn|/4 off the point.
    const double half = std::min(leg.norm(), next.norm()) / 2;
    const bool corner = !last && turn.norm() > 1e-12;
    const double l = corner ? std::min(4 * zone / turn.norm(), half) : 0;
    const Vector3d begin = places[i] - l * d1;
    nodes.add(nodes.sigma(), from, d1, none);
    nodes.add(nodes.sigma() + (begin - from).norm(), begin, d1, none);
    from = places[i] + l * next.normalized();
    if (!corner) continue;
    const Vector3d bend = turn / (2 * l);
    nodes.add(nodes.sigma(), begin, d1, bend);
    nodes.add(nodes.sigma() + 2 * l, from, next.normalized(), bend);
  }
  return nodes.take();
}

}  // namespace rob::test

#include "runtime/import/touching.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/halton.h"
#include "motion/collision/distance.h"
#include "motion/space/joint_vector.h"

namespace rob::runtime {

namespace {

using Eigen::Vector3d;
using motion::Capsule;

constexpr int kPostures = 10000;
constexpr double kTouching = 1e-3;  // m
constexpr std::array<int, motion::kMaxJoints> kPrimes{2, 3, 5, 7, 11, 13, 17, 19};

using Placed = std::vector<std::vector<Capsule>>;

/// Where the links are in a posture, seen from the base.
Placed placed_links(const std::vector<motion::Body>& links,
                    const std::vector<motion::Pose>& frames) {
  Placed placed;
  for (const motion::Body& link : links) {
    std::vector<Capsule> capsules;
    for (const Capsule& capsule : link.shapes) {
      const motion::Pose& frame = frames[static_cast<std::size_t>(link.frame)];
      capsules.push_back(motion::moved(capsule, frame));
    }
    placed.push_back(std::move(capsules));
  }
  return placed;
}

bool touch(const std::vector<Capsule>& one, const std::vector<Capsule>& other) {
  return std::ranges::any_of(one, [&](const Capsule& a) {
    return std::ranges::any_of(
        other, [&](const Capsule& b) { return motion::distance(a, b) < kTouching; });
  });
}

/// The frames of base, axes and flange in the posture of this number.
std::vector<motion::Pose> frames_of(const ImportedArm& arm, int number) {
  std::vector<motion::Pose> frames(1);
  for (std::size_t i = 0; i < arm.chain; ++i) {
    const ImportedAxis& axis = arm.axes[i];
    const double q = axis.min + (axis.max - axis.min) * halton(number, kPrimes[i]);
    const Vector3d z = Vector3d::UnitZ();
    const motion::Pose moved{axis.linear ? Vector3d(q * z) : Vector3d::Zero(),
                             Eigen::Quaterniond(Eigen::AngleAxisd(axis.linear ? 0 : q, z))};
    frames.push_back(motion::composed(motion::composed(frames.back(), axis.place), moved));
  }
  frames.push_back(motion::composed(frames.back(), arm.flange));
  return frames;
}

/// Two links by their numbers, the first the smaller one; neighbours touch in any case.
using Pair = std::pair<std::size_t, std::size_t>;

std::vector<Pair> pairs_of(const std::vector<motion::Body>& links) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t j = i + 2; j < links.size(); ++j)
      if (!links[i].shapes.empty() && !links[j].shapes.empty()) pairs.emplace_back(i, j);
  return pairs;
}

}  // namespace

std::vector<motion::Apart> always_touching(const ImportedArm& arm,
                                           const std::vector<motion::Body>& links) {
  std::vector<Pair> pairs = pairs_of(links);
  for (int number = 1; number <= kPostures && !pairs.empty(); ++number) {
    const Placed placed = placed_links(links, frames_of(arm, number));
    std::erase_if(pairs, [&](const Pair& p) { return !touch(placed[p.first], placed[p.second]); });
  }
  std::vector<motion::Apart> touching;
  for (const auto& [first, second] : pairs)
    touching.push_back({links[first].name, links[second].name});
  return touching;
}

}  // namespace rob::runtime

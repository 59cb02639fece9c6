#include "runtime/command/way_marks.h"

#include <bit>
#include <initializer_list>
#include <string>

namespace rob::runtime {

namespace {

/// FNV-1a over the words of all that is put in, each mixed so that its upper bits count, too.
class WayHash {
 public:
  void put(std::uint64_t word) {
    word ^= word >> 32U;
    word *= 0x9E3779B97F4A7C15U;
    word ^= word >> 29U;
    sum_ = (sum_ ^ word) * 0x100000001B3U;
  }
  void put(double value) { put(std::bit_cast<std::uint64_t>(value)); }
  void put(const motion::JointVector& values) {
    for (const double value : values) put(value);
  }
  void put(const std::string& text) {
    for (const char c : text) put(static_cast<std::uint64_t>(c));
  }
  void put(const motion::JointPath& path) {
    for (const motion::JointPath::Node& node : path.nodes()) {
      put(node.time);
      put(node.q);
      put(node.qd);
      put(node.qdd);
    }
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xCBF29CE484222325U;
};

}  // namespace

std::uint64_t way_mark(std::uint64_t before, const motion::JointVector& from,
                       const motion::SegmentMotion& motion) {
  WayHash hash;
  hash.put(before);
  hash.put(from);
  hash.put(motion.target);
  const motion::LegBounds& ahead = motion.ahead;
  for (const double value :
       {motion.duration, motion.t_acc, motion.t_acc_before, ahead.length, ahead.speed,
        ahead.acceleration, ahead.window, ahead.miss, ahead.turn, ahead.lead, ahead.share,
        ahead.first, ahead.last, motion.from_rest ? 1.0 : 0.0})
    hash.put(value);
  if (motion.path != nullptr) hash.put(*motion.path);
  if (motion.corner != nullptr) hash.put(motion.corner->axes);
  return hash.sum();
}

std::uint64_t mark_of(const motion::Clearance& clearance) {
  WayHash hash;
  const motion::JointVector everywhere = motion::JointVector::Ones(motion::kMaxJoints);
  for (std::size_t i = 0; i < clearance.pairs().size(); ++i) {
    const motion::Clearance::Pair& pair = clearance.pairs()[i];
    hash.put(clearance.name_of_body(pair));
    hash.put(clearance.name_of_other(pair));
    hash.put(clearance.approach(i, everywhere.head(clearance.axes())));
  }
  return hash.sum();
}

}  // namespace rob::runtime

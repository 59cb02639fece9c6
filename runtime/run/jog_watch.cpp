#include "runtime/run/jog_watch.h"

#include <algorithm>
#include <numeric>

#include "motion/robots/robot_clearance.h"
#include "motion/space/cycle_instant.h"

namespace rob::runtime {

namespace {

// [choice] So many are measured at a look: those that may be the nearest, and others in turn.
constexpr std::size_t kNearest = 64;
constexpr std::size_t kInTurn = 64;
/// m: a pair that is farther apart needs no slopes. [choice]
constexpr double kSlopesWithin = 10e-3;
constexpr double kStep = 1e-4;  // m [choice] of a body, from which slopes come

}  // namespace

JogWatch::JogWatch(const motion::RobotModel& robot, Channels& channels)
    : period_(robot.reference_period), channels_(channels) {
  watch(std::make_shared<const motion::Clearance>(motion::clearance_of(robot)));
  if (!pairs_.empty()) channels_.jog_room.use();
}

/// From here on; all is measured anew.
void JogWatch::watch(const Shared& clearance) {
  clearance_ = clearance;
  pairs_.assign(clearance->pairs().size(), {});
  order_.resize(pairs_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  turn_ = 0;
  last_ = motion::JointVector();
}

void JogWatch::look() {
  if (!channels_.jog_room.wanted()) return;
  if (const Shared next = channels_.jog_bodies.load(); next && next != clearance_) watch(next);
  const double time = motion::cycle_instant(channels_.cycle.load(), period_);
  const motion::JointVector q = channels_.joints.load();
  go_on_to(q);
  measure(q);
  view_.time = time;
  view_.q = q;
  view_.levers = clearance_->greatest_levers();
  view_.count = static_cast<int>(std::min<std::size_t>(motion::JogRoom::kNear, order_.size()));
  for (std::size_t i = 0; i < static_cast<std::size_t>(view_.count); ++i)
    view_.near[i] = near_at(order_[i], q);
  view_.others = std::numeric_limits<double>::infinity();
  for (std::size_t i = static_cast<std::size_t>(view_.count); i < order_.size(); ++i)
    view_.others = std::min(view_.others, pairs_[order_[i]].now);
  channels_.jog_room.publish(view_);
}

/// The way of the axes since then bounds how near the pairs have come that are not measured.
void JogWatch::go_on_to(const motion::JointVector& q) {
  const bool first = last_.size() != q.size();
  if (first) {
    gone_ = motion::JointVector::Zero(q.size());
  } else {
    gone_ += (q - last_).cwiseAbs();
  }
  last_ = q;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (first) pairs_[i] = {distance(i, q), gone_};
    pairs_[i].now = pairs_[i].distance - clearance_->approach(i, gone_ - pairs_[i].gone);
  }
}

void JogWatch::measure(const motion::JointVector& q) {
  const auto nearer = [&](std::size_t a, std::size_t b) { return pairs_[a].now < pairs_[b].now; };
  const auto some = order_.begin() + static_cast<std::ptrdiff_t>(std::min(kNearest, order_.size()));
  std::partial_sort(order_.begin(), some, order_.end(), nearer);
  const motion::LinkFrames frames = clearance_->frames(q);
  const auto take = [&](std::size_t i) {
    const double here = clearance_->distance(clearance_->pairs()[i], frames);
    pairs_[i] = {here, gone_, here};
  };
  std::for_each(order_.begin(), some, take);
  const std::size_t count = pairs_.size() > kNearest ? std::min(kInTurn, pairs_.size()) : 0;
  for (std::size_t k = 0; k < count; ++k) take(turn_++ % pairs_.size());
  std::partial_sort(order_.begin(), some, order_.end(), nearer);
}

motion::JogRoom::Near JogWatch::near_at(std::size_t pair, const motion::JointVector& q) const {
  motion::JogRoom::Near near;
  near.pair = static_cast<int>(pair);
  near.distance = pairs_[pair].now;
  near.levers = clearance_->levers(pair);
  near.up = near.down = motion::JointVector::Zero(q.size());
  if (near.distance > kSlopesWithin) return near;
  for (int i = 0; i < q.size(); ++i) {
    if (!(near.levers[i] > 0)) continue;
    const double step = kStep / near.levers[i];
    motion::JointVector beside = q;
    beside[i] = q[i] + step;
    near.up[i] = (distance(pair, beside) - near.distance) / step;
    beside[i] = q[i] - step;
    near.down[i] = (distance(pair, beside) - near.distance) / step;
  }
  return near;
}

double JogWatch::distance(std::size_t pair, const motion::JointVector& q) const {
  return clearance_->distance(clearance_->pairs()[pair], clearance_->frames(q));
}

}  // namespace rob::runtime

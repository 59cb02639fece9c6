#include <algorithm>
#include <utility>

#include "runtime/command/robot_machine.h"
#include "runtime/words/codes.h"
#include "runtime/words/feature_words.h"
#include "runtime/words/messages.h"

/// Member functions of RobotMachine for PATH. Its motions are planned one by one and kept until its
/// end. Then places are laid along the whole path, and it is queued. Until then nothing of it
/// moves.
namespace rob::runtime {

using lang::Reply;

namespace {

/// [choice] as many as the longest buffer holds; 60 MB
constexpr std::size_t kMostInPath = 16384;

}  // namespace

Reply RobotMachine::begin_path(int line) {
  if (const auto words = words_against(lang::MotionFeature::Path, robot_)) {
    refuse(*words);
    return Reply::Refused;
  }
  if (!rested() || tell_load(line) == Reply::Later) return Reply::Later;
  path_.emplace(Path{planner_.mark(), exact_, brakable_, moved_tip_});
  return Reply::Done;
}

Reply RobotMachine::end_path(int /*line*/) {
  if (collecting()) {
    if (!lay_places()) {
      drop_path();
      return Reply::Refused;
    }
    path_->closed = true;
  }
  while (!path_->motions.empty()) {
    if (buffer_.full()) return Reply::Later;
    send(std::move(path_->motions.front()));
    path_->motions.pop_front();
  }
  path_.reset();
  return Reply::Done;
}

/// False, with a refusal, where there is no room for a further motion.
bool RobotMachine::path_has_room() {
  if (path_->motions.size() < kMostInPath) return true;
  refuse(words_for_long_path(kMostInPath));
  return false;
}

/// Every place of the PATH becomes one on a motion of it. False, with a refusal, where it lies
/// beyond.
bool RobotMachine::lay_places() {
  double whole = 0;
  for (const Commanded& one : path_->motions) whole += one.way;
  for (OnTheWay& event : std::exchange(on_the_way_, {})) {
    const double asked = event.place.distance;
    double place = event.place.before ? whole - asked : asked;
    const bool on_it =
        whole > 0 && place >= -motion::kLimitTolerance && place <= whole + motion::kLimitTolerance;
    if (!on_it) {
      refuse(words_at(event.place.written, words_for_place(asked, whole)));
      return false;
    }
    Commanded* on = nullptr;  // the first one that reaches as far, else the last
    for (Commanded& one : path_->motions) {
      if (!(one.way > 0)) continue;
      if (on != nullptr) place -= on->way;
      on = &one;
      if (place <= one.way) break;
    }
    event.place.before = false;
    event.place.distance = std::clamp(place, 0.0, on->way);
    on->events.push_back(event);
  }
  return std::ranges::all_of(path_->motions, [&](Commanded& one) {
    for (std::size_t i = 0; i < one.events.size(); ++i) log_.queued_effect();
    return lay_events(one);
  });
}

/// Plans anew what is left of the PATH. False, with a refusal, where it cannot be gone any more.
bool RobotMachine::plan_path_anew() {
  if (!path_) return true;
  path_->before = planner_.mark();
  return std::ranges::all_of(path_->motions, [&](Commanded& one) { return plan_anew(one); });
}

/// What of the PATH has not been queued is as though it had never been commanded.
void RobotMachine::drop_path() {
  if (!path_) return;
  if (collecting()) {
    planner_.go_back(path_->before);
    exact_ = path_->exact;
    brakable_ = path_->brakable;
    moved_tip_ = path_->moved_tip;
  } else {
    planner_.stand_at(planner_.commanded(), sent_);
  }
  on_the_way_.clear();
  path_.reset();
}

}  // namespace rob::runtime

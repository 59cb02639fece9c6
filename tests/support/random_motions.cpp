#include "tests/support/random_motions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/motion_writer.h"

namespace rob::test {

using Eigen::Vector3d;

void MotionWriter::straight(const std::string& word, const Vector3d& to) {
  double miss = 0;
  const bool framed = word == "MOVEL" && robot_.kind != Kind::Arm && choice_.percent(15);
  const std::string motion = word + target(framed ? to - kFrame : to, true);
  const std::string how = (framed ? " IN shifted" : "") + clauses(miss);
  finish(motion, how, (to - here_).norm());
  if (word == "MOVE" && bends()) made_.known = false;
  arrive(to, miss);
}

/// Counts from where the robot is, so only where that is known.
void MotionWriter::relative() {
  const Vector3d to = near_place();
  if (!made_.whole) return straight("MOVEL", to);
  double miss = 0;
  const std::string motion = "MOVEL BY " + way(to - here_);
  finish(motion, clauses(miss), (to - here_).norm());
  arrive(to, miss);
}

void MotionWriter::arc() {
  const Vector3d to = near_place();
  const Vector3d chord = to - here_;
  const Vector3d across = Vector3d::UnitZ().cross(chord);
  if (!made_.whole || chord.norm() < 2 || across.norm() < 1) return straight("MOVEL", to);
  const double bulge = choice_.between(10, 60) / 100.0 * (choice_.percent(50) ? 1 : -1);
  const Vector3d via = round(here_ + chord / 2 + bulge * across);
  // The circle through three places: a and b seen from here_.
  const Vector3d a = via - here_, b = chord;
  const Vector3d normal = a.cross(b);
  const Vector3d centre = here_ + (a.squaredNorm() * b - b.squaredNorm() * a).cross(normal) /
                                      (2 * normal.squaredNorm());
  const Vector3d x = here_ - centre, y = normal.normalized().cross(x);
  const auto angle_of = [&](const Vector3d& p) {
    const double angle = std::atan2((p - centre).dot(y), (p - centre).dot(x));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  };
  const bool backward = angle_of(via) > angle_of(to);
  const double whole = backward ? angle_of(to) - 2 * std::numbers::pi : angle_of(to);
  constexpr int kChords = 1000;
  std::vector<Vector3d> places;
  for (int k = 1; k < kChords; ++k) {
    const double angle = whole * k / kChords;
    places.push_back(centre + std::cos(angle) * x + std::sin(angle) * y);
    if (!inside(places.back())) return straight("MOVEL", to);
  }
  double miss = 0;
  const std::string motion = "MOVEC VIA " + target(via, false) + " TO " + target(to, false);
  finish(motion, clauses(miss), std::abs(whole) * (here_ - centre).norm());
  const double beside = bend(miss);
  made_.path.places.insert(made_.path.places.end(), places.begin(), places.end());
  arrive(to, miss, beside);
}

void MotionWriter::spline() {
  std::string motion = "MOVES VIA ";
  const int points = choice_.between(2, 4);
  const Vector3d begin = here_;
  std::vector<Vector3d> places;
  for (int k = 0; k < points; ++k) {
    const Vector3d last = here_;
    here_ = near_place();
    if ((here_ - last).norm() < 1) return void(here_ = begin);
    places.push_back(here_);
  }
  for (int k = 0; k < points; ++k)
    motion += (k == 0            ? ""
               : k + 1 == points ? " TO "
                                 : ", ") +
              target(places[static_cast<std::size_t>(k)], false);
  double miss = 0;
  line(motion + clauses(miss));
  made_.known = false;
  const double beside = bend(miss);
  for (const Vector3d& place : places) arrive(place, std::max(beside, kExact + 0.01));
  made_.misses.back() = miss;
}

/// Short motions on a curve, as they come out of a CAM system.
void MotionWriter::dense() {
  const int pieces = choice_.between(8, 40);
  const double step = choice_.between(5, 200) / 100.0;
  double direction = choice_.below(628) / 100.0;
  const double bend = choice_.between(-30, 30) / 100.0;
  double miss = 0;
  const std::string how = clauses(miss);
  for (int k = 0; k < pieces; ++k) {
    const Vector3d to = round(here_ + step * Vector3d(std::cos(direction), std::sin(direction), 0));
    if (!inside(to)) return;
    line((robot_.kind == Kind::Arm ? "MOVEL" : "MOVE") + target(to, false) + how);
    arrive(to, miss);
    direction += bend;
  }
}

void MotionWriter::repeated() {
  line("MOVEL" + target(here_, false) + jerk());
  // Paul's law meets it exactly; else it is passed within both zones.
  const double miss = robot_.look_ahead ? std::min(made_.misses.back(), robot_.zone) : kExact;
  made_.misses.back() = miss;
  arrive(here_, miss);
}

/// Back the way it came, or a part of it.
void MotionWriter::reversal() {
  if (made_.path.places.size() < 2) return;
  const Vector3d from = made_.path.places[made_.path.places.size() - 2];
  const Vector3d to = round(here_ + choice_.between(20, 100) / 100.0 * (from - here_));
  if ((to - here_).norm() >= 0.1) straight("MOVEL", to);
}

void MotionWriter::single_axis() {
  if (bends() || !made_.whole) return straight("MOVE", near_place());
  const int axis = choice_.between(0, 1);
  Vector3d to = near_place();
  to[1 - axis] = here_[1 - axis], to.z() = here_.z();
  double miss = 0;
  line("MOVE JOINT " + std::to_string(axis + 1) + " TO " +
       decimal(std::llround(to[axis] * 100), 2) + "mm" + clauses(miss));
  arrive(to, miss);
}

void MotionWriter::profile() {
  static const std::vector<std::string> shapes = {"RECTANGULAR", "TRAPEZOIDAL", "PARABOLIC",
                                                  "COSINE"};
  const Vector3d to = near_place();
  exact();
  line("MOVEL" + target(to, false) + " AT " + std::to_string(robot_.least_speed) + "mm/s PROFILE " +
       choice_.of(shapes));
  made_.leaping.push_back(lines_);
  arrive(to, kExact);
}

/// Several motions that are planned as one.
void MotionWriter::path() {
  in_path_ = true;
  line("PATH DO");
  for (int k = choice_.between(2, 8); k > 0; --k) {
    const int kind = choice_.below(100);
    if (kind < 50) {
      straight("MOVEL", near_place());
    } else if (kind < 75) {
      arc();
    } else {
      dense();
    }
  }
  line("ENDPATH");
  in_path_ = false;
}

/// Where it leads is not followed; the next motion has an absolute target.
void MotionWriter::jog() {
  for (int k = choice_.between(1, 3); k > 0; --k)
    line("JOG " + rates() + " FOR " + seconds(20, 400) +
         (choice_.percent(20) ? " AT " + std::to_string(choice_.between(5, 100)) + "%" : "") +
         (choice_.percent(20) ? " UNTIL " + input() : ""));
  line("MOVE" + target(here_, false));
}

/// A few motions with another tool.
void MotionWriter::other_tool() {
  line("WITH " + std::string(made_.tool.isZero() ? "tip" : "none") + " DO");
  for (int k = choice_.between(1, 4); k > 0; --k) motion();
  line("ENDWITH");
}

void MotionWriter::still() {
  const int kind = choice_.below(100);
  if (kind < 25) return line("STOP"), exact();
  if (kind < 45) return line("WAIT " + seconds(0, 150)), exact();
  if (kind < 75)
    return line("DOUT[" + std::to_string(choice_.between(1, 7)) +
                "] = " + (choice_.percent(50) ? "ON" : "OFF"));
  if (kind < 85) return line("PRINT \"x\"");
  if (kind < 90 || made_.whole)
    return line("OVERRIDE " + std::to_string(choice_.between(10, 180)) + "%");
  line("BRAKE");
}

void MotionWriter::motion() {
  const int kind = choice_.below(100);
  if (kind < 28) return straight("MOVE", near_place());
  if (kind < 32) return reversal();
  if (kind < 35) return single_axis();
  if (kind < 60) return straight("MOVEL", near_place());
  if (kind < 68) return relative();
  if (kind < 80) return arc();
  if (kind < 86) return spline();
  if (kind < 93) return dense();
  if (kind < 96) return repeated();
  profile();
}

void MotionWriter::statement() {
  if (robot_.look_ahead && made_.whole && choice_.percent(5)) return path();
  if (!made_.whole && choice_.percent(10)) {
    if (!jerk_all_ && choice_.percent(60)) return jog();
    if (robot_.kind == Kind::Arm) return other_tool();
  }
  choice_.percent(75) ? motion() : still();
}

/// Leaves the path, and comes back to where it was left.
void MotionWriter::handler() {
  line("WHEN DIN[5] DO");
  line("  MOVEL BY " + way({1, 1, 0}) + jerk());
  line("  WAIT " + seconds(0, 100));
  line("ENDWHEN");
  made_.leaping.push_back(lines_);  // the way back asks for no JERK
}

/// Exactly to where the way begins.
void MotionWriter::first() {
  const std::string turned = robot_.kind == Kind::Arm ? ", " + whole(robot_.turned) + ")" : ")";
  std::string place = target(here_, false);
  place.pop_back();
  line("MOVE" + place + turned + " FINE");
  arrive(here_, kExact);
}

/// A tool for the whole program, or for a part of it.
void MotionWriter::tools() {
  if (robot_.kind == Kind::Linear) return;
  const Vector3d tip(choice_.between(-20, 20), choice_.between(-20, 20),
                     robot_.kind == Kind::Arm ? choice_.between(0, 50) : 0);
  const auto mm = [&](int i) { return std::to_string(std::lround(tip[i])) + "mm"; };
  line("TOOL tip = POSE(" + mm(0) + ", " + mm(1) + ", " + mm(2) + ")");
  line("TOOL none = POSE(0mm, 0mm, 0mm)");
  if (choice_.percent(40)) made_.tool = tip;
}

/// Holds, and what UNTIL waits for.
void MotionWriter::signals() {
  int ms = 0;
  for (int k = choice_.below(4); k > 0; --k) {
    ms += choice_.between(30, 2500);
    made_.signals += "at " + decimal(ms, 3) + "s DIN[1] = ON\n";
    ms += choice_.between(10, 400);
    made_.signals +=
        "at " + decimal(ms, 3) + "s DIN[1] = OFF\nat " + decimal(ms, 3) + "s GO = ON\n";
  }
  // The robot may still be coming to rest when GO is pressed, or be about something else: again.
  for (int again = 1; ms > 0 && again <= 5; ++again)
    made_.signals += "at " + decimal(ms + 3000 * again, 3) + "s GO = ON\n";
  if (made_.whole) return;
  for (int number = 2; number <= 5; ++number)
    made_.signals += "at " + seconds(100, 6000) + " DIN[" + std::to_string(number) + "] = ON\n";
}

RandomMotions MotionWriter::write() {
  made_.whole = choice_.percent(75);
  jerk_all_ = robot_.look_ahead && choice_.percent(30);
  if (jerk_all_) made_.jerk = made_.least_jerk = 1000.0 * choice_.between(2, 100);
  made_.override_share = std::to_string(choice_.percent(60) ? 100 : choice_.between(10, 200)) + "%";
  signals();
  if (robot_.kind != Kind::Arm) line("FRAME shifted = POSE(10mm, -20mm, 0mm, 0deg, 0deg, 0deg)");
  tools();
  if (!made_.tool.isZero()) line("WITH tip DO");
  first();
  line("WHEN DIN[1] : HALT \"held\"");
  if (!made_.whole && choice_.percent(50)) handler();
  for (int k = choice_.between(3, 25); k > 0; --k) statement();
  const Vector3d end = near_place();
  line("MOVE" + target(end, false) + " FINE" + jerk());
  if (bends()) made_.known = false;
  arrive(end, kExact);
  if (!made_.tool.isZero()) line("ENDWITH");
  made_.averaged = made_.text.find("JERK") != std::string::npos;
  for (const AxisBounds& axis : robot_.axes) made_.averaged |= std::isfinite(axis.j);
  return std::move(made_);
}

RandomMotions random_motions(std::uint64_t seed, const MotionRobot& robot) {
  return MotionWriter(seed, robot).write();
}

}  // namespace rob::test

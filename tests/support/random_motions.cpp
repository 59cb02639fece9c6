#include "tests/support/random_motions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/random_text.h"

namespace rob::test {

namespace {

using Eigen::Vector3d;
using Kind = MotionRobot::Kind;

constexpr double kExact = 1e-3;  ///< mm: what a target that is reached may be missed by
constexpr double kAny = 1e9;
const Vector3d kFrame{10, -20, 0};  ///< mm: where the frame `shifted` stands

/// Writes a program and follows its way.
class MotionWriter {
 public:
  MotionWriter(std::uint64_t seed, const MotionRobot& robot)
      : choice_(seed), robot_(robot), here_(round((robot.least + robot.most) / 2)) {}

  RandomMotions write();

 private:
  // Statements.
  void first();
  void statement();
  void still();
  void motion();
  void straight(const std::string& word, const Vector3d& to);
  void relative();
  void arc();
  void spline();
  void dense();
  void repeated();
  void reversal();
  void single_axis();
  void profile();
  void jog();
  void handler();
  void signals();

  // Parts of them.
  void line(const std::string& text) { made_.text += text + "\n", ++lines_; }
  std::string target(const Vector3d& place, bool turns);
  std::string numbers(const Vector3d& place, int count) const;
  std::string pace();
  std::string zone(double& miss);
  std::string clauses(double& miss);
  std::string jerk();
  void finish(const std::string& motion, const std::string& clauses, double length);
  void mark(double length);
  std::string seconds(int least_ms, int most_ms) {
    return decimal(choice_.between(least_ms, most_ms), 3) + "s";
  }

  // The way.
  Vector3d near_place();
  bool inside(const Vector3d& p) const {
    return (p.array() >= robot_.least.array()).all() && (p.array() <= robot_.most.array()).all();
  }
  Vector3d round(const Vector3d& p) const { return (p * 100).array().round() / 100; }
  void arrive(const Vector3d& place, double miss, double beside = 0);
  double bend(double miss) const;
  void exact() { made_.misses.back() = kExact; }

  Choice choice_;
  const MotionRobot& robot_;
  RandomMotions made_;
  Vector3d here_;
  int lines_ = 0;
  int turn_ = 0;  ///< deg: of the gantry's axis
  bool jerk_all_ = false;
  bool marked_ = false;  ///< DOUT[8] is on
};

void MotionWriter::arrive(const Vector3d& place, double miss, double beside) {
  made_.path.places.push_back(place);
  made_.path.points.push_back(made_.path.places.size() - 1);
  made_.misses.push_back(miss);
  made_.besides.push_back(beside);
  here_ = place;
}

/// The mean for the sake of JERK may cut a curve, by no more than the robot's zone nor by more than
/// the corners at its ends miss theirs.
double MotionWriter::bend(double miss) const {
  double bend = robot_.look_ahead && robot_.kind != Kind::Arm ? robot_.zone : 0;
  for (const double end : {miss, made_.misses.back()})
    if (end > kExact) bend = std::min(bend, end);
  return bend;
}

std::string MotionWriter::numbers(const Vector3d& place, int count) const {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += (i > 0 ? ", " : "") + decimal(std::llround(place[i] * 100), 2);
  return text;
}

/// A tuple of the robot's coordinates; `turns`: the orientation may change, too.
std::string MotionWriter::target(const Vector3d& place, bool turns) {
  if (robot_.kind == Kind::Linear) return "(" + numbers(place, 3) + ")";
  if (robot_.kind == Kind::Gantry) {
    if (turns && choice_.percent(30)) turn_ = choice_.between(-170, 170);
    return "(" + numbers(place, 2) + ", " + std::to_string(turn_) + ")";
  }
  if (!turns || choice_.percent(60)) return "(" + numbers(place, 3) + ")";  // as it is turned now
  const auto about = [&](int middle) { return std::to_string(middle + choice_.between(-15, 15)); };
  return "(" + numbers(place, 3) + ", " + about(180) + ", " + about(0) + ", " + about(180) + ")";
}

/// A place of the box, mostly at some small or great distance from here.
Vector3d MotionWriter::near_place() {
  const auto share = [&] { return choice_.below(100'001) / 1e5; };
  for (;;) {
    const double distance = 0.5 * std::pow(robot_.reach / 0.5, share());
    Vector3d way;
    for (int i = 0; i < 3; ++i) way[i] = 2 * share() - 1;
    if (robot_.kind == Kind::Gantry || choice_.percent(50)) way.z() = 0;
    if (way.norm() < 0.1) continue;
    const Vector3d place = round(here_ + distance * way.normalized());
    if (inside(place)) return place;
  }
}

std::string MotionWriter::pace() {
  const int kind = choice_.below(100);
  if (kind < 40)
    return " AT " + std::to_string(choice_.between(robot_.least_speed, robot_.most_speed)) + "mm/s";
  if (kind < 55) return " AT " + std::to_string(choice_.between(5, 100)) + "%";
  if (kind < 62) return " OVER " + seconds(50, 2000);
  return "";
}

/// A ZONE of any kind, and by how much it lets the target be missed.
std::string MotionWriter::zone(double& miss) {
  const int kind = choice_.below(100);
  miss = robot_.zone;
  if (kind < 25) return "";
  if (kind < 65) {
    const int hundredths =
        choice_.percent(50) ? choice_.between(5, 100) : choice_.between(100, 2000);
    // Paul's law makes it greater where the axes need that, and warns.
    miss = robot_.look_ahead ? hundredths / 100.0 : kAny;
    return " ZONE " + decimal(hundredths, 2) + "mm";
  }
  miss = kAny;  // as far as the legs are long
  if (kind < 75) return " ZONE " + seconds(10, 500);
  if (kind < 87) return " ZONE " + std::to_string(choice_.between(5, 100)) + "%";
  miss = kExact;
  return choice_.percent(50) ? " FINE" : " ZONE 0";
}

std::string MotionWriter::clauses(double& miss) {
  std::string text = pace() + zone(miss);
  if (!robot_.look_ahead) return text;
  if (choice_.percent(10))
    text += " ACCEL " + std::to_string(choice_.between(100, 1000)) + "mm/s^2";
  if (jerk_all_) return text + jerk();
  if (!choice_.percent(10)) return text;
  const int thousands = choice_.between(2, 100);
  const double jerk = 1000.0 * thousands;
  made_.least_jerk = made_.least_jerk > 0 ? std::min(made_.least_jerk, jerk) : jerk;
  return text + " JERK " + std::to_string(thousands) + "000mm/s^3";
}

/// What every motion asks for, where all do.
std::string MotionWriter::jerk() {
  return jerk_all_ ? " JERK " + decimal(std::llround(made_.jerk), 0) + "mm/s^3" : "";
}

/// Behind the motion: nothing, a condition that ends it, or outputs on the way.
void MotionWriter::finish(const std::string& motion, const std::string& clauses, double length) {
  if (!made_.whole && choice_.percent(20))
    return line(motion + clauses + " UNTIL DIN[" + std::to_string(choice_.between(2, 4)) + "]");
  if (length < 0.5 || !choice_.percent(15)) return line(motion + clauses);
  line(motion + clauses + " DO");
  mark(length);
  line("ENDMOVE");
}

void MotionWriter::mark(double length) {
  const int hundredths = choice_.between(10, static_cast<int>(std::min(length, 20.0) * 100) - 1);
  const bool after = choice_.percent(50);
  const int lag_ms = choice_.percent(30) ? choice_.between(1, 100) : 0;
  marked_ = !marked_;
  const double place = after ? hundredths / 100.0 : length - hundredths / 100.0;
  made_.marks.push_back({lines_, place, lag_ms / 1000.0});
  line(std::string(after ? "  AFTER " : "  BEFORE ") + decimal(hundredths, 2) + "mm" +
       (lag_ms > 0 ? " LAG " + decimal(lag_ms, 3) + "s" : "") +
       " : DOUT[8] = " + (marked_ ? "ON" : "OFF"));
}

void MotionWriter::straight(const std::string& word, const Vector3d& to) {
  double miss = 0;
  const bool framed = word == "MOVEL" && robot_.kind != Kind::Arm && choice_.percent(15);
  const std::string motion = word + target(framed ? to - kFrame : to, true);
  const std::string how = (framed ? " IN shifted" : "") + clauses(miss);
  finish(motion, how, (to - here_).norm());
  if (word == "MOVE" && robot_.kind == Kind::Arm) made_.known = false;
  arrive(to, miss);
}

/// Counts from where the robot is, so only where that is known.
void MotionWriter::relative() {
  const Vector3d to = near_place();
  if (!made_.whole) return straight("MOVEL", to);
  double miss = 0;
  const std::string motion = "MOVEL BY (" + numbers(to - here_, 3) + ")";
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
  if (robot_.kind == Kind::Arm || !made_.whole) return straight("MOVE", near_place());
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

/// Where it leads is not followed; the next motion has an absolute target.
void MotionWriter::jog() {
  const int speed = choice_.between(1, robot_.least_speed);
  line("JOG WORLD (x: " + std::to_string(choice_.percent(50) ? speed : -speed) + "mm/s) FOR " +
       seconds(20, 400));
  line("MOVE" + target(here_, false));
}

void MotionWriter::still() {
  const int kind = choice_.below(100);
  if (kind < 25) return line("STOP"), exact();
  if (kind < 45) return line("WAIT " + seconds(0, 150)), exact();
  if (kind < 75)
    return line("DOUT[" + std::to_string(choice_.between(1, 7)) +
                "] = " + (choice_.percent(50) ? "ON" : "OFF"));
  if (kind < 85) return line("PRINT \"x\"");
  if (kind < 95 || made_.whole)
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
  if (kind < 98 || made_.whole || jerk_all_) return profile();
  jog();
}

void MotionWriter::statement() { choice_.percent(75) ? motion() : still(); }

/// Leaves the path, and comes back to where it was left.
void MotionWriter::handler() {
  line("WHEN DIN[5] DO");
  line("  MOVEL BY (1, 1, 0)");
  line("  WAIT " + seconds(0, 100));
  line("ENDWHEN");
}

/// Exactly to where the way begins.
void MotionWriter::first() {
  const std::string turned = robot_.kind == Kind::Arm ? ", 180, 0, 180)" : ")";
  std::string place = target(here_, false);
  place.pop_back();
  line("MOVE" + place + turned + " FINE");
  arrive(here_, kExact);
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
  if (made_.whole) return;
  for (int input = 2; input <= 5; ++input)
    made_.signals += "at " + seconds(100, 6000) + " DIN[" + std::to_string(input) + "] = ON\n";
}

RandomMotions MotionWriter::write() {
  made_.whole = choice_.percent(75);
  jerk_all_ = robot_.look_ahead && choice_.percent(30);
  if (jerk_all_) made_.jerk = made_.least_jerk = 1000.0 * choice_.between(2, 100);
  made_.override_share = std::to_string(choice_.percent(60) ? 100 : choice_.between(10, 200)) + "%";
  signals();
  if (robot_.kind != Kind::Arm) line("FRAME shifted = POSE(10mm, -20mm, 0mm, 0deg, 0deg, 0deg)");
  first();
  line("WHEN DIN[1] : HALT \"held\"");
  if (!made_.whole && choice_.percent(50)) handler();
  for (int k = choice_.between(3, 25); k > 0; --k) statement();
  const Vector3d end = near_place();
  line("MOVE" + target(end, false) + " FINE" + jerk());
  if (robot_.kind == Kind::Arm) made_.known = false;
  arrive(end, kExact);
  made_.averaged = made_.text.find("JERK") != std::string::npos;
  for (const AxisBounds& axis : robot_.axes) made_.averaged |= std::isfinite(axis.j);
  return std::move(made_);
}

}  // namespace

RandomMotions random_motions(std::uint64_t seed, const MotionRobot& robot) {
  return MotionWriter(seed, robot).write();
}

}  // namespace rob::test

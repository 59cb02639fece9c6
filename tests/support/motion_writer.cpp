#include "tests/support/motion_writer.h"

#include <algorithm>
#include <cmath>

namespace rob::test {

using Eigen::Vector3d;

void MotionWriter::arrive(const Vector3d& place, double miss, double beside) {
  made_.path.places.push_back(place);
  made_.path.points.push_back(made_.path.places.size() - 1);
  made_.lines.push_back(lines_);
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

/// A tuple that says how far to go.
std::string MotionWriter::way(const Vector3d& by) const {
  return "(" + numbers(by, 3) + (robot_.turning ? ", 0)" : ")");
}

/// A tuple of the robot's coordinates; `turns`: the orientation may change, too.
std::string MotionWriter::target(const Vector3d& place, bool turns) {
  if (robot_.kind == Kind::Linear && !robot_.turning) return "(" + numbers(place, 3) + ")";
  if (robot_.kind != Kind::Arm) {
    // A tool's tip turns the shortest way, which is not to lead beyond the axis' end.
    const int most = made_.tool.isZero() ? 170 : 85;
    if (turns && choice_.percent(30)) turn_ = choice_.between(-most, most);
    if (robot_.turning) return "(" + numbers(place, 3) + ", " + std::to_string(turn_) + ")";
    return "(" + numbers(place, 2) + ", " + std::to_string(turn_) + ")";
  }
  if (!turns || choice_.percent(60)) return "(" + numbers(place, 3) + ")";  // as it is turned now
  Vector3d turned = robot_.turned;
  for (double& angle : turned) angle += choice_.between(-15, 15);
  return "(" + numbers(place, 3) + ", " + whole(turned) + ")";
}

std::string MotionWriter::whole(const Vector3d& numbers) const {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : ", ") + std::to_string(std::lround(number));
  return text;
}

/// Of a JOG in any frame.
std::string MotionWriter::rates() {
  const auto some = [&](int most, const char* unit) {
    return std::to_string(choice_.between(-most, most)) + unit;
  };
  const int kind = choice_.below(100);
  if (kind < 30) {
    std::string text = "JOINT (";
    for (std::size_t i = 0; i < robot_.axes.size(); ++i) {
      const bool linear = i < linear_axes(robot_);
      text += (i > 0 ? ", " : "") + (linear ? some(robot_.least_speed, "mm/s") : some(10, "deg/s"));
    }
    return text + ")";
  }
  const char* const axis = robot_.kind == Kind::Arm      ? "b: "
                           : robot_.kind == Kind::Gantry ? "theta: "
                                                         : "a: ";
  return std::string(kind < 65 ? "WORLD" : "TOOL") + " (x: " + some(robot_.least_speed, "mm/s") +
         ", y: " + some(robot_.least_speed, "mm/s") +
         (turning() ? ", " + std::string(axis) + some(10, "deg/s") : "") + ")";
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
  if (kind < 60 && turning()) return " AT " + std::to_string(choice_.between(10, 100)) + "deg/s";
  if (kind < 67) return " OVER " + seconds(50, 2000);
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
    const bool turn = robot_.look_ahead && turning() && choice_.percent(25);
    return " ZONE " + decimal(hundredths, 2) + "mm" +
           (turn ? " " + std::to_string(choice_.between(1, 20)) + "deg" : "");
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
  else if (turning() && choice_.percent(5))
    text += " ACCEL " + std::to_string(choice_.between(50, 1000)) + "deg/s^2";
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
  if (!made_.whole && choice_.percent(20)) return line(motion + clauses + " UNTIL " + input());
  if (!made_.whole || in_path_ || length < 0.5 || !choice_.percent(15))
    return line(motion + clauses);
  line(motion + clauses + " DO");
  mark(length);
  line("ENDMOVE");
}

void MotionWriter::mark(double length) {
  const int hundredths = choice_.between(10, static_cast<int>(std::min(length, 20.0) * 100) - 1);
  const bool after = choice_.percent(50);
  // Outputs keep their order where none that is late is followed by one that is sooner.
  const int before_ms =
      made_.marks.empty() ? 0 : static_cast<int>(std::lround(made_.marks.back().lag * 1000));
  const int kind = choice_.below(100);
  const int ms = kind < 30 ? 0 : kind < 60 ? choice_.between(1, 100) : -choice_.between(1, 300);
  const int lag_ms = before_ms > 0 ? std::max(ms, before_ms) : ms;
  marked_ = !marked_;
  const double place = after ? hundredths / 100.0 : length - hundredths / 100.0;
  made_.marks.push_back({lines_, place, lag_ms / 1000.0, length});
  const std::string moved = lag_ms == 0 ? "" : lag_ms > 0 ? " LAG " : " LEAD ";
  line(std::string(after ? "  AFTER " : "  BEFORE ") + decimal(hundredths, 2) + "mm" +
       (moved.empty() ? "" : moved + decimal(std::abs(lag_ms), 3) + "s") +
       " : DOUT[8] = " + (marked_ ? "ON" : "OFF"));
}

}  // namespace rob::test

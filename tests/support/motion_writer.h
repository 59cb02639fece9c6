#pragma once

#include <cstdint>
#include <string>

#include "tests/support/random_motions.h"
#include "tests/support/random_text.h"

namespace rob::test {

inline constexpr double kExact = 1e-3;  ///< mm: what a target that is reached may be missed by
inline constexpr double kAny = 1e9;
inline const Eigen::Vector3d kFrame{10, -20, 0};  ///< mm: where the frame `shifted` stands

/// Writes a program and follows its way: what random_motions() is made of.
class MotionWriter {
 public:
  MotionWriter(std::uint64_t seed, const MotionRobot& robot)
      : choice_(seed), robot_(robot), here_(round((robot.least + robot.most) / 2)) {}

  RandomMotions write();

 private:
  using Kind = MotionRobot::Kind;

  // Statements.
  void first();
  void statement();
  void still();
  void motion();
  void straight(const std::string& word, const Eigen::Vector3d& to);
  void relative();
  void arc();
  void spline();
  void dense();
  void repeated();
  void reversal();
  void single_axis();
  void profile();
  void path();
  void jog();
  void other_tool();
  void handler();
  void tools();
  void signals();

  // Parts of them.
  void line(const std::string& text) { made_.text += text + "\n", ++lines_; }
  std::string target(const Eigen::Vector3d& place, bool turns);
  std::string way(const Eigen::Vector3d& by) const;
  std::string numbers(const Eigen::Vector3d& place, int count) const;
  std::string whole(const Eigen::Vector3d& numbers) const;
  std::string input() { return "DIN[" + std::to_string(choice_.between(2, 4)) + "]"; }
  std::string rates();
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
  Eigen::Vector3d near_place();
  bool inside(const Eigen::Vector3d& p) const {
    return (p.array() >= robot_.least.array()).all() && (p.array() <= robot_.most.array()).all();
  }
  Eigen::Vector3d round(const Eigen::Vector3d& p) const { return (p * 100).array().round() / 100; }
  void arrive(const Eigen::Vector3d& place, double miss, double beside = 0);
  double bend(double miss) const;
  /// Where the axes lead the tool's tip on a curve.
  bool bends() const { return robot_.kind == Kind::Arm || !made_.tool.isZero(); }
  bool turning() const { return robot_.kind != Kind::Linear || robot_.turning; }
  void exact() { made_.misses.back() = kExact; }

  Choice choice_;
  const MotionRobot& robot_;
  RandomMotions made_;
  Eigen::Vector3d here_;
  int lines_ = 0;
  int turn_ = 0;  ///< deg: of the gantry's axis
  bool jerk_all_ = false;
  bool in_path_ = false;  ///< between PATH and ENDPATH
  bool marked_ = false;   ///< DOUT[8] is on
};

}  // namespace rob::test

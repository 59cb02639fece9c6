#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lang/text/diagnostic.h"
#include "motion/collision/path_proof.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/run/run_result.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// Follows the references of a run that is foretold, and finds where the robot would hit itself or
/// what stands around it, and which obstacles it passes closely. A robot whose file names no bodies
/// is not looked at.
class ContactWatch {
 public:
  explicit ContactWatch(const motion::RobotModel& robot);

  /// The part in the gripper of the simulated cell reaches so far from its tip, m; 0: it holds
  /// nothing.
  void hold(double below_tip) { holds_ = below_tip; }
  /// A motion begins, s.
  void begin(const LoggedSegment& motion, double time);
  /// It is over; early: it has not come to its end.
  void end(const LoggedSegment& motion, bool early);
  /// The next reference.
  void take(const Snapshot& snapshot);
  /// The first contact. Nothing after it is looked at: the program ends there.
  const std::optional<Contact>& contact() const { return contact_; }
  /// At most one of a line: obstacles that are passed more closely than the file's `clearance`.
  std::vector<lang::Diagnostic> finish();
  /// The motions that were followed to their end and hit nothing. `early_ones`: those that ended
  /// early, too.
  std::shared_ptr<const ClearedWays> cleared(bool early_ones) const;

 private:
  using Shared = std::shared_ptr<const motion::Clearance>;

  /// An obstacle that is passed closely, and what passes it.
  struct Near {
    std::string body;
    std::string other;
    double distance = 0;  ///< m
  };

  void watch(const Shared& clearance);
  void go_on_in(int line);
  void keep_nearest();
  lang::Diagnostic warning_of(int line, const Near& near) const;
  Contact described(const motion::PathProof::Contact& touch, const Snapshot& snapshot) const;

  const motion::RobotModel& robot_;
  Shared next_clearance_;  ///< of the motion that has begun last
  Shared clearance_;       ///< of the motion whose references are followed
  Shared watched_;         ///< the same with what the gripper holds
  motion::PathProof proof_;
  double holds_ = 0;   ///< m
  double held_ = 0;    ///< by what is watched
  int line_ = 0;       ///< tag of the motion whose references are followed
  double begun_ = 0;   ///< s: when that motion began
  bool first_ = true;  ///< no reference has come
  bool next_ = false;  ///< a motion has begun since the last one
  int begins_ = 0;     ///< its tag
  double at_ = 0;      ///< s: when it did
  std::vector<std::uint64_t> whole_;
  std::vector<std::uint64_t> cut_;
  std::optional<Contact> contact_;
  std::map<int, Near> nearest_;  // by line
};

}  // namespace rob::runtime

#pragma once

#include <optional>
#include <vector>

#include "lang/text/diagnostic.h"
#include "motion/collision/path_proof.h"
#include "motion/robots/robot_model.h"
#include "runtime/run/run_result.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// Follows the references of a run that is foretold, and finds where the robot would hit itself or
/// what stands around it, and which obstacles it passes closely. A robot whose file names no bodies
/// is not looked at.
class ContactWatch {
 public:
  explicit ContactWatch(const motion::RobotModel& robot);

  /// The next reference; `line` is the tag of the motion that runs, 0 between two of them.
  void take(const Snapshot& snapshot, int line);
  /// The first contact. Nothing after it is looked at: the program ends there.
  const std::optional<Contact>& contact() const { return contact_; }
  /// At most one of a line: obstacles that are passed more closely than the file's `clearance`.
  std::vector<lang::Diagnostic> finish();

 private:
  void begin_line(int line, double time);
  void close_line();
  Contact described(const motion::PathProof::Contact& touch, const Snapshot& snapshot) const;

  const motion::RobotModel& robot_;
  motion::Clearance clearance_;
  motion::PathProof proof_;
  int line_ = 0;
  double begun_ = 0;  ///< s: when the line began
  bool first_ = true;
  std::optional<Contact> contact_;
  std::vector<lang::Diagnostic> close_;
};

}  // namespace rob::runtime

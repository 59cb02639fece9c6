#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lang/text/diagnostic.h"
#include "lang/vm/vm.h"
#include "motion/kinematics/kinematics.h"
#include "runtime/command/way_marks.h"
#include "runtime/run/line_totals.h"
#include "runtime/words/contact_words.h"

namespace rob::runtime {

/// Exit codes of `rob` (docs/cli.md).
enum class ExitCode : int {
  Done = 0,
  Usage = 64,
  ProgramError = 65,
  Fault = 70,
  InputOutput = 74,
  HungUp = 129,
  Interrupted = 130,
  Terminated = 143
};

/// Here and below `line` is a lang::line_tag().
struct SignalChange {
  double time = 0;
  std::string name;
  bool value = false;
  std::optional<double> number{};  ///< of an analog output, in `unit`
  std::string unit{};
  int line = 0;
};

struct RunEvent {
  double time = 0;
  std::string kind;
  int line = 0;
  std::string text;
  std::vector<double> joints{};  ///< the reference of the cycle before, mm or deg
};

/// The greatest values that an axis was asked for: mm, deg and their rates.
struct AxisPeak {
  std::string axis;
  double v = 0;
  double a = 0;
  double j = 0;
};

/// Where a path under the look-ahead law is much slower than asked for, and why.
struct SlowPlace {
  enum class Cause : std::uint8_t { Speed, Acceleration, Jerk, EndOfPath };

  int line = 0;
  double time = 0;   ///< s
  double at = 0;     ///< mm from the beginning of the motion
  double speed = 0;  ///< mm/s
  double asked = 0;  ///< mm/s
  Cause cause = Cause::Speed;
  std::string axis{};  ///< of Speed and Acceleration
  bool corner = false;
  motion::SingularPlace near = motion::SingularPlace::None;
};

/// An error, as JSON and people get it.
struct Problem {
  std::string code;
  std::string file;
  lang::Place place;
  std::string message;
  std::string help;
  std::vector<lang::CallSite> calls{};  ///< the routines it happened in, the innermost first
  std::vector<std::string> used{};      ///< as of RunResult: for the lines of `calls`
};

/// Everything that `rob run` and `rob check` report about one program.
struct RunResult {
  std::string status = "done";  ///< done | program-error | fault | interrupted
  ExitCode exit_code = ExitCode::Done;
  std::string file;
  std::vector<std::string> used;  ///< names of the files that it USEs, by lang::Place::file from 1
  std::string robot;
  std::string law = "paul";
  std::string clock;
  double planned = 0;    ///< s
  bool foretold = true;  ///< `planned` is known
  double measured = 0;   ///< s
  std::int64_t cycles = 0;
  std::int64_t late_cycles = 0;
  double worst_lateness = 0;  ///< s
  LineTotals lines;
  /// Where the axes stand, mm or deg: at their references; after a fault, what was measured of an
  /// axis that is off its reference.
  std::vector<double> final_joints;
  std::vector<double> final_measured;   ///< mm, deg
  std::vector<double> final_reference;  ///< mm, deg
  std::string stands;                   ///< for people: "x 100 mm, theta 90 deg", measured
  std::vector<double> final_pose;       ///< of final_joints: x, y, z in mm, a, b, c in deg
  // The first and the last 5000 of each, and the number of all.
  std::vector<SignalChange> signals;
  std::vector<std::string> output;
  std::vector<RunEvent> events;
  std::int64_t signals_count = 0;
  std::int64_t output_count = 0;
  std::int64_t events_count = 0;
  std::vector<lang::Diagnostic> findings;
  std::size_t findings_left_out = 0;  ///< see ProgramLog::findings()
  std::optional<Problem> error;
  std::int64_t starved = 0;          ///< decision points at which nothing was known
  std::int64_t dropped_effects = 0;  ///< outputs and prints after a fault or an interruption
  std::int64_t lost_rows = 0;        ///< of the trace
  double worst_saturation = 0;       ///< greatest force demanded / what the drive can give
  std::vector<AxisPeak> peaks;
  double deviation = 0;  ///< mm: the greatest distance from the programmed path or points
  std::vector<SlowPlace> slow_places;  ///< the slowest first
  std::optional<Contact> contact;      ///< that was foretold: the error, then
  std::vector<double> contact_joints;  ///< there, mm or deg
  /// From foretell(): the motions that hit nothing; see ContactProof.
  std::shared_ptr<const ClearedWays> cleared{};
};

}  // namespace rob::runtime

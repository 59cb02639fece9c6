#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "lang/text/diagnostic.h"
#include "motion/collision/clearance.h"
#include "motion/plan/planned_leg.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::runtime {

/// A motion as it was planned. Thousands may be under way.
struct LoggedSegment : motion::SegmentMotion {
  bool stop = false;     ///< made by STOP, WAIT or the end of the program, not by a MOVE
  bool further = false;  ///< belongs to the same statement as the one before
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();         ///< of the tool, seen from the flange, m
  std::shared_ptr<const motion::PlannedLeg> leg{};       ///< what the segment points into
  std::uint64_t known_by = 0;                            ///< of a motion: WayMarks
  std::shared_ptr<const motion::Clearance> clearance{};  ///< of a motion: what it must not hit
};

/// An EXPECT that did not hold, and what it found.
struct FailedExpect {
  int line = 0;
  std::string text;
};

/// A text of the program whose turn comes in motion order.
struct Note {
  enum class Kind : std::uint8_t {
    Print,
    Halt,     ///< shown to the operator, who lets the program go on
    Ask,      ///< shown to the operator, who answers
    Answer,   ///< what the operator has answered; to a HALT nothing
    Write,    ///< a line for `file`
    Persist,  ///< the value of `variable`
    Send,     ///< to the device `variable`
    Line      ///< from it, simulated
  };

  Kind kind = Kind::Print;
  std::string text;
  bool typed = false;  ///< by a person, who has seen it
  std::string file{};
  std::size_t variable = 0;
  double after = 0;  ///< s, of Line
};

/// The program's thread leaves here for the thread that reports: motions as they were planned,
/// texts to be printed when their turn comes, findings. Not for the tick: it locks and allocates.
class ProgramLog {
 public:
  void planned(const LoggedSegment& segment);
  /// An effect has been queued.
  void queued_effect();
  /// Keeps a text until its effect is due; the number goes with the effect.
  std::uint32_t keep(Note note);
  void found(lang::Diagnostic finding);
  void expect_failed(FailedExpect failure);

  /// Segment `number`, once; those before it of the program, or of handlers, are forgotten.
  std::optional<LoggedSegment> take_planned(std::uint32_t number);
  /// Once.
  Note take_note(std::uint32_t id);
  /// The first of them, one for each code and place, and of each code the first whatever else has
  /// been found; of the others the number.
  std::vector<lang::Diagnostic> findings() const;
  std::size_t findings_left_out() const;
  std::int64_t effects() const;
  /// The first of them; a loop could make any number.
  std::vector<FailedExpect> failed_expects() const;
  std::size_t failed_expects_left_out() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::uint32_t, LoggedSegment> planned_;  ///< by number
  std::map<std::uint32_t, Note> notes_;             ///< by number
  std::uint32_t next_note_ = 0;
  std::vector<lang::Diagnostic> findings_;
  using Found = std::tuple<std::string, std::uint32_t, std::uint32_t, std::uint32_t>;
  std::set<Found> found_;            ///< code, file, line, column
  std::map<std::string, int> kept_;  ///< of each code, in findings_
  std::int64_t effects_ = 0;
  static constexpr std::size_t kMostFailedExpects = 100;
  std::vector<FailedExpect> failed_expects_;
  std::size_t failed_expects_left_out_ = 0;
};

}  // namespace rob::runtime

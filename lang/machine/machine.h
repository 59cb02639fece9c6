#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lang/machine/move_command.h"
#include "lang/machine/point_table.h"
#include "lang/machine/reading.h"
#include "lang/text/diagnostic.h"
#include "lang/values/arithmetic.h"
#include "lang/values/pose_math.h"
#include "lang/values/setting.h"

namespace rob::lang {

struct Watch;  // lang/code/watch.h

/// The longest PULSE, s. [choice] longer than anything that is called a pulse, and an end of the
/// program waits for it.
inline constexpr double kLongestPulse = 1000;

/// Where a path event lies. SI.
struct PathPlace {
  bool before = false;  ///< BEFORE: counts back from the end of the motion
  double distance = 0;  ///< m of the tool's way
  double lead = 0;      ///< LEAD: s before the place is passed; LAG: below 0
  Place written = {};   ///< in the program
};
/// The longest LEAD and LAG, s. [choice] longer than any valve takes.
inline constexpr double kLongestLead = 0.5;

/// What became of a command.
enum class Reply : std::uint8_t {
  Done,    ///< taken
  Later,   ///< nothing has happened; give the same command again when woken
  Refused  ///< it cannot be done; Machine::refusal() says why
};

/// Why a command was refused, in words for people.
struct Refusal {
  std::string code;
  std::string message;
  std::string help;
  Place place = {};  ///< where, if not at the command itself
};

/// All that a program can do to the world. The Vm calls it in program order and knows nothing
/// else of motion; PrintingMachine, behind the same interface, writes the calls down for tests.
///
/// `line` is the source line that asked, or `place` where exactly. Values are SI. Every call
/// returns at once.
class Machine {
 public:
  virtual ~Machine() = default;

  virtual Reply move(int line, const MoveCommand& command) = 0;
  /// MOVEC, MOVES: a point through which the motion commanded next goes; of `point` what says where
  /// counts. Called for each point, in their order.
  virtual Reply via(int line, const MoveCommand& point) = 0;
  /// WITH, IN: what motions, HERE, TARGET, forward() and inverse() mean from here on.
  virtual void work_in(int line, const Setting& setting) = 0;
  /// PATH: the motions up to end_path() are planned as one before it starts. What is set or pulsed
  /// on_the_way() there counts along the whole path. settle() drops a path that is still open.
  virtual Reply begin_path(int line) = 0;
  virtual Reply end_path(int line) = 0;
  /// PRESS: from standstill on the reaction along the axis is kept at its force, in the frame that
  /// work_in() has named last, until end_press(). settle() does not end it.
  virtual Reply press(int line, const PressCommand& command) = 0;
  virtual Reply end_press(int line) = 0;
  /// OVERRIDE: in motion order, a share of the programmed speed, above 0 up to kMostOverride.
  virtual Reply override_speed(int line, double share) = 0;
  /// LOAD: what the robot carries beside its tool, from this point of motion order on.
  virtual Reply carry(int line, const LoadCommand& load) = 0;
  /// UNTIL: the motion that is commanded next ends early, in the first control cycle in which the
  /// condition holds; else it is exact. ended() has to follow it.
  virtual Reply guard(int line, const Watch& condition) = 0;
  /// Behind a guarded motion. `Later` until it has ended; `hit`: because its condition held.
  /// Refused where the condition could not be computed: the motion has ended, too.
  virtual Reply ended(int line, bool& hit) = 0;
  /// WHEN: what is set or pulsed next, or what when_raise() says, is not done now, but in every
  /// control cycle in which the condition comes true, from here on in motion order.
  virtual Reply when(int line, const Watch& condition, int& id) = 0;
  /// The action: the axes brake, all that was commanded is dropped, and the program fails.
  virtual Reply when_raise(const Place& place, std::string_view text) = 0;
  /// The action: a handler, which Vm::handle() begins. `stops`: the axes come to rest on their path
  /// before, and the handler has them.
  virtual Reply when_handle(int line, bool stops) = 0;
  /// A handler is at its end: `Later` until the axes are back where they left the path. Asked of
  /// the machine that the handler commands.
  virtual Reply leave_handler(int line) = 0;
  /// What is set or pulsed next is not done now, but on the way of the motion commanded next.
  virtual Reply on_the_way(int line, const PathPlace& place) = 0;
  /// The block of a WHEN is left. An observation: `Later` until the decision point of the last
  /// motion.
  virtual Reply disarm(int line, int id) = 0;
  /// AT LIVE: the pace of the motion that is commanded next, computed anew in every control cycle.
  virtual Reply live_pace(int line, const Watch& pace, MoveCommand::Pace means) = 0;
  /// ZERO force: the last target is reached exactly, and what the force sensor tells then is 0.
  virtual Reply zero_force(int line) = 0;
  /// STOP: the last target is reached exactly.
  virtual Reply stop(int line) = 0;
  /// BRAKE: as soon as the last motion is the running one, it is braked on its path; its rest is
  /// dropped, with what is bound to it, and the axes stand there. Done at standstill, or at once
  /// where nothing moves any more.
  virtual Reply brake(int line) = 0;
  /// HALT: the last target is reached exactly, all that was commanded has acted, `text` (empty:
  /// none) is shown; Done when the operator says so. Refused where nobody is there to say it.
  virtual Reply halt(int line, std::string_view text) = 0;
  /// ASK: as halt(), and Done with a line that the operator has typed; with none where the program
  /// is only foretold.
  virtual Reply ask(int line, std::string_view text, std::optional<std::string>& answer) = 0;
  /// WAIT 0.5s: the last target is reached exactly, then the axes stand for `seconds`, 0 or more.
  virtual Reply wait(int line, double seconds) = 0;
  /// The condition of a WAIT is due: the last target is reached exactly, and all that was commanded
  /// has acted. `now`: the time of the present control cycle, s. An observation: `Later` until the
  /// axes stand. Called again in every cycle until waited().
  virtual Reply stand(int line, double& now) = 0;
  /// Whether a WAIT whose condition has just been found FALSE is to be taken as met: while a
  /// program is foretold, nobody sets the inputs that it may wait for.
  virtual bool taken_as_met(int line) = 0;
  /// The condition that stand() was for has been met, or its time is over.
  virtual Reply waited(int line) = 0;
  /// A TRY block is left: an observation, Done at the decision point of the last motion. What goes
  /// wrong from then on is no longer the block's.
  virtual Reply leave_block(int line) = 0;
  /// The program has gone wrong in a TRY block: the last target is reached exactly, and all that
  /// was commanded acts. Done when the axes stand and nothing is left to do. Never refused; ends
  /// whatever WAIT was under way.
  virtual Reply settle(int line) = 0;
  /// TEACH: keeps where the axes stand as a point. HERE and JOINTS() have been read just before.
  /// May take as long as a file takes to be written. Refused where it cannot be kept; what was kept
  /// before is still there then.
  virtual Reply teach(int line, const TaughtPoint& point) = 0;
  /// END, written or implied by the end of the file: stops, and is Done once all that was
  /// commanded has been queued (not: carried out).
  virtual Reply end(int line) = 0;
  /// Prints `text` (one line, without its line end) in motion order.
  virtual Reply print(int line, std::string_view text) = 0;
  /// Sets an output, by its index in the RobotSignature, in motion order.
  virtual Reply write_signal(int line, int signal, bool value) = 0;
  /// The same of an analog one, in V; what the channel cannot carry is cut, with a warning.
  virtual Reply write_analog(int line, int signal, double volts) = 0;
  /// Switches a digital output ON in motion order, and OFF again `seconds` later.
  virtual Reply pulse(int line, int signal, double seconds) = 0;
  /// An EXPECT of a TEST does not hold; `text` says what it found. The TEST goes on.
  virtual Reply expectation_failed(int line, std::string_view text) = 0;
  /// From `after` seconds behind this point of motion order on, an input has this value (1 for ON,
  /// V), whatever the machine says.
  virtual Reply simulate(int line, int signal, double value, double after) = 0;
  /// The same of one part of what the force sensor tells: N of force x, y, z, then Nm of torque x,
  /// y, z, in the frame that work_in() has named last.
  virtual Reply simulate_force(int line, int component, double value, double after) = 0;
  /// In the same way the operator lets a HALT go on (if `go`), or answers an ASK.
  virtual Reply simulate_go(int line, bool go, double after) = 0;
  virtual Reply simulate_answer(int line, std::string_view text, double after) = 0;
  /// START: the TASK of that number runs beside the program, from this point of motion order on.
  virtual Reply start(const Place& place, std::uint32_t task) = 0;
  /// What TASKs see of the program's globals: from this point of motion order on the slots from
  /// `first` on have these values; or, an observation, what they are.
  virtual Reply publish(int line, std::size_t first, std::span<const Slot> values) = 0;
  virtual Reply publish(int line, std::size_t first, std::span<const std::string> texts) = 0;
  virtual Reply refresh(int line, std::size_t first, std::span<Slot> values) = 0;
  virtual Reply refresh(int line, std::size_t first, std::span<std::string> texts) = 0;
  /// Reads a signal at the decision point of the motion commanded before. An observation:
  /// `Later` until that instant has come.
  virtual Reply read_signal(int line, int signal, bool& value) = 0;
  virtual Reply read_analog(int line, int signal, double& volts) = 0;
  /// What a name of the language stands for, into as many slots as Reading says. `Later` as for a
  /// signal if it is an observation.
  virtual Reply read(int line, Reading what, Slot* value) = 0;
  /// The tool's pose for axis values, and axis values for a pose, of all that reach it those
  /// nearest to `near`; without `near` to the last target. Refused where the robot cannot.
  virtual Reply forward(int line, std::span<const double> joints, PoseValue& pose) = 0;
  virtual Reply inverse(int line, const PoseValue& pose, std::span<const double> near,
                        std::span<double> joints) = 0;
  /// Valid after a Refused reply, until the next call.
  virtual const Refusal& refusal() const = 0;
};

}  // namespace rob::lang

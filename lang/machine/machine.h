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

/// The result of a command.
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

/// The common base of all parts of a Machine: why the last command was refused.
class Refuser {
 public:
  virtual ~Refuser() = default;

  /// Valid after a Refused reply, until the next call.
  virtual const Refusal& refusal() const { return refusal_; }

 protected:
  Refuser() = default;
  Refuser(const Refuser&) = default;
  Refuser& operator=(const Refuser&) = default;

  /// Refuses a command for this reason.
  Reply refuse(Refusal why);
  /// Refuses what this machine does not have: `what` is the word of the language, "ASK".
  Reply has_no(std::string_view what);

 private:
  Refusal refusal_;
};

/// Motions, and what says how they are made. All is done in motion order.
class Motions : public virtual Refuser {
 public:
  virtual Reply move(int line, const MoveCommand& command);
  /// MOVEC, MOVES: a point through which the motion commanded next goes; of `point` what says where
  /// counts. Called for each point, in their order.
  virtual Reply via(int line, const MoveCommand& point);
  /// WITH, IN: what motions, HERE, TARGET, forward() and inverse() mean from here on.
  virtual void work_in(int line, const Setting& setting);
  /// PATH: the motions up to end_path() are planned as one before it starts. Outputs set or pulsed
  /// on_the_way() there count along the whole path. settle() drops a path that is still open.
  virtual Reply begin_path(int line);
  virtual Reply end_path(int line);
  /// The next output is not set or pulsed now, but on the way of the motion commanded next.
  virtual Reply on_the_way(int line, const PathPlace& place);
  /// AT LIVE: the pace of the motion that is commanded next, computed anew in every control cycle.
  virtual Reply live_pace(int line, const Watch& pace, MoveCommand::Pace means);
  /// OVERRIDE: a share of the programmed speed, above 0 up to kMostOverride.
  virtual Reply override_speed(int line, double share);
  /// LOAD: what the robot carries beside its tool, from here on.
  virtual Reply carry(int line, const LoadCommand& load);
  /// STOP: the last target is reached exactly.
  virtual Reply stop(int line);
  /// BRAKE: as soon as the last motion is the running one, it is braked on its path; its rest is
  /// dropped, with what is bound to it, and the axes stand there. Done at standstill, or at once
  /// where nothing moves any more.
  virtual Reply brake(int line);
  /// WAIT 0.5s: the last target is reached exactly, then the axes stand for `seconds`, 0 or more.
  virtual Reply wait(int line, double seconds);
  /// END, written or implied by the end of the file: stops, and is Done once all that was
  /// commanded has been queued (not: carried out).
  virtual Reply end(int line);
  /// The tool's pose for axis values, and axis values for a pose, of all that reach it those
  /// nearest to `near`; without `near` to the last target. Refused where the robot cannot.
  virtual Reply forward(int line, std::span<const double> joints, PoseValue& pose);
  virtual Reply inverse(int line, const PoseValue& pose, std::span<const double> near,
                        std::span<double> joints);
};

/// Outputs and inputs, and what watches them: UNTIL, WHEN, WAIT for a condition. A signal is named
/// by its index in the RobotSignature.
class Signals : public virtual Refuser {
 public:
  /// Sets an output in motion order.
  virtual Reply write_signal(int line, int signal, bool value);
  /// Sets an analog output, in V, in motion order; a value that the channel cannot carry is cut,
  /// with a warning.
  virtual Reply write_analog(int line, int signal, double volts);
  /// Switches a digital output ON in motion order, and OFF again `seconds` later.
  virtual Reply pulse(int line, int signal, double seconds);
  /// Reads a signal at the decision point of the motion commanded before. An observation:
  /// `Later` until that instant has come.
  virtual Reply read_signal(int line, int signal, bool& value);
  /// Reads `count` digital channels from `signal` on in one cycle; the first is the lowest bit.
  virtual Reply read_group(int line, int signal, int count, std::int64_t& value);
  virtual Reply read_analog(int line, int signal, double& volts);
  /// UNTIL: the motion that is commanded next ends early, in the first control cycle in which the
  /// condition holds; else it is exact. ended() must follow it.
  virtual Reply guard(int line, const Watch& condition);
  /// After a guarded motion. `Later` until it has ended; `hit`: because its condition held.
  /// Refused where the condition could not be computed: the motion has ended, too.
  virtual Reply ended(int line, bool& hit);
  /// WHEN: what is set or pulsed next, or what when_raise() says, is not done now, but in every
  /// control cycle in which the condition comes true, from here on in motion order.
  virtual Reply when(int line, const Watch& condition, int& id);
  /// The action: the axes brake, all that was commanded is dropped, and the program fails.
  virtual Reply when_raise(const Place& place, std::string_view text);
  /// The action: a handler, which Vm::handle() begins. `stops`: the axes come to rest on their path
  /// before, and the handler has them.
  virtual Reply when_handle(int line, bool stops);
  /// A handler is at its end: `Later` until the axes are back where they left the path. Asked of
  /// the machine that the handler commands.
  virtual Reply leave_handler(int line);
  /// The block of a WHEN is left. An observation: `Later` until the decision point of the last
  /// motion.
  virtual Reply disarm(int line, int id);
  /// The condition of a WAIT is due: the last target is reached exactly, and all that was commanded
  /// has acted. `now`: the time of the current control cycle, s. An observation: `Later` until the
  /// axes stand. Called again in every cycle until waited().
  virtual Reply stand(int line, double& now);
  /// Whether a WAIT whose condition has just been found FALSE counts as met: while a program is
  /// foretold, nobody sets the inputs that it may wait for.
  virtual bool taken_as_met(int line);
  /// The condition that stand() was for has been met, or its time is over.
  virtual Reply waited(int line);
};

/// Texts that a program writes for people.
class Output : public virtual Refuser {
 public:
  /// Prints `text` (one line, without its line end) in motion order.
  virtual Reply print(int line, std::string_view text);
};

/// The files of a program.
class Files : public virtual Refuser {
 public:
  /// WRITE: appends `text` as a line to the file, in motion order. Refused where the program may
  /// not write it, or could not write what came before.
  virtual Reply write(int line, std::string_view file, std::string_view text);
  /// A PERSIST variable, by its number, has this value, written as the language reads it, from this
  /// point of motion order on.
  virtual Reply persist(int line, std::size_t variable, std::string_view value);
  /// READ: all of the file. As halt(), but the answer comes by itself.
  virtual Reply read_file(int line, std::string_view file, std::string& text);
  /// Something strange in a file that was read, and is no error.
  virtual void warn(int line, Refusal warning);
  /// EXISTS: whether the file is there. An observation.
  virtual Reply exists(int line, std::string_view file, bool& value);
};

/// Devices that exchange lines of text with a program. A device is named by its number.
class Devices : public virtual Refuser {
 public:
  /// SEND, in motion order. Lines that have come before and were not received are dropped.
  virtual Reply send(int line, std::size_t device, std::string_view text);
  /// RECEIVE: an observation. `came`: a line is there; a line that is not there at the decision
  /// point is waited for at standstill, for `timeout` seconds from the first look on.
  virtual Reply receive(int line, std::size_t device, double timeout, std::string& text,
                        bool& came);
  /// SIMULATE: it sends this line, `after` seconds after this point of motion order.
  virtual Reply simulate_line(int line, std::size_t device, std::string_view text, double after);
};

/// Questions of a program to the person beside the machine.
class Operator : public virtual Refuser {
 public:
  /// HALT: the last target is reached exactly, all that was commanded has acted, `text` (empty:
  /// none) is shown; Done when the operator says so. Refused where nobody is there to say it.
  virtual Reply halt(int line, std::string_view text);
  /// ASK: as halt(), and Done with a line that the operator has typed; with none where the program
  /// is only foretold.
  virtual Reply ask(int line, std::string_view text, std::optional<std::string>& answer);
  /// TEACH: keeps where the axes stand as a point. HERE and JOINTS() have been read just before;
  /// where less is kept of them, as in a file with few digits, `point` then has what is kept.
  /// May take as long as a file takes to be written. Refused where it cannot be kept; what was kept
  /// before is still there then.
  virtual Reply teach(int line, TaughtPoint& point);
};

/// Forces of the tool.
class Force : public virtual Refuser {
 public:
  /// PRESS: from standstill on the reaction along the axis is kept at its force, in the frame that
  /// work_in() has named last, until end_press(). settle() does not end it.
  virtual Reply press(int line, const PressCommand& command);
  virtual Reply end_press(int line);
  /// ZERO force: the last target is reached exactly, and the force that the sensor measures then
  /// counts as 0.
  virtual Reply zero_force(int line);
};

/// Actions of a TEST on the world around the program.
class Testing : public virtual Refuser {
 public:
  /// An EXPECT of a TEST does not hold; `text` says what it found. The TEST goes on.
  virtual Reply expectation_failed(int line, std::string_view text);
  /// From `after` seconds after this point of motion order on, an input has this value (1 for ON,
  /// V), whatever the machine says.
  virtual Reply simulate(int line, int signal, double value, double after);
  /// The same for one part of the measured force: N of force x, y, z, then Nm of torque x, y, z,
  /// in the frame that work_in() has named last.
  virtual Reply simulate_force(int line, int component, double value, double after);
  /// In the same way the operator lets a HALT go on (if `go`), or answers an ASK.
  virtual Reply simulate_go(int line, bool go, double after);
  virtual Reply simulate_answer(int line, std::string_view text, double after);
};

/// The elements of a LIST, one after the other.
struct ListContent {
  Slots size;  ///< of an element
  std::size_t count = 0;
  std::span<const Slot> numbers;
  std::span<const std::string> texts;
};

/// The state that a program shares with its TASKs.
class Shared : public virtual Refuser {
 public:
  /// START: the TASK of that number runs beside the program, from this point of motion order on.
  virtual Reply start(const Place& place, std::uint32_t task);
  /// The program's globals as TASKs see them: from this point of motion order on the slots from
  /// `first` on have these values; or, an observation, what they are.
  virtual Reply publish(int line, std::size_t first, std::span<const Slot> values);
  virtual Reply publish(int line, std::size_t first, std::span<const std::string> texts);
  /// The same of a LIST, by the place of its slot; TASKs only look at it.
  virtual Reply publish_list(int line, std::size_t home, const ListContent& list);
  virtual Reply refresh(int line, std::size_t first, std::span<Slot> values);
  virtual Reply refresh(int line, std::size_t first, std::span<std::string> texts);
};

/// All that a program can do to the world. The Vm calls it in program order and knows nothing else
/// of motion. PrintingMachine implements the same interface and writes the calls down for tests.
///
/// `line` is the source line that asked, or `place` where exactly. Values are SI. Every call
/// returns at once. A machine overrides what it has: all other commands are refused by name ("this
/// machine has no ASK", E344), apart from those that only end something (stop, end, settle, waited,
/// leave_block, work_in), which are Done.
class Machine : public Motions,
                public Signals,
                public Output,
                public Files,
                public Devices,
                public Operator,
                public Force,
                public Testing,
                public Shared {
 public:
  /// Reads the value that a name of the language stands for, into as many slots as Reading says.
  /// `Later` as for a signal if it is an observation.
  virtual Reply read(int line, Reading what, Slot* value);
  /// A TRY block is left: an observation, Done at the decision point of the last motion. An error
  /// from then on is no longer the block's.
  virtual Reply leave_block(int line);
  /// The program has gone wrong in a TRY block: the last target is reached exactly, and all that
  /// was commanded acts. Done when the axes stand and nothing is left to do. Never refused; ends
  /// whatever WAIT was under way.
  virtual Reply settle(int line);
};

}  // namespace rob::lang

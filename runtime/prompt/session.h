#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/prompt/dead_man.h"
#include "runtime/prompt/live_robot.h"
#include "runtime/prompt/run_texts.h"
#include "runtime/prompt/screen.h"
#include "runtime/prompt/session_points.h"
#include "runtime/prompt/session_text.h"
#include "runtime/prompt/typed_answers.h"
#include "runtime/prompt/workshop.h"

namespace rob::runtime {

struct SessionOptions {
  std::string robot;        ///< a name or a file; empty: the gantry
  std::string cell_file{};  ///< of what stands around it; empty: none
  std::optional<motion::Law> law;
  bool fast = false;
  double override_share = 1;
  std::uint64_t seed = lang::Random::kDefaultSeed;
  std::optional<WallTime>
      date{};  ///< when the session begins; without it now, or that of the virtual clock
  std::optional<std::uint64_t>
      cell;  ///< which simulated cell the robot stands in; none: its file's
  std::string trace;
  BackendName backend;
  bool home = false;                          ///< the machine homes itself first
  std::string points_file = "prompt.points";  ///< empty: points are kept for the session only
  std::string archive;                        ///< of saved programs; empty: the user's own
  /// Nobody types meanwhile: commands that need a robot at rest wait for it, and those that run a
  /// program wait for its end or a breakpoint. Otherwise such commands are refused.
  bool waits = false;
  bool keep_going = false;  ///< a pipe is carried out to its end, whatever goes wrong
  const StopRequests* requests = nullptr;  ///< as of LiveOptions
};

/// The bench of a prompt: a robot under control, and what has been typed. Statements act at once;
/// colon commands (commands.h) act on the workshop.
class Session {
 public:
  enum class Taken : std::uint8_t {
    Done,       ///< it is on its way, or refused, with a message
    Incomplete  ///< a block or a bracket is open: more lines belong to it
  };

  /// Throws as load_robot() and LiveRobot do.
  Session(SessionOptions options, Screen& screen);

  /// A statement or a block, a word of it at least. `last`: no more lines will come. Throws
  /// FileError.
  Taken take(const std::string& text, bool last);
  /// Whether nothing is wrong with the last lines of a block that is open; what is wrong is
  /// reported. `first`: of the lines, counted from 0.
  bool sound_so_far(const std::string& block, std::size_t first);
  /// Takes what there is to report; on the virtual clock a cycle passes.
  void let_pass();
  /// Until no entry is open, or `most` of them.
  void carry_out_entries(std::size_t most = 0);
  /// Lets pass what is needed until every entry has been carried out and the robot stands.
  void finish();
  /// Ctrl-C, while the robot moves or an entry is open; false where there is nothing to stop.
  bool interrupt();
  /// The same by a command.
  void stop();
  /// Ctrl-C once more, while the robot comes to rest; false where it does not.
  bool interrupt_again();
  /// A jog has been interrupted.
  void await_rest() { interrupted_ = !robot_->idle(); }

  /// A jog as long as `held` says No; it begins when the robot stands.
  void jog(const lang::MoveCommand& command, const motion::Watch& held);

  bool over() const { return over_; }
  /// `:jog` has asked for the pendant; once.
  bool take_pendant() { return std::exchange(pendant_, false); }
  /// HALT or ASK waits: the next line is the answer.
  bool asks() const { return answers_.wanted(); }
  void answer(const std::string& text) { answers_.give(text); }
  /// The worst of all errors: a fault before files, a program before a command.
  ExitCode worst() const { return worst_; }
  /// The errors reported so far.
  std::size_t errors() const { return errors_; }
  /// See LiveReports.
  std::string state_text() const { return robot_->reports().state_text(); }

  // For commands.
  LiveRobot& robot() { return *robot_; }
  const LiveRobot& robot() const { return *robot_; }
  const SessionText& text() const { return *text_; }
  Screen& screen() { return *screen_; }
  /// From here on it writes there; returns where it wrote before.
  Screen& write_to(Screen& screen) { return *std::exchange(screen_, &screen); }
  void quit() { over_ = true; }
  void ask_for_pendant() { pendant_ = true; }
  /// A line for whoever types to change and enter.
  void propose(const std::string& line);
  std::string take_proposed() { return std::exchange(proposed_, ""); }
  /// The share of the jogs of this session.
  DeadMan& dead_man() { return dead_man_; }
  /// "error: …" and the way out; counts as one of the session.
  void fail(const std::string& message, const std::string& help = "",
            ExitCode code = ExitCode::ProgramError);
  /// As it was asked for: a name or a file; empty: the gantry.
  const std::string& chosen_robot() const { return options_.robot; }
  /// Another robot, or the same one, where it stands, under another law: only at rest.
  void choose_robot(const std::string& robot, std::optional<motion::Law> law);
  void reset();
  /// Drives without force, so that a hand can move the axes; or under control again.
  void guide(bool on);
  /// The machine homes itself.
  void home();

  // For the commands that build programs and points.
  Workshop& workshop() { return workshop_; }
  /// Whether the robot stands and nothing is open; if not, that is reported as an error of
  /// `command`.
  bool stands(const char* command);
  /// Carries out the program in memory, from a line on.
  void run(LoadedProgram program);
  /// Drives back to where the last motion began.
  void go_back();
  /// Goes on from where it is held.
  void leave_hold();
  /// Statements of a command, as if they had been typed; not recorded. Their declarations stay.
  void declare(const std::string& entry);
  /// Statements of a command that leave nothing.
  void carry_out_aside(LoadedProgram compiled);
  /// Where points are kept; empty: nowhere.
  const std::string& points_file() const { return options_.points_file; }
  /// Whether that file is where the session writes its trace.
  bool traces_to(const std::string& file) const;
  /// From now on they are kept there, and those that are there can be used. Throws FileError, with
  /// all as it was, if the file cannot be used.
  void follow_points(const std::string& file);
  /// Points that have changed in the file are so at the prompt.
  void take_points();
  /// False if there is no such point where points are kept. Throws FileError.
  bool rename_point(const std::string& name, const std::string& new_name);
  /// TEACH, of a point that need not be declared.
  void teach(const std::string& point);

 private:
  bool submit(const std::string& entry, LoadedProgram compiled);
  void refuse_untaught(LoadedProgram& compiled) const;
  void forget_unusable_points(const motion::RobotModel& robot);
  void tell_held();
  void read_points();
  void begin_text(const motion::RobotModel& robot);
  void wait_while(const std::function<bool()>& waits);
  LiveReports::Listener listener();
  std::unique_ptr<LiveRobot> live(const motion::RobotModel& robot);
  void take_failures();
  void forget(const EntryTask::Failure& failure);
  void tell(const LoadedProgram& compiled, std::uint32_t line);
  void note(ExitCode error);

  SessionOptions options_;
  std::string prompt_points_;  ///< the name from which each robot's own points file has its name
  Screen* screen_;
  std::optional<SessionText> text_;
  DeadMan dead_man_;
  TypedAnswers answers_;
  std::unique_ptr<LiveRobot> robot_;  ///< asks for answers_ and dead_man_ as long as it lives
  RunTexts runs_;
  Workshop workshop_;
  SessionPoints points_;
  ExitCode worst_ = ExitCode::Done;
  std::size_t errors_ = 0;
  bool over_ = false;
  bool pendant_ = false;
  std::string proposed_;
  bool interrupted_ = false;  ///< and the robot has not come to rest yet
};

}  // namespace rob::runtime

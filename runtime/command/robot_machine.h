#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/commanded.h"
#include "runtime/command/load_book.h"
#include "runtime/command/program_log.h"
#include "runtime/command/program_watch.h"
#include "runtime/command/settling.h"
#include "runtime/command/tool_paths.h"
#include "runtime/command/when_pool.h"
#include "runtime/files/point_keeper.h"
#include "runtime/tick/channels.h"
#include "runtime/words/messages.h"

namespace rob::runtime {

class BackgroundTasks;

motion::MotionRequest::Pace pace_of(lang::MoveCommand::Pace pace);
/// The MotionRequest of a MOVE; the source line is its tag.
motion::MotionRequest request_of(int line, const lang::MoveCommand& command);

/// A motion to a pose becomes one to the axis values that bring the tool there; or why there are
/// none. `near`: where the axes come from.
std::optional<Words> settle_on_axes(const motion::RobotModel& robot, const lang::PoseValue& pose,
                                    const motion::JointVector& near, lang::MoveCommand& command,
                                    const lang::Setting& setting = {});

/// The program's side of a robot: completes and checks what is asked, puts it into the buffer,
/// and answers Later while the buffer is full or a decision point has not come. All calls come
/// from the program's thread.
class RobotMachine final : public lang::Machine {
 public:
  /// `progress`: what it is told of the motions in `buffer`; one of those of `channels`.
  RobotMachine(const motion::RobotModel& robot, motion::MotionPlanner& planner,
               motion::LookAheadBuffer& buffer, Channels& channels, MotionProgress& progress,
               ProgramLog& log);

  /// `handlers`: commands what handlers do, into a buffer of its own. It must outlive the run, and
  /// is told what this one is told of the run.
  void run_handlers_on(RobotMachine& handlers);

  /// While a program is foretold: the inputs that nobody drives, by signal number what they are
  /// called, empty for all others. They stay OFF or 0V, a WAIT that reads one is taken as met, and
  /// each place that reads one is a finding.
  /// HALT and ASK are taken as answered where no script answers them.
  void assume(std::vector<std::string> inputs);
  /// Before the run: the program has no handlers, for which what is commanded would be kept.
  void expect_no_handlers() { keeps_commanded_ = false; }

  /// Before the run: what outputs become when it goes wrong.
  void declare_safe(const std::vector<lang::SafeValue>& values);
  /// The program has failed for good: as end(), but when all that was commanded has acted the
  /// outputs take their SAFE values.
  lang::Reply fail(int line);
  /// Where TEACH keeps points; without it (null), as while a program is foretold or tested, they
  /// live for the run only. It must outlive the run.
  void keep_points(PointKeeper* keeper) {
    if (handlers_ != nullptr) handlers_->keep_points(keeper);
    keeper_ = keeper;
  }
  /// Whether the axes stand, all effects have acted, and no WHEN has interrupted that.
  bool settled() const;

  // At a prompt (machine_prompt.cpp)
  /// The robot stays under control behind the end of a program; and Channels::stop_requested is
  /// obeyed as a WHEN that raises. Before anything else is commanded.
  void stay();
  /// What comes next begins where WayBack has brought the axes.
  void take_place();
  /// Every WHEN; false while there is no room for that.
  bool disarm_all(int line);
  /// Further ones, behind those that have been declared.
  void declare_safe_behind(std::span<const lang::SafeValue> values);
  /// An entry has failed: outputs take them.
  lang::Reply take_safe_values();
  /// A jog for as long as `held` says No, in the tick; ended() tells when it has come to rest.
  lang::Reply jog_while(int line, const lang::MoveCommand& command, const motion::Watch& held);
  /// Number of the last motion that was planned.
  std::uint32_t last_number() const { return planner_.last_number(); }

  /// The program's TASKs; they must outlive the run.
  void run_beside(BackgroundTasks& tasks) {
    if (handlers_ != nullptr) handlers_->run_beside(tasks);
    tasks_ = &tasks;
  }
  // What TASKs share with the program.
  BackgroundTasks& tasks() { return *tasks_; }
  const motion::RobotModel& robot() const { return robot_; }
  Channels& channels() { return channels_; }
  ProgramLog& log() { return log_; }
  const lang::RobotSignature::Signal& signal(int number) const {
    return signals_.at(static_cast<std::size_t>(number));
  }
  /// As read(), of the present cycle.
  lang::Reply present(lang::Reading what, lang::Slot* value);
  /// What `ask` asks is answered as outside of all WITH and IN.
  template <typename Ask>
  lang::Reply asked_plainly(const Ask& ask) {
    const lang::Setting kept = std::exchange(setting_, lang::Setting{});
    const lang::Reply reply = ask();
    setting_ = kept;
    return reply;
  }
  /// While a program is foretold: a signal was read that nobody drives.
  void note_assumed_value(int line, int signal);

  /// Before the run: the speed that the program's OVERRIDE is a share of, 1 = as programmed.
  void set_override(double share);

  lang::Reply move(int line, const lang::MoveCommand& command) override;
  lang::Reply via(int line, const lang::MoveCommand& point) override;
  void work_in(int line, const lang::Setting& setting) override;
  lang::Reply begin_path(int line) override;
  lang::Reply end_path(int line) override;
  lang::Reply press(int line, const lang::PressCommand& command) override;
  lang::Reply end_press(int line) override;
  lang::Reply override_speed(int line, double share) override;
  lang::Reply carry(int line, const lang::LoadCommand& load) override;
  lang::Reply guard(int line, const lang::Watch& condition) override;
  lang::Reply ended(int line, bool& hit) override;
  lang::Reply when(int line, const lang::Watch& condition, int& id) override;
  lang::Reply when_raise(const lang::Place& place, std::string_view text) override;
  lang::Reply when_handle(int line, bool stops) override;
  lang::Reply leave_handler(int line) override;
  lang::Reply disarm(int line, int id) override;
  lang::Reply on_the_way(int line, const lang::PathPlace& place) override;
  lang::Reply live_pace(int line, const lang::Watch& pace, lang::MoveCommand::Pace means) override;
  lang::Reply zero_force(int line) override;
  lang::Reply stop(int line) override;
  lang::Reply brake(int line) override;
  lang::Reply teach(int line, const lang::TaughtPoint& point) override;
  lang::Reply halt(int line, std::string_view text) override;
  lang::Reply ask(int line, std::string_view text, std::optional<std::string>& answer) override;
  lang::Reply simulate_go(int line, bool go, double after) override;
  lang::Reply simulate_answer(int line, std::string_view text, double after) override;
  lang::Reply start(const lang::Place& place, std::uint32_t task) override;
  lang::Reply publish(int line, std::size_t first, std::span<const lang::Slot> values) override;
  lang::Reply publish(int line, std::size_t first, std::span<const std::string> texts) override;
  lang::Reply refresh(int line, std::size_t first, std::span<lang::Slot> values) override;
  lang::Reply refresh(int line, std::size_t first, std::span<std::string> texts) override;
  lang::Reply wait(int line, double seconds) override;
  lang::Reply stand(int line, double& now) override;
  /// A WAIT looks at its condition again and again, and all that was commanded has acted.
  bool waits_at_rest() const { return standing_ && has_acted(); }
  bool taken_as_met(int line) override;
  lang::Reply waited(int line) override;
  lang::Reply leave_block(int line) override;
  lang::Reply settle(int line) override;
  lang::Reply end(int line) override;
  lang::Reply print(int line, std::string_view text) override;
  lang::Reply write_signal(int line, int signal, bool value) override;
  lang::Reply write_analog(int line, int signal, double volts) override;
  lang::Reply pulse(int line, int signal, double seconds) override;
  lang::Reply expectation_failed(int line, std::string_view text) override;
  lang::Reply simulate(int line, int signal, double value, double after) override;
  lang::Reply simulate_force(int line, int component, double value, double after) override;
  lang::Reply read_signal(int line, int signal, bool& value) override;
  lang::Reply read_analog(int line, int signal, double& volts) override;
  lang::Reply read(int line, lang::Reading what, lang::Slot* value) override;
  lang::Reply forward(int line, std::span<const double> joints, lang::PoseValue& pose) override;
  lang::Reply inverse(int line, const lang::PoseValue& pose, std::span<const double> near,
                      std::span<double> joints) override;
  /// The error that a WHEN has raised, once the axes stand; what had been commanded is dropped.
  std::optional<lang::RuntimeError> take_interruption();
  /// A WHEN whose handler has to begin now.
  struct Handled {
    int id;      ///< as when() has said
    bool stops;  ///< the axes stand: it commands handlers(); else they go on
  };
  std::optional<Handled> take_handled();
  lang::Machine& handlers();
  /// A handler that did not stop the axes is over.
  void end_call();
  /// No handler may begin while an error of the program is settled, and behind its end.
  void bar_handlers(bool barred);

 private:
  /// A PATH in the making.
  struct Path {
    motion::MotionPlanner::Mark before;
    // As they were before it:
    bool exact;
    std::uint32_t brakable;
    lang::Vector3 moved_tip;
    std::deque<Commanded> motions{};  ///< that are not queued yet
    bool closed = false;              ///< it is being queued
  };

  bool place_can_be_read() const;
  lang::Reply settle_target(lang::MoveCommand& command);
  motion::JointVector near(const lang::MoveCommand& command) const;
  lang::Reply felt(lang::Reading what, lang::Slot* value);
  // Forces (machine_force.cpp)
  motion::Pose force_frame() const;
  void ask_press_to_end();
  lang::Reply leave_press(bool met);
  lang::Reply give_up_press();
  motion::Pose across_press(motion::Pose target, const lang::MoveCommand& command) const;
  bool moves_against_press(const Commanded& commanded);
  bool jogs_against_press(const motion::JogRates& rates);
  /// Whether the tool has been changed in a corner, so that its tip would jump there.
  bool tip_jumps() const;
  /// Then the target before is reached exactly; whether it had to be.
  bool stop_for_tool(int line);
  lang::PoseValue tool_at(const motion::JointVector& q) const;
  void queue(motion::SegmentDescriptor segment, bool stop, bool further = false);
  void queue(Commanded commanded);
  /// What comes next comes behind this one.
  void follow(const motion::SegmentDescriptor& segment);
  /// Into the buffer, in which there is room.
  void send(Commanded commanded);
  /// Tells motion what the arm carries from here on, where that is new.
  lang::Reply tell_load(int line);
  bool load_is_known();
  // PATH (machine_path.cpp)
  bool collecting() const { return path_ && !path_->closed; }
  bool path_has_room();
  bool lay_places();
  bool plan_path_anew();
  void drop_path();
  /// Plans a motion with what is done on its way; false, with a refusal, where it cannot be.
  bool plan(int line, Commanded& commanded);
  bool plan_straight(int line, Commanded& commanded);
  bool plan_along(int line, const motion::MotionRequest& request, Commanded& commanded);
  bool take(int line, const motion::PlanOutcome& outcome, Commanded& commanded);
  /// False, with a refusal, where an event lies beyond the motion.
  bool lay_events(Commanded& commanded);
  motion::Pose target_of(const lang::MoveCommand& command) const;
  ToolPathOrWords tool_path(const Commanded& commanded) const;
  // JOG (machine_jog.cpp)
  lang::Reply jog(int line, const lang::MoveCommand& asked);
  bool plan_jog(int line, const lang::MoveCommand& asked, motion::SegmentDescriptor& segment);
  /// Whether it is known where the last motion leads: a jog has to come to rest before.
  bool rested();
  bool take_jog_rest(motion::Rest& rest);
  /// The last jog has ended there.
  void come_to_rest(const motion::JointVector& q);
  /// The axes stand at q, where all that was commanded has ended early.
  void restart_from(const motion::JointVector& q);

  /// The last target exactly, whether or not the robot has been measured there.
  lang::Reply make_exact(int line);
  /// What makes the last target exact and waits until the robot is in position; none where it is.
  std::optional<motion::SegmentDescriptor> settled_stop(int line);
  /// The last target exactly, then a dwell, as one statement.
  lang::Reply dwell(int line, double seconds);
  lang::Reply queue(motion::Effect effect);
  lang::Reply push(motion::Effect effect);
  lang::Reply arm();
  /// An effect on an output, still to be told what it does.
  motion::Effect effect_on(int line, int signal) const;
  lang::Reply note(int line, Note note);
  lang::Reply queue_simulation(int line, motion::Effect effect);
  // TASKs (machine_tasks.cpp)
  template <typename Due>
  lang::Reply report(int line, Due due);
  template <typename Value>
  lang::Reply fetch(std::size_t first, std::span<Value> values);
  // HALT and ASK (machine_operator.cpp)
  lang::Reply consult(int line, Note::Kind kind, std::string_view text);
  lang::Reply answered(int line, std::string answer, bool typed = false);
  lang::Reply refuse_unattended(const char* what);
  bool attended() const;
  void note_answer_assumed(int line, const char* what);
  /// Notes that a signal was read which nobody drives.
  void note_assumed(int line, int signal);
  /// Whether the world may be read now.
  bool observable() const;
  /// Number of the last segment that is waited for: marks behind it are not.
  std::uint32_t awaited() const;
  /// Whether the axes stand behind all that was commanded.
  bool stands() const;
  /// Whether they do, and all effects have acted.
  bool has_acted() const;
  /// A WHEN has ended all that was commanded, and the program has still to learn of it.
  bool interrupted() const;
  void forget_rests();
  /// How what was guarded or braked has ended, once it has.
  bool take_rest(motion::Rest& rest);
  /// Whether the decision point of the last motion has come.
  bool decided() const;
  void warn(int line, const Commanded& commanded, const motion::PlannedSegment& planned);

  const motion::RobotModel& robot_;
  const lang::RobotSignature signature_;
  const std::vector<lang::RobotSignature::Signal>& signals_;  ///< by the number that calls name
  motion::MotionPlanner& planner_;
  motion::LookAheadBuffer& buffer_;
  Channels& channels_;
  MotionProgress& progress_;
  ProgramLog& log_;
  lang::Setting setting_;    ///< of the program's present place
  lang::Vector3 moved_tip_;  ///< of the tool that the last motion was for
  LoadBook loads_;
  int line_before_ = 0;  ///< of the last motion that was planned
  double operators_override_ = 1;
  PointKeeper* keeper_ = nullptr;
  BackgroundTasks* tasks_ = nullptr;
  std::int64_t effects_ = 0;  ///< queued so far
  std::int64_t simulations_ = 0;
  std::vector<std::string> assumed_;
  bool foretelling_ = false;
  bool consulting_ = false;  ///< the operator has been shown the text of the present HALT or ASK
  int assumed_read_ = -1;    ///< by the condition of the present WAIT
  motion::JointVector hit_;  ///< where the last guarded motion was hit, or ended
  bool exact_ = true;        ///< the last motion queued ends at standstill
  Settling settling_;
  bool jogging_ = false;        ///< the last motion queued is a jog, and has not told its Rest
  std::uint32_t brakable_ = 0;  ///< number of the last motion; 0 where a barrier stands behind it
  bool braking_ = false;        ///< the generator has been asked to brake
  bool begun_ = false;          ///< the present WAIT has queued its first segment
  ProgramWatch until_;          ///< what the guarded motion is asked
  WhenPool whens_;
  motion::WatchedAction* recording_ = nullptr;  ///< the WHEN whose action comes next
  // What the next motion does on its way, and the place whose action comes next.
  std::vector<OnTheWay> on_the_way_;
  std::vector<lang::MoveCommand> via_;  ///< points that the next motion goes through
  std::optional<ProgramPace> live_;     ///< its pace
  std::deque<ProgramWatch> paces_;      ///< a ring
  std::size_t next_pace_ = 0;
  std::optional<lang::PathPlace> place_;
  std::optional<Path> path_;
  std::uint32_t sent_ = 0;     ///< number of the last segment in the buffer
  std::uint32_t awaited_ = 0;  ///< see awaited()

  // Handlers (machine_handlers.cpp)
  void remember(Commanded commanded);
  void begin_handler(const motion::Rest& rest, RobotMachine& program);
  lang::Reply move_back(int line);
  lang::Reply leave_path();
  lang::Reply drop_interrupted(int line);
  bool plan_anew(Commanded& commanded);
  void decline();
  /// Of a program: what the present handler lets the axes do.
  enum class Handler : std::uint8_t { None, HasAxes, LetsThemGoOn };
  /// Of the machine that handlers command: the one that has the axes.
  struct Errand {
    RobotMachine* program;     ///< that it has interrupted
    motion::JointVector home;  ///< where it has found the axes
    bool returns = true;
    enum class Leaving : std::uint8_t { No, Stopping, Moving, Asked };
    Leaving leaving = Leaving::No;
  };
  RobotMachine* handlers_ = nullptr;  ///< of a program
  Handler handler_ = Handler::None;
  std::optional<Errand> errand_;     ///< the last one
  std::deque<Commanded> commanded_;  ///< the last ones, at least all that are in the buffer
  bool keeps_commanded_ = true;
  std::optional<motion::Rest> left_;  ///< how the guarded motion has ended, by a handler

  bool watched();
  int armed_ = 0;                    ///< WHENs that are not disarmed yet
  std::int64_t last_arming_ = 0;     ///< the effect that armed the last one, counted as effects_
  std::int64_t watched_since_ = -1;  ///< the cycle in which it was first seen armed; -1: not yet
  bool guarded_ = false;             ///< what is queued now ends early if until_ holds
  std::size_t safe_queued_ = 0;      ///< SAFE values that have been queued
  bool standing_ = false;            ///< the present WAIT for a condition has queued all it needs

  /// Between PRESS and ENDPRESS, and while that waits.
  enum class Pressing : std::uint8_t { No, Seeking, Yes, Ending, EndingLost, EndingAtEnd };
  Pressing pressing_ = Pressing::No;

  // At a prompt
  lang::RuntimeError stopped();
  bool stays_ = false;
  motion::WatchedAction stopping_;  ///< Channels::stop_requested
  motion::Watch held_;              ///< of the jog that is queued now, instead of until_
};

}  // namespace rob::runtime

#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "motion/robots/robot_model.h"
#include "runtime/command/entry_task.h"
#include "runtime/files/data_files.h"
#include "runtime/files/points_file.h"
#include "runtime/prompt/live_reports.h"
#include "runtime/run/control_threads.h"
#include "runtime/run/controller.h"
#include "runtime/run/machine.h"
#include "runtime/run/program_stores.h"
#include "runtime/run/stepper.h"
#include "runtime/run/trace_writer.h"

namespace rob::runtime {

/// How a robot is kept under control while a prompt lasts.
struct LiveOptions {
  bool fast = false;  ///< on the virtual clock, where time passes in let_pass() only
  double override_share = 1;
  std::uint64_t seed = lang::Random::kDefaultSeed;
  std::optional<WallTime> date{};  ///< as in SessionOptions
  std::string points_file;         ///< where TEACH keeps points; empty: nowhere
  std::string trace;               ///< empty: none
  BackendName backend;             ///< what moves
  bool home = false;               ///< it homes itself first
  /// The wish of signals of the system. Null: nothing.
  const StopRequests* requests = nullptr;
};

/// A robot, simulated or a machine, under control from one entry to the next. In real time its
/// threads go on by themselves. All calls come from the thread that reads.
class LiveRobot {
 public:
  /// Throws motion::DriverError, FileError (of the trace).
  LiveRobot(motion::RobotModel robot, LiveOptions options, LiveReports::Listener listener,
            Person* person);
  ~LiveRobot();
  LiveRobot(const LiveRobot&) = delete;
  LiveRobot& operator=(const LiveRobot&) = delete;

  const motion::RobotModel& robot() const { return robot_; }
  void submit(EntryTask::Entry entry) { entries_->submit(std::move(entry)); }
  std::optional<EntryTask::Failure> take_failure() { return entries_->take_failure(); }
  /// A whole program, whose code is taken out of it, with its own files, devices and PERSIST
  /// variables. The robot is idle. Throws FileError, motion::DriverError.
  void run(std::uint32_t line, LoadedProgram& program);
  /// Entries that are not done yet.
  std::size_t open() const { return entries_->open(); }
  /// Nothing is open, and the robot stands.
  bool idle() const { return entries_->settled() && !going_back(); }
  /// Motion is over for good: a fault, or hold_for_good().
  bool over() const { return controller_->motion().over(); }

  /// On the virtual clock: the program works until it has to wait.
  void work();
  /// Takes what there is to report; on the virtual clock a cycle passes before.
  void let_pass();

  void pause(bool on);
  bool paused() const { return channels().pause.on(); }
  /// It stands on its path, and will until pause(false).
  bool held() const;
  /// Where TEACH keeps points; null: nowhere.
  PointsFile* points() { return points_ ? &*points_ : nullptr; }
  /// From where it stands, held or idle: by one motion. A message comes when it stands there.
  void go_back();
  bool going_back() const { return channels().way_back.under_way.load(std::memory_order_acquire); }
  /// Brakes on the path and drops all that was commanded.
  void stop();
  /// As fast as the axes can, for good; then the drives are without force.
  void brake() { controller_->request_brake(); }
  void set_override(double share);
  double override_share() const { return options_.override_share; }
  /// After a fault: under control anew, where the axes stand.
  void reset();
  /// Without force, so that a hand can move the axes, from here on; or under control again, as by
  /// reset().
  void guide(bool on);
  bool guided() const { return guided_; }
  bool simulated() const { return options_.backend.simulated(); }
  bool sees_hand() const { return options_.backend.sees_hand(); }
  /// As reset(); the machine homes itself before. Only a machine can.
  void home();

  const LiveReports& reports() const { return *reports_; }
  Channels& channels() { return controller_->channels(); }
  const Channels& channels() const { return controller_->channels(); }

 private:
  void begin(OpenMachine machine);
  OpenMachine open_again();
  void end();
  void run_entries();
  void look_for_end();
  void close_stores();
  void use_stores(DataFiles* files, TextDevices* devices);

  motion::RobotModel asked_;  ///< as its file has it
  motion::RobotModel robot_;  ///< as the machine is
  LiveOptions options_;
  LiveReports::Listener listener_;
  Person* person_;
  std::optional<PointsFile> points_;
  DataFiles files_;
  std::unique_ptr<ProgramStores> stores_;  ///< of the program that runs
  std::optional<TraceWriter> trace_;
  std::unique_ptr<Controller> controller_;
  std::unique_ptr<EntryTask> entries_;
  std::unique_ptr<LiveReports> reports_;
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<ControlThreads> threads_;
  std::atomic<bool> ending_{false};
  std::atomic<bool> begun_{false};  ///< the robot is under control: entries may run
  bool guided_ = false;
  std::mutex slice_;  ///< held while entries work, by their thread
  std::thread program_;
};

}  // namespace rob::runtime

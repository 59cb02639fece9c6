#include "runtime/prompt/live_robot.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "runtime/run/machine.h"

namespace rob::runtime {

namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kSlice = 10'000;  // instructions between looks at the stop flag
constexpr auto kProgramPause = 1ms;      // [choice] a tenth of a reference period
/// Of the way that `:back` goes: 11 minutes at 10 ms, 5 MB. [choice]
constexpr std::size_t kRecorded = 65'536;

}  // namespace

LiveRobot::LiveRobot(motion::RobotModel robot, LiveOptions options, LiveReports::Listener listener,
                     Person* person)
    : asked_(std::move(robot)),
      robot_(asked_),
      options_(std::move(options)),
      listener_(std::move(listener)),
      person_(person),
      files_("", DataFiles::Keeps::OnDisk, options_.fast) {
  if (!options_.points_file.empty()) points_.emplace(options_.points_file, robot_);
  if (!options_.trace.empty()) trace_.emplace(options_.trace, robot_, std::vector<std::string>{});
  begin(open_machine(options_.backend, robot_, std::exchange(options_.home, false), true));
}

LiveRobot::~LiveRobot() {
  end();
  if (trace_ && !trace_->close() && listener_.tell)
    listener_.tell(fmt::format("the trace '{}' is incomplete: {} rows are lost; is the disk full?",
                               options_.trace, trace_->lost()));
}

void LiveRobot::begin(OpenMachine machine) {
  for (const std::string& note : machine.notes)
    if (listener_.tell) listener_.tell(note);
  robot_.servo_period = machine.period;
  controller_ =
      std::make_unique<Controller>(robot_, std::move(machine.backend), options_.override_share,
                                   std::vector<SimulationRule>{}, kRecorded);
  controller_->channels().begun =
      options_.date.value_or(options_.fast ? WallTime{} : wall_time_now());
  controller_->channels().panel.seat(person_);
  controller_->keep_points(points_ ? &*points_ : nullptr);
  controller_->keep_files(&files_);
  entries_ = std::make_unique<EntryTask>(controller_->machine(), options_.seed);
  LiveReports::Listener listener = listener_;
  listener.snapshot = [this](const Snapshot& snapshot) {
    if (trace_) trace_->write(snapshot);
    if (listener_.snapshot) listener_.snapshot(snapshot);
  };
  listener.keep = [this](const Note& note, double time) {
    if (stores_) return stores_->take(note, time);
    if (note.kind == Note::Kind::Write) files_.append(note.file, note.text);
  };
  listener.drained = [this] {
    files_.drained();
    if (stores_) stores_->drained();
  };
  reports_ = std::make_unique<LiveReports>(*controller_, std::move(listener));
  ending_ = false;
  if (options_.fast) {
    stepper_ = std::make_unique<Stepper>(*controller_);
    return;
  }
  threads_ = std::make_unique<ControlThreads>(*controller_);
  begun_ = false;
  program_ = std::thread([this] {
    begun_.wait(false);
    run_entries();
  });
  if (guided_) {
    controller_->servo().guide(-kThreadLead);
  } else {
    controller_->servo().enable(-kThreadLead);
  }
  controller_->motion().prepare(0);
  threads_->begin();
  begun_ = true;
  begun_.notify_all();
}

/// The robot comes to rest on its path first.
void LiveRobot::end() {
  controller_->request_hold();
  ending_ = true;
  if (program_.joinable()) program_.join();
  threads_.reset();
  while (stepper_ && !controller_->motion().over()) {
    stepper_->cycle();
    controller_->plan_path();
  }
  stepper_.reset();
  reports_->drain();
  close_stores();
}

void LiveRobot::run_entries() {
  ProgramTask::State state = ProgramTask::State::Over;
  while (!ending_.load(std::memory_order_relaxed)) {
    look_for_end();
    {
      const std::lock_guard slice(slice_);
      state = entries_->run_tasks(entries_->step(kSlice));
    }
    if (state != ProgramTask::State::Busy) std::this_thread::sleep_for(kProgramPause);
  }
}

void LiveRobot::work() {
  if (!stepper_) return;
  ProgramTask::State state = ProgramTask::State::Busy;
  for (std::int64_t left = kInstructionsPerCycle; state == ProgramTask::State::Busy && left > 0;
       left -= kSlice) {
    state = entries_->run_tasks(entries_->step(kSlice));
  }
  controller_->plan_path();
}

void LiveRobot::let_pass() {
  if (stepper_) {
    look_for_end();
    stepper_->cycle();
    work();
  }
  const bool ended = stores_ && (idle() || over());  // before draining: its last note is then taken
  reports_->drain();
  if (stores_ && listener_.tell)
    for (const std::string& event : stores_->take_events()) listener_.tell(event);
  if (ended) close_stores();
}

void LiveRobot::run(std::uint32_t line, LoadedProgram& program) {
  close_stores();
  stores_ = std::make_unique<ProgramStores>(program, "", !options_.fast);
  use_stores(&stores_->files(), &stores_->devices());
  auto chunk = std::make_shared<const lang::Chunk>(std::move(*program.compilation.chunk));
  submit({line, EntryTask::Program{std::move(chunk), options_.seed, stores_->saved(),
                                   program.obstacles}});
}

/// Between two slices of the entries, whose TASKs may WRITE at any time.
void LiveRobot::use_stores(DataFiles* files, TextDevices* devices) {
  const std::lock_guard slice(slice_);
  controller_->keep_files(files);
  controller_->connect(devices);
}

/// Nothing of the program is under way any more.
void LiveRobot::close_stores() {
  if (!stores_) return;
  use_stores(&files_, nullptr);
  const auto stores = std::move(stores_);
  if (listener_.tell)
    for (const std::string& event : stores->take_events(TextDevices::Telling::All))
      listener_.tell(event);
  for (const std::string& why : stores->finish())
    if (listener_.not_kept) listener_.not_kept(why);
}

void LiveRobot::look_for_end() {
  if (options_.requests == nullptr) return;
  if (options_.requests->hold.load(std::memory_order_relaxed)) controller_->request_hold();
  if (options_.requests->brake.load(std::memory_order_relaxed)) controller_->request_brake();
}

void LiveRobot::pause(bool on) {
  WayBack& way_back = channels().way_back;
  if (on && going_back()) way_back.hold_asked.store(true);
  if (!on && paused() && way_back.away.load(std::memory_order_relaxed))
    way_back.under_way.store(true, std::memory_order_release);
  channels().pause.ask(on);
}

void LiveRobot::go_back() {
  channels().way_back.under_way.store(true, std::memory_order_release);
  channels().way_back.hold_asked.store(false);  // one of before may have come too late
  channels().way_back.asked.store(true);
}

void LiveRobot::stop() {
  channels().stop_requested.store(true, std::memory_order_relaxed);
  pause(false);
}

bool LiveRobot::held() const {
  using motion::MotionState;
  const auto& last = reports_->last();
  if (!paused() || !last) return false;
  return last->sample.state == MotionState::Held || last->sample.state == MotionState::Idle;
}

void LiveRobot::set_override(double share) {
  options_.override_share = share;
  channels().override_asked.store(share, std::memory_order_relaxed);
}

void LiveRobot::reset() {
  end();
  robot_.start = controller_->channels().joints.load();
  reports_.reset();
  entries_.reset();
  controller_.reset();
  begin(open_again());
}

/// A machine that cannot be opened is reported as a fault, and can be tried again.
OpenMachine LiveRobot::open_again() try {
  const motion::JointVector start = robot_.start;
  robot_ = asked_;  // without what the machine has made of it
  robot_.start = start;
  return open_machine(options_.backend, robot_, std::exchange(options_.home, false), true);
} catch (const motion::DriverError& error) {
  return absent_machine(robot_, error.what());
}

void LiveRobot::guide(bool on) {
  guided_ = on;
  reset();
}

void LiveRobot::home() {
  options_.home = true;
  reset();
}

}  // namespace rob::runtime

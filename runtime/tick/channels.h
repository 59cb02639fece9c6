#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "motion/collision/clearance.h"
#include "motion/collision/jog_room.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/servo/following_supervisor.h"
#include "motion/space/analog_channels.h"
#include "motion/space/joint_vector.h"
#include "motion/space/spsc_ring.h"
#include "motion/space/wrench.h"
#include "runtime/tick/analog_cells.h"
#include "runtime/tick/hold_points.h"
#include "runtime/tick/latest_values.h"
#include "runtime/tick/operator_panel.h"
#include "runtime/tick/path_pause.h"
#include "runtime/tick/press_desk.h"
#include "runtime/tick/safe_values.h"
#include "runtime/tick/scripted_operator.h"
#include "runtime/tick/stop_requests.h"
#include "runtime/tick/way_back.h"
#include "runtime/time/wall_time.h"

namespace rob::runtime {

/// The servo's report of one of its cycles.
struct ServoSample {
  double time = 0;  ///< of the cycle; that of what was measured may lie before it
  motion::JointMeasurement measured;
  motion::JointVector drive;  ///< N, Nm, or pulses
  std::uint64_t inputs = 0;
  motion::AnalogValues analog_inputs{};
  double saturation = 0;  ///< greatest demanded force / what the drive can give
  /// By the force sensor, as ServoState tells it.
  struct Felt {
    double time = 0;  ///< s; 0: never
    motion::Wrench wrench;
  };
  Felt felt;
  motion::FollowingFinding finding;
  /// Where the machine was sent; after a gap in which it was on its own, if the servo `braked` it,
  /// the axes go on from here.
  motion::JointReference reference;
  bool braked = false;
  /// The axes are on their way to the references, from which a late computer has kept them.
  bool joining = false;
  /// A machine that follows references later has come to rest; one that does not answer is not
  /// waited for.
  bool settled = true;
};

/// All that is known of one reference period, for the trace and the report: the reference and what
/// was measured at the same instant.
struct Snapshot {
  motion::GeneratorSample sample;
  motion::JointVector measured;
  motion::JointVector drive;
  double saturation = 0;  ///< greatest force demanded since the last one / what the drive can give
  double lateness = 0;    ///< s, of the cycle that handed the reference out
  double override_share = 1;
  motion::Wrench wrench;  ///< N, Nm along the axes of the world, as the program reads it
  Eigen::Vector3d pressed = Eigen::Vector3d::Zero();  ///< see Press::way()
};

/// A finding of the servo's supervision that the user has to know.
struct ServoNotice {
  double time = 0;
  motion::FollowingFinding finding;
};

/// The news of the queued motions for the side that commands: the program, and beside
/// it the handlers of its WHENs, whose motions go through a buffer and a generator of their own.
/// motion → program.
struct MotionProgress {
  /// How what was guarded or braked has ended, one for each that is waited for.
  motion::SpscRing<motion::Rest> rests{16};
  /// The axes stand at the end of this segment, and its effects have acted.
  std::atomic<std::uint32_t> settled{0};
  std::atomic<std::uint32_t> decidable{0};    ///< see TrajectoryGenerator
  std::atomic<bool> standing{true};           ///< nothing is under way
  std::atomic<std::int64_t> effects_done{0};  ///< effects that have acted
};

/// Motions of handlers are known by their own numbers and this. [choice] no program gets that far.
inline constexpr std::uint32_t kHandlerNumbers = 1'000'000'000;

/// The fate of the motion that a handler has interrupted.
enum class AfterHandler : std::uint8_t {
  None,     ///< nothing has been asked for
  GoOn,     ///< the axes are back on its path
  Decline,  ///< the handler has not begun
  Leave,    ///< it is over; what was queued after it is queued anew
  LeaveAll  ///< it is over, with all that was queued
};

/// Everything through which the tasks of one run talk: rings and atomics with one writer each, so
/// that no tick ever waits for another. Memory is taken by the constructor alone.
struct Channels {
  WallTime begun;  ///< when the run began; set before it, then constant
  // [choice] At 1 kHz half a second of references and servo samples, more than twice what a thread
  // may be late before the run ends; 2 s of rows and 4 s of events.
  static constexpr std::size_t kReferences = 512;
  static constexpr std::size_t kSamples = 512;
  static constexpr std::size_t kSnapshots = 2048;
  static constexpr std::size_t kEvents = 4096;

  motion::SpscRing<motion::JointReference> references{kReferences};  ///< motion → servo
  motion::SpscRing<ServoSample> samples{kSamples};                   ///< servo → motion
  motion::SpscRing<Snapshot> snapshots{kSnapshots};                  ///< motion → main
  motion::SpscRing<motion::MotionEvent> events{kEvents};             ///< motion → main

  MotionProgress program;
  MotionProgress handler;
  std::atomic<AfterHandler> after_handler{AfterHandler::None};  ///< program → motion
  std::atomic<bool> handlers_barred{false};                     ///< program → motion

  /// A Report whose turn has come.
  struct Report {
    std::uint32_t id = 0;
    bool dropped = false;
  };
  /// [choice] as many as effects can be on their way, and what acts in the cycles that a thread
  /// may be late
  static constexpr std::size_t kReports = 2048;
  motion::SpscRing<Report> reports{kReports};       ///< motion → program
  motion::SpscRing<motion::Effect> immediate{256};  ///< program → motion: what TASKs do in a cycle

  motion::SpscRing<ServoNotice> notices{16};  ///< motion → main
  /// [choice] as many as a script has rules, twice: those of a cycle, before the report takes them
  motion::SpscRing<Intervention> interventions{2048};  ///< motion → main

  /// [choice] as many as a script has rules; motion → main: lines of devices that have come, by
  /// their numbers in the script
  motion::SpscRing<std::uint32_t> device_lines{1024};

  std::atomic<std::uint64_t> outputs{0};  ///< motion → servo: bit i is output channel i
  std::atomic<std::uint64_t> inputs{0};   ///< motion → program: latched in this cycle; before
                                          ///< the first one by ServoTask::enable()
  AnalogCells analog_outputs;             ///< V, as outputs
  AnalogCells analog_inputs;              ///< V, as inputs
  /// motion → servo, program: what the arm carries in this cycle; null: nothing
  std::atomic<const motion::CarriedLoad*> carried{nullptr};
  std::atomic<std::int64_t> cycle{0};  ///< motion → program: number of the current one
  motion::JogRoom jog_room;            ///< thread that measures distances → motion
  /// program → thread that measures distances: what jogs must not hit; null: all of the robot's
  std::atomic<std::shared_ptr<const motion::Clearance>> jog_bodies{};
  LatestValues joints;  ///< motion → program: the references of the current cycle
  LatestValues wrench;  ///< motion → program: N, then Nm, as CycleView; none without a sensor
  std::atomic<std::int64_t> simulations_done{0};  ///< motion → program: SIMULATEs that have acted
  OperatorPanel panel;  ///< motion → program: what a signal script does in the operator's place
  SafeValues safe;
  StopRequests stop;                    ///< any thread → motion
  std::atomic<bool> drives_off{false};  ///< motion → servo: for good
  PathPause pause;                      ///< of the path, until it is withdrawn
  // At a prompt, main → motion:
  HoldPoints hold_points;  ///< where motion asks for a pause by itself
  WayBack way_back;
  PressDesk press;
  std::atomic<bool> stop_requested{false};  ///< brake, and drop all that was commanded
  std::atomic<double> override_asked{0};    ///< once each; 0: none
  /// The machine's words about a finding: its trouble, or what explains that an axis is not where
  /// it should be. Not for the ticks.
  std::function<std::string(const motion::FollowingFinding&)> of_machine =
      [](const motion::FollowingFinding&) { return std::string(); };
  std::atomic<std::int64_t> lost{0};  ///< snapshots and events that found their ring full

  /// The motion task reports an event.
  void tell(const motion::MotionEvent& event) noexcept {
    if (!events.push(event)) lost.fetch_add(1, std::memory_order_relaxed);
  }
};

}  // namespace rob::runtime

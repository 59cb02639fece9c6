#include "motion/motion.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "motion/generate/motion_chain.h"
#include "motion/plan/capability.h"
#include "motion/space/spsc_queue.h"

namespace rob::motion {

namespace {

/// [choice] The motion that runs, and those before it in its corners.
constexpr std::size_t kRunning = 8;

/// The robot under that law, with its axes there.
RobotModel placed(const RobotModel& robot, Law law, const JointVector& start) {
  RobotModel placed = robot;
  placed.law = law;
  placed.start = start;
  if (!robot.kinematics)
    throw std::invalid_argument("how the axes of the robot '" + robot.name +
                                "' move its tool is not known; load_robot() finds it");
  if (!can(placed, law))
    throw std::invalid_argument("the robot '" + robot.name +
                                "' has no t_acc, which Paul's law needs; use Law::LookAhead, or" +
                                " write t_acc into its robot file");
  if (start.size() != robot.axis_count())
    throw std::invalid_argument("the robot '" + robot.name + "' has " +
                                std::to_string(robot.axis_count()) + " axes, but start has " +
                                std::to_string(start.size()) + " values; give one for each axis");
  std::array<double, kMaxJoints> values{};
  std::copy(start.begin(), start.end(), values.begin());
  if (const auto refusal = check_target(robot, 0xFF, values))
    throw std::invalid_argument("the axis '" +
                                robot.axes[static_cast<std::size_t>(refusal->axis)].name +
                                "' cannot start at " + std::to_string(refusal->value) +
                                ", in m or rad; give a place between its min and its max");
  return placed;
}

double most_share(Law law) noexcept { return law == Law::Paul ? 1 : 2; }

}  // namespace

struct Trajectory::Parts {
  /// A motion that the planner has judged, and what its segment points into.
  struct Waiting {
    SegmentDescriptor segment;
    std::shared_ptr<const PlannedLeg> leg;
  };

  Parts(const RobotModel& from, Law law, const JointVector& start)
      : robot(placed(from, law, start)), chain(robot) {}

  void send();
  void take_requests() noexcept;
  void take_events() noexcept;

  const RobotModel robot;
  MotionChain chain;

  // From the thread that adds to the thread that plans
  Tag last_tag = 0;  ///< the adder's
  SpscQueue<Waiting> waiting;
  std::atomic<bool> closed{false};
  /// The planner's: the segments that are under way point into these.
  std::deque<std::shared_ptr<const PlannedLeg>> sent;

  // From any thread
  std::atomic<bool> stand{false};
  std::atomic<double> share{1};

  // The updater's
  std::int64_t next_period = 0;
  bool standing = false;  ///< `stand`, as the generator knows it
  double share_taken = 1;
  bool finished = false;
  bool failed = false;
};

/// As many as there is room for. The planner keeps what the newest motions point into, which may
/// wait here for long.
void Trajectory::Parts::send() {
  const bool nothing_else = closed.load(std::memory_order_acquire);  // before looking
  const Waiting* next = waiting.front();
  for (; next != nullptr && !chain.buffer.full(); next = waiting.front()) {
    sent.push_back(next->leg);
    if (sent.size() > static_cast<std::size_t>(most_ahead(robot)) + kRunning) sent.pop_front();
    chain.buffer.push(next->segment);
    waiting.pop();
  }
  if (nothing_else && next == nullptr) chain.buffer.close();
}

void Trajectory::Parts::take_requests() noexcept {
  const double asked = share.load(std::memory_order_relaxed);
  if (asked != std::exchange(share_taken, asked)) chain.generator->set_override(asked);
  const bool stands = failed || stand.load(std::memory_order_relaxed);
  if (stands == std::exchange(standing, stands)) return;
  stands ? chain.generator->hold() : chain.generator->resume();
}

/// The other troubles need a watch, a measurement or a late tick, which are not here.
void Trajectory::Parts::take_events() noexcept {
  MotionEvent event;
  while (chain.generator->take_event(event)) {
    finished = finished || event.kind == MotionEvent::Kind::Finished;
    failed = failed || event.kind == MotionEvent::Kind::Fault;
  }
}

Trajectory::Trajectory(const RobotModel& robot, Law law) : Trajectory(robot, law, robot.start) {}

Trajectory::Trajectory(const RobotModel& robot, Law law, const JointVector& start)
    : parts_(std::make_unique<Parts>(robot, law, start)) {}

Trajectory::~Trajectory() = default;
Trajectory::Trajectory(Trajectory&&) noexcept = default;
Trajectory& Trajectory::operator=(Trajectory&&) noexcept = default;

std::optional<Refusal> Trajectory::add(const MotionRequest& request) {
  if (parts_->closed.load(std::memory_order_relaxed))
    throw std::logic_error("Trajectory::add() after close(); make another Trajectory");
  PlanOutcome outcome = parts_->chain.planner.plan(request);
  if (auto* const refusal = std::get_if<Refusal>(&outcome)) return *refusal;
  auto& planned = std::get<PlannedSegment>(outcome);
  parts_->last_tag = request.tag;
  parts_->waiting.push({planned.segment, std::move(planned.leg)});
  return std::nullopt;
}

void Trajectory::stop() {
  if (const auto stop = parts_->chain.planner.stop(parts_->last_tag))
    parts_->waiting.push({*stop, nullptr});
}

void Trajectory::close() {
  stop();
  parts_->closed.store(true, std::memory_order_release);
}

/// Planning makes room for more.
void Trajectory::plan() {
  do {
    parts_->send();
  } while (parts_->chain.plan_path() && parts_->waiting.front() != nullptr &&
           !parts_->chain.buffer.full());
}

Result Trajectory::update(JointReference& reference) noexcept {
  parts_->take_requests();
  const GeneratorSample& sample = parts_->chain.generator->advance(parts_->next_period++);
  parts_->take_events();
  reference = sample.reference;
  if (parts_->failed && sample.state == MotionState::Held) return Result::Failed;
  return parts_->finished ? Result::Finished : Result::Working;
}

void Trajectory::hold(bool stand) noexcept {
  parts_->stand.store(stand, std::memory_order_relaxed);
}

void Trajectory::override_speed(double share) noexcept {
  if (share > 0)
    parts_->share.store(std::min(share, most_share(parts_->robot.law)), std::memory_order_relaxed);
}

}  // namespace rob::motion

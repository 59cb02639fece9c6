#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "runtime/command/robot_machine.h"
#include "runtime/words/messages.h"

/// Member functions of RobotMachine for the handlers of WHEN: how a handler gets the axes, and what
/// becomes of the motion that it has interrupted. A handler commands a RobotMachine of its own.
namespace rob::runtime {

using lang::Reply;
using motion::Rest;

void RobotMachine::run_handlers_on(RobotMachine& handlers) { handlers_ = &handlers; }

Reply RobotMachine::when_handle(int /*line*/, bool stops) {
  using Kind = motion::WatchedAction::Kind;
  recording_->kind = stops ? Kind::Handle : Kind::Call;
  return arm();
}

std::optional<RobotMachine::Handled> RobotMachine::take_handled() {
  const Rest* const rest = progress_.rests.front();
  if (rest == nullptr || rest->outcome != Rest::Outcome::Handled) return std::nullopt;
  const int id = whens_.id_of(*rest->by);
  if (rest->by->retired.load(std::memory_order_relaxed)) {
    decline();
    return std::nullopt;
  }
  const bool stops = rest->by->kind == motion::WatchedAction::Kind::Handle;
  handler_ = stops ? Handler::HasAxes : Handler::LetsThemGoOn;
  if (stops) handlers_->begin_handler(*rest, *this);
  rest->by->fired.store(false, std::memory_order_relaxed);
  progress_.rests.pop();
  return Handled{id, stops};
}

lang::Machine& RobotMachine::handlers() { return *handlers_; }

void RobotMachine::end_call() {
  if (handler_ != Handler::LetsThemGoOn) return;
  handler_ = Handler::None;
  channels_.after_handler.store(AfterHandler::GoOn);
}

/// One that has been told and not taken comes back when handlers may begin again.
void RobotMachine::bar_handlers(bool barred) {
  channels_.handlers_barred.store(barred);
  if (barred) end_call();
  const Rest* const rest = progress_.rests.front();
  if (!barred || rest == nullptr || rest->outcome != Rest::Outcome::Handled) return;
  decline();
}

void RobotMachine::decline() {
  progress_.rests.pop();
  channels_.after_handler.store(AfterHandler::Decline);
}

void RobotMachine::begin_handler(const Rest& rest, RobotMachine& program) {
  errand_ = Errand{.program = &program, .home = rest.q};
  restart_from(rest.q);
  brakable_ = 0;
}

/// Back to where the path was left, from rest to rest; nothing where the axes have not moved.
Reply RobotMachine::move_back(int line) {
  if (buffer_.room() < 2) return Reply::Later;
  if ((planner_.commanded() - errand_->home).cwiseAbs().maxCoeff() <= motion::kLimitTolerance) {
    return Reply::Done;
  }
  motion::MotionRequest request;
  request.tag = static_cast<motion::Tag>(line);
  request.given = lang::given_all(robot_.axis_count());
  for (int i = 0; i < robot_.axis_count(); ++i) {
    request.target[static_cast<std::size_t>(i)] = errand_->home[i];
  }
  const motion::PlanOutcome outcome = planner_.plan(request);
  if (const auto* const refusal = std::get_if<motion::Refusal>(&outcome)) {
    refuse(words_for(*refusal, robot_));
    return Reply::Refused;
  }
  queue(std::get<motion::PlannedSegment>(outcome).segment, false);
  return make_exact(line);
}

Reply RobotMachine::leave_handler(int line) {
  using Leaving = Errand::Leaving;
  auto& [program, home, returns, leaving] = *errand_;
  if (leaving == Leaving::No) {
    if (make_exact(line) != Reply::Done) return Reply::Later;
    leaving = Leaving::Stopping;
    loads_.put_tool_back();
  }
  if (leaving == Leaving::Stopping) {
    if (!loads_.doubted() && tell_load(line) != Reply::Done) return Reply::Later;
    if (returns) {
      if (const Reply reply = move_back(line); reply != Reply::Done) return reply;
    }
    leaving = Leaving::Moving;
  }
  if (leaving == Leaving::Moving) {
    if (!settled()) return Reply::Later;
    channels_.after_handler.store(returns ? AfterHandler::GoOn : AfterHandler::Leave);
    leaving = Leaving::Asked;
  }
  if (!returns) {
    const Reply reply = program->leave_path();
    if (reply == Reply::Refused) refuse(program->refusal());
    return reply;
  }
  program->handler_ = Handler::None;
  return Reply::Done;
}

void RobotMachine::remember(Commanded commanded) {
  if (!keeps_commanded_) return;
  commanded_.push_back(std::move(commanded));
  // The one that runs, and those of the buffer.
  if (commanded_.size() > static_cast<std::size_t>(robot_.most_ahead()) + 2) commanded_.pop_front();
}

/// The interrupted motion has ended where the axes stand now: what was queued after it starts from
/// there, with the numbers that it had, since what stands between the motions goes with them. All
/// of it is planned before any is queued.
Reply RobotMachine::leave_path() {
  Rest rest;
  if (!take_rest(rest)) return Reply::Later;
  std::deque<Commanded> behind = std::exchange(commanded_, {});
  std::erase_if(behind, [&](const Commanded& one) { return one.segment.number <= rest.number; });
  planner_.stand_at(rest.q, rest.number);
  jogging_ = false;
  const lang::Setting setting = setting_;
  const bool planned =
      std::ranges::all_of(behind, [&](Commanded& one) { return plan_anew(one); }) &&
      plan_path_anew();
  work_in(0, setting);
  planner_.carry(loads_.told().all());
  if (!planned) {
    path_.reset();
    planner_.stand_at(rest.q, rest.number);
    restart_from(rest.q);
    handlers_->errand_->leaving = Errand::Leaving::Moving;  // all that is left must be dropped
    return Reply::Refused;
  }
  handler_ = Handler::None;
  exact_ = true;
  if (behind.empty() && guarded_) left_ = rest;
  const bool guarded = std::exchange(guarded_, false);  // those that are have their guards
  for (Commanded& one : behind) {
    follow(one.segment);
    send(std::move(one));
  }
  if (path_) {
    path_->exact = exact_;
    for (const Commanded& one : path_->motions) follow(one.segment);
  }
  guarded_ = guarded;
  return Reply::Done;
}

/// False, with a refusal, where it cannot be reached any more.
bool RobotMachine::plan_anew(Commanded& commanded) {
  motion::SegmentDescriptor& segment = commanded.segment;
  const motion::Watch guard = segment.guard;
  const motion::SettleWindow settle = segment.settle;
  if (commanded.move) {
    work_in(static_cast<int>(segment.tag), commanded.setting);
    planner_.carry(commanded.carried == nullptr ? motion::ArmLoad{} : commanded.carried->all());
    if (!plan(static_cast<int>(segment.tag), commanded)) {
      Words words = refusal();
      words.message =
          fmt::format("the motion of line {} starts from elsewhere behind BRAKE: {}",
                      lang::tagged_place(static_cast<int>(segment.tag)).line, words.message);
      refuse(std::move(words));
      return false;
    }
  } else {
    const auto stop = segment.dwell ? std::nullopt : planner_.stop(segment.tag);
    // Where the axes stand already the number is taken all the same.
    segment = stop ? *stop : planner_.dwell(segment.tag, segment.dwell ? segment.duration : 0);
  }
  segment.guard = guard;
  segment.settle = settle;
  return true;
}

/// What has gone wrong in a handler ends it and all that it has interrupted.
Reply RobotMachine::drop_interrupted(int line) {
  if (handlers_->errand_->leaving != Errand::Leaving::Asked) {
    if (const Reply reply = handlers_->settle(line); reply != Reply::Done) return reply;
    channels_.after_handler.store(AfterHandler::LeaveAll);
    handlers_->errand_->leaving = Errand::Leaving::Asked;
  }
  Rest rest;
  if (!take_rest(rest)) return Reply::Later;
  handler_ = Handler::None;
  restart_from(rest.q);
  left_.reset();
  return Reply::Done;
}

}  // namespace rob::runtime

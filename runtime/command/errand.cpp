#include "runtime/command/errand.h"

#include <variant>

namespace rob::runtime {

using lang::Reply;

void Errand::begin(HandlerTurns& program, const motion::JointVector& home) {
  program_ = &program;
  home_ = home;
  returns_ = true;
  leaving_ = Leaving::No;
  queue_.restart_from(home);
  queue_.bar_brake();
}

Reply Errand::leave(int line) {
  if (leaving_ == Leaving::No) {
    if (queue_.make_exact(line) != Reply::Done) return Reply::Later;
    leaving_ = Leaving::Stopping;
    loads_.put_tool_back();
  }
  if (leaving_ == Leaving::Stopping) {
    if (!loads_.doubted() && !queue_.collecting() && loads_.tell(line) != Reply::Done)
      return Reply::Later;
    if (returns_) {
      if (const Reply reply = move_back(line); reply != Reply::Done) return reply;
    }
    leaving_ = Leaving::Moving;
  }
  if (leaving_ == Leaving::Moving) {
    if (!progress_.settled()) return Reply::Later;
    ask(returns_ ? AfterHandler::GoOn : AfterHandler::Leave);
  }
  if (returns_) {
    program_->go_on();
    return Reply::Done;
  }
  const Reply reply = program_->leave_path(links_.refuse);
  if (reply == Reply::Refused) leaving_ = Leaving::Moving;  // all that is left must be dropped
  return reply;
}

/// Back to where the path was left, from rest to rest; nothing where the axes have not moved.
Reply Errand::move_back(int line) {
  if (queue_.room() < 2) return Reply::Later;
  if ((links_.planner.commanded() - home_).cwiseAbs().maxCoeff() <= motion::kLimitTolerance)
    return Reply::Done;
  motion::MotionRequest request;
  request.tag = static_cast<motion::Tag>(line);
  request.given = lang::given_all(links_.robot.axis_count());
  for (int i = 0; i < links_.robot.axis_count(); ++i)
    request.target[static_cast<std::size_t>(i)] = home_[i];
  const motion::PlanOutcome outcome = links_.planner.plan(request);
  if (const auto* const refusal = std::get_if<motion::Refusal>(&outcome))
    return links_.refuse(words_for(*refusal, links_.robot));
  queue_.add(std::get<motion::PlannedSegment>(outcome).segment, false);
  return queue_.make_exact(line);
}

}  // namespace rob::runtime

#pragma once

#include <span>
#include <string>
#include <utility>

#include "runtime/command/background_tasks.h"
#include "runtime/command/commanded_progress.h"
#include "runtime/command/effect_queue.h"

namespace rob::runtime {

/// The traffic between a program and its TASKs: START and new values of globals in motion order,
/// and the values that TASKs have set.
class TaskReports {
 public:
  TaskReports(const RobotLinks& links, EffectQueue& effects, const CommandedProgress& progress)
      : links_(links), effects_(effects), progress_(progress) {}

  /// Those of the program; they must outlive the run.
  void go_to(BackgroundTasks& tasks) { tasks_ = &tasks; }

  lang::Reply start(const lang::Place& place, std::uint32_t task);
  /// New values of globals, from the one with number `first` on.
  template <typename Value>
  lang::Reply publish(int line, std::size_t first, std::span<const Value> values) {
    return report(line, BackgroundTasks::Store<Value>{first, {values.begin(), values.end()}});
  }
  lang::Reply publish_list(int line, std::size_t home, const lang::ListContent& list);
  /// Their current values.
  template <typename Value>
  lang::Reply refresh(std::size_t first, std::span<Value> values) {
    if (!progress_.observable()) return lang::Reply::Later;
    tasks_->take_due();
    tasks_->memory().load(first, values);
    return lang::Reply::Done;
  }

 private:
  lang::Reply report(int line, BackgroundTasks::Due due);

  const RobotLinks& links_;
  EffectQueue& effects_;
  const CommandedProgress& progress_;
  BackgroundTasks* tasks_ = nullptr;
};

}  // namespace rob::runtime

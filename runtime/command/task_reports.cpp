#include "runtime/command/task_reports.h"

namespace rob::runtime {

using lang::Reply;
using motion::Effect;

Reply TaskReports::report(int line, BackgroundTasks::Due due) {
  if (effects_.full() || tasks_->full()) return Reply::Later;
  Effect effect{.tag = static_cast<motion::Tag>(line), .kind = Effect::Kind::Report};
  effect.id = tasks_->keep(std::move(due));
  return effects_.push(effect);
}

Reply TaskReports::publish_list(int line, std::size_t home, const lang::ListContent& list) {
  if (effects_.full() || tasks_->full()) return Reply::Later;
  return report(line,
                BackgroundTasks::StoreList{.home = home,
                                           .size = list.size,
                                           .count = list.count,
                                           .numbers = {list.numbers.begin(), list.numbers.end()},
                                           .texts = {list.texts.begin(), list.texts.end()}});
}

/// A TASK that was started before may run still: that is seen at the decision point, and nothing
/// after its START is commanded before.
Reply TaskReports::start(const lang::Place& place, std::uint32_t task) {
  if (tasks_->was_started(task)) {
    if (!progress_.observable()) return Reply::Later;
    tasks_->take_due();
    if (tasks_->busy(task)) return links_.refuse(tasks_->runs_already(task));
  }
  return report(lang::line_tag(place), BackgroundTasks::Start{task, place});
}

}  // namespace rob::runtime

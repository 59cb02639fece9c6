#include "runtime/command/operator_desk.h"

#include <utility>

#include "runtime/files/point_digits.h"

namespace rob::runtime {

using lang::Reply;

/// Stands, with all that was commanded done, and shows the text once.
Reply OperatorDesk::consult(int line, Note::Kind kind, std::string_view text) {
  double now = 0;
  if (waits_.stand(line, now) != Reply::Done || !progress_.settled()) return Reply::Later;
  const bool room = !links_.buffer.full() && !effects_.full();
  if (consulting_) return room ? Reply::Done : Reply::Later;
  if (Person* const person = links_.channels.panel.person()) person->listen();
  if (effects_.note(line, {kind, std::string(text)}) == Reply::Done) consulting_ = true;
  return Reply::Later;
}

/// consult() has seen that there is room for both.
Reply OperatorDesk::answered(int line, std::string answer, bool typed) {
  consulting_ = false;
  effects_.note(line, {Note::Kind::Answer, std::move(answer), typed});
  return waits_.waited(line);
}

Reply OperatorDesk::unattended(int line, const char* what) {
  if (assumptions_.foretelling()) {
    assumptions_.note_answer(line, what);
    return answered(line, "");
  }
  consulting_ = false;
  waits_.drop();
  return links_.refuse(words_for_nobody(what));
}

bool OperatorDesk::attended() const {
  Person* const person = links_.channels.panel.person();
  return person != nullptr && person->present();
}

Reply OperatorDesk::halt(int line, std::string_view text) {
  const Reply reply = consult(line, Note::Kind::Halt, text);
  if (reply != Reply::Done) return reply;
  OperatorPanel& panel = links_.channels.panel;
  if (panel.take_go()) return answered(line, "");
  if (panel.go_may_come()) return Reply::Later;
  if (attended()) return panel.person()->line() ? answered(line, "", true) : Reply::Later;
  return unattended(line, "HALT");
}

Reply OperatorDesk::ask(int line, std::string_view text, std::optional<std::string>& answer) {
  const Reply reply = consult(line, Note::Kind::Ask, text);
  if (reply != Reply::Done) return reply;
  OperatorPanel& panel = links_.channels.panel;
  const std::string* const given = panel.take_answer();
  if (given != nullptr) answer = *given;
  if (!answer && panel.answer_may_come()) return Reply::Later;
  if (!answer && attended()) {
    answer = panel.person()->line();
    if (!answer) return Reply::Later;
  }
  return answer ? answered(line, *answer, given == nullptr) : unattended(line, "ASK");
}

/// HERE was read just before, at rest: the axes are still commanded to stand where it was. The
/// program goes on with what is kept, as the next run does.
Reply OperatorDesk::teach(lang::TaughtPoint& point) {
  const motion::JointVector q = links_.channels.joints.load();
  point.joints.assign(q.begin(), q.end());
  round_as_kept(links_.robot, point);
  if (keeper_ == nullptr) return Reply::Done;
  const auto refusal = keeper_->keep(point);
  return refusal ? links_.refuse(*refusal) : Reply::Done;
}

}  // namespace rob::runtime

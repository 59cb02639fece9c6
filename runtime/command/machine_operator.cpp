#include <string>
#include <utility>

#include "runtime/command/robot_machine.h"
#include "runtime/words/messages.h"

/// Member functions of RobotMachine for HALT and ASK.
namespace rob::runtime {

using lang::Reply;

/// Stands, with all that was commanded done, and shows the text once.
Reply RobotMachine::consult(int line, Note::Kind kind, std::string_view text) {
  double now = 0;
  if (stand(line, now) != Reply::Done || !settled()) return Reply::Later;
  if (consulting_) return buffer_.full() || buffer_.effects_full() ? Reply::Later : Reply::Done;
  if (Person* const person = channels_.panel.person()) person->listen();
  if (note(line, {kind, std::string(text)}) == Reply::Done) consulting_ = true;
  return Reply::Later;
}

/// consult() has seen that there is room for both.
Reply RobotMachine::answered(int line, std::string answer, bool typed) {
  consulting_ = false;
  note(line, {Note::Kind::Answer, std::move(answer), typed});
  return waited(line);
}

Reply RobotMachine::refuse_unattended(const char* what) {
  consulting_ = begun_ = standing_ = false;
  refuse(words_for_nobody(what));
  return Reply::Refused;
}

bool RobotMachine::attended() const {
  Person* const person = channels_.panel.person();
  return person != nullptr && person->present();
}

Reply RobotMachine::halt(int line, std::string_view text) {
  const Reply reply = consult(line, Note::Kind::Halt, text);
  if (reply != Reply::Done) return reply;
  OperatorPanel& panel = channels_.panel;
  if (panel.take_go()) return answered(line, "");
  if (panel.go_may_come()) return Reply::Later;
  if (attended()) return panel.person()->line() ? answered(line, "", true) : Reply::Later;
  if (!foretelling_) return refuse_unattended("HALT");
  note_answer_assumed(line, "HALT");
  return answered(line, "");
}

Reply RobotMachine::ask(int line, std::string_view text, std::optional<std::string>& answer) {
  const Reply reply = consult(line, Note::Kind::Ask, text);
  if (reply != Reply::Done) return reply;
  OperatorPanel& panel = channels_.panel;
  const std::string* const given = panel.take_answer();
  if (given != nullptr) answer = *given;
  if (!answer && panel.answer_may_come()) return Reply::Later;
  if (!answer && attended()) {
    answer = panel.person()->line();
    if (!answer) return Reply::Later;
  }
  if (answer) return answered(line, *answer, given == nullptr);
  if (!foretelling_) return refuse_unattended("ASK");
  note_answer_assumed(line, "ASK");
  return answered(line, "");
}

}  // namespace rob::runtime

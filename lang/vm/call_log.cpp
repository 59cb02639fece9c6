#include "lang/vm/call_log.h"

namespace rob::lang {

Reply CallLog::answer() {
  if (later_ > 0) {
    --later_;
    return Reply::Later;
  }
  if (refuse_after_ && (*refuse_after_)-- == 0) return Reply::Refused;
  return Reply::Done;
}

Reply CallLog::note(int line, std::string text) {
  const Reply reply = answer();
  if (reply == Reply::Done) write(line, std::move(text));
  return reply;
}

std::vector<std::string> CallLog::texts() const {
  std::vector<std::string> texts;
  for (const Call& call : calls_) texts.push_back(call.text);
  return texts;
}

}  // namespace rob::lang

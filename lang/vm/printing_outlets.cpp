#include "lang/vm/printing_outlets.h"

#include <utility>

#include "lang/text/codes.h"
#include "lang/values/number_text.h"

namespace rob::lang {

Reply PrintingOutlets::write(int line, std::string_view file, std::string_view text) {
  const Reply reply = log_.note(line, fmt::format("write {} {}", file, text));
  if (reply == Reply::Done) files_[std::string(file)] += std::string(text) + "\n";
  return reply;
}

Reply PrintingOutlets::read_file(int line, std::string_view file, std::string& text) {
  const auto found = files_.find(file);
  if (found == files_.end()) {
    return refuse({std::string(code::kFileFailed), fmt::format("cannot read '{}'", file), ""});
  }
  const Reply reply = log_.note(line, fmt::format("read {}", file));
  if (reply == Reply::Done) text = found->second;
  return reply;
}

Reply PrintingOutlets::receive(int line, std::size_t device, double /*timeout*/, std::string& text,
                               bool& came) {
  const Reply reply = log_.note(line, fmt::format("receive {}", device + 1));
  std::deque<std::string>& lines = lines_[device];
  came = reply == Reply::Done && !lines.empty();
  if (!came) return reply;
  text = lines.front();
  lines.pop_front();
  return reply;
}

Reply PrintingOutlets::simulate_line(int line, std::size_t device, std::string_view text,
                                     double after) {
  const Reply reply = log_.note(line, fmt::format("simulate line {} {} after {}", device + 1, text,
                                                  number_text(after, kTime)));
  if (reply == Reply::Done) lines_[device].emplace_back(text);
  return reply;
}

void PrintingOutlets::warn(int line, Refusal warning) {
  log_.note(line, fmt::format("warned {}", warning.message));
}

Reply PrintingOutlets::exists(int, std::string_view file, bool& value) {
  const Reply reply = log_.answer();
  if (reply == Reply::Done) value = files_.contains(file);
  return reply;
}

}  // namespace rob::lang

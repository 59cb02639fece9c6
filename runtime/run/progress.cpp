#include "runtime/run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "lang/text/visible.h"
#include "runtime/run/console.h"
#include "runtime/run/terminal_kind.h"
#include "runtime/words/state_name.h"

namespace rob::runtime {

namespace {

constexpr double kEvery = 0.1;  // s: as often as an eye reads

}  // namespace

Progress::Progress(double planned, double override_share, std::vector<std::string> used)
    : planned_(planned),
      override_share_(override_share),
      used_(std::move(used)),
      terminal_(draws(STDERR_FILENO)) {}

void Progress::show(const Position& position) {
  if (!terminal_ || consulting_ || position.line == 0 || position.time - last_ < kEvery) return;
  last_ = position.time;
  shown_ = true;
  const lang::Place place = lang::tagged_place(position.line);
  std::string text = fmt::format("line {}", place.line);
  if (place.file > 0) text += " of " + lang::on_one_line(used_[place.file - 1]);
  text += fmt::format("  {:.1f} s", position.time);
  if (planned_ > 0) {
    text += fmt::format("  {:.1f} s left", std::max(0.0, planned_ - position.time));
  }
  clear_message_line();
  put_message(text +
              fmt::format("  {:.0f}%  {}", 100 * override_share_, state_name(position.state)));
}

/// It goes faster than an eye reads: what counts here is the clock.
void Progress::show(double time) {
  using Clock = std::chrono::steady_clock;
  if (!terminal_) return;
  const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  if (now - last_ < kEvery) return;
  const bool first = last_ < 0;
  last_ = now;
  if (first) return;  // most programs are foretold before anybody could read it
  shown_ = true;
  clear_message_line();
  put_message(fmt::format("foretold {:.0f} s, at most {:.0f} s", time, planned_));
}

void Progress::consult(const Note& note, int line) {
  clear();
  if (note.kind == Note::Kind::Answer) {
    if (consulting_ == Note::Kind::Ask && !note.typed) put_message(note.text + "\n");
    consulting_.reset();
    return;
  }
  consulting_ = note.kind;
  if (note.kind == Note::Kind::Ask) return put_message(note.text);
  put_message(fmt::format("halted in line {}{}{}; Enter goes on\n", line,
                          note.text.empty() ? "" : ": ", note.text));
}

void Progress::clear() {
  if (!shown_) return;
  shown_ = false;
  clear_message_line();
}

}  // namespace rob::runtime

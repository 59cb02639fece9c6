#include "runtime/prompt/pendant_terminal.h"

#include <utility>

#include "motion/space/joint_vector.h"
#include "runtime/files/files.h"
#include "runtime/prompt/pendant.h"
#include "runtime/prompt/pendant_view.h"
#include "runtime/prompt/raw_terminal.h"
#include "runtime/run/interruption.h"
#include "runtime/run/terminal_kind.h"

namespace rob::runtime {

namespace {

// [choice] ms: a key is taken at once; the display is drawn twenty times a second, faster than a
// person reads.
constexpr int kPause = 10;
constexpr int kPausesOfAFrame = 5;
/// ms to wait for what the terminal says of itself, over a slow line.
constexpr int kAnswer = 500;

/// Keeps what is written while the screen is the pendant's; its last line is shown there.
class KeptScreen final : public Screen {
 public:
  void result(std::string_view text) override { keep(text); }
  void message(std::string_view text) override { keep(text); }
  const std::string& last() const { return last_; }
  /// The message from where the robot stood is over when it moves on.
  void forget_behind(const motion::JointVector& place) {
    constexpr double kAway = 1e-3;  // m or rad [choice]
    if (std::exchange(news_, false)) said_at_ = place;
    if (said_at_.size() == place.size() && (place - said_at_).lpNorm<Eigen::Infinity>() > kAway)
      last_.clear();
  }
  const std::string& all() const { return all_; }

 private:
  void keep(std::string_view text) {
    all_ += text;
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.empty() || line.starts_with("help: ")) return;
    last_ = line;
    news_ = true;
  }

  std::string all_;
  std::string last_;
  motion::JointVector said_at_;
  bool news_ = false;
};

/// Whether the terminal reports releases, as it answers; what has been typed meanwhile is kept.
bool ask_for_releases(RawTerminal& terminal, KeyReader& keys) {
  terminal.write(kAskKeyboard);
  for (int waited = 0; waited < kAnswer && !keys.answered(); waited += kPause) {
    const auto bytes = terminal.read(kPause);
    if (!bytes) return false;
    keys.feed(*bytes);
    while (keys.next()) continue;
  }
  if (!keys.tells_releases()) return false;
  terminal.write(kTellReleases);
  return true;
}

/// Nobody moves a robot with a display that cannot be seen.
bool leaves(const Key& key) { return key.kind == Key::Kind::Escape || key.is('q'); }

void show_pendant(Session& session, KeptScreen& kept) {
  RawTerminal terminal;
  KeyReader keys;
  Pendant pendant(session, session.dead_man(), ask_for_releases(terminal, keys));
  std::string shown;
  int quiet = 0;
  for (int pause = 0; !pendant.over() && !session.over(); ++pause) {
    const auto bytes = terminal.read(kPause);
    if (!bytes) {
      session.quit();  // the terminal is gone
      break;
    }
    quiet = bytes->empty() ? quiet + 1 : 0;
    keys.feed(*bytes);
    const bool seen = fits_pendant(terminal.columns(), terminal.rows());
    if (!seen) pendant.give_up();
    while (const auto key = keys.next())
      if (seen || leaves(*key)) pendant.press(*key);
    if (quiet > kPausesOfAFrame) {
      if (const auto escape = keys.lone_escape()) pendant.press(*escape);
    }
    if (Interruption::ctrl_c_pressed() && !session.interrupt_again()) {
      pendant.give_up();
      session.await_rest();
    }
    if (Interruption::requested()) break;
    session.let_pass();
    pendant.go_on();
    if (const auto& now = session.robot().reports().last())
      kept.forget_behind(now->sample.reference.q);
    if (pause % kPausesOfAFrame != 0) continue;
    std::string view =
        pendant_view(pendant, kept.last(), terminal.columns(), terminal.rows(), locale_is_utf8());
    if (view != shown) terminal.show(view);
    shown = std::move(view);
  }
  pendant.stop();
}

}  // namespace

void run_pendant(Session& session) {
  KeptScreen kept;
  Screen& before = session.write_to(kept);
  try {
    show_pendant(session, kept);
  } catch (const FileError& error) {
    session.fail(error.what(), "", ExitCode::Usage);
  }
  session.write_to(before);
  before.message(kept.all());
}

}  // namespace rob::runtime

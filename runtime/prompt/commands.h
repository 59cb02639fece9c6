#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rob::runtime {

class Session;

/// A colon command of the prompt: `:override 50%`.
struct Command {
  using Words = std::vector<std::string>;

  const char* name;
  const char* takes;  ///< "[SHARE%]": what may stand behind it, for help
  const char* does;
  void (*carry_out)(Session& session, const Words& words);
  /// Words behind which the rest of the line is one, as it was typed: file names, source lines.
  std::size_t plain_words = 1000;
};

/// All of them, in the order of help.
std::span<const Command> commands();

/// What stands behind the colon; unknown words are told with the nearest name.
void carry_out_command(Session& session, std::string_view line);

// commands_motion.cpp
namespace command {
using Words = Command::Words;
void where(Session& session, const Words& words);
void signals(Session& session, const Words& words);
void override_speed(Session& session, const Words& words);
void hold(Session& session, const Words& words);
void resume(Session& session, const Words& words);
void stop(Session& session, const Words& words);
void reset(Session& session, const Words& words);
void guide(Session& session, const Words& words);
void home(Session& session, const Words& words);
void robot(Session& session, const Words& words);
void law(Session& session, const Words& words);
void jog(Session& session, const Words& words);
// commands_program.cpp
void record(Session& session, const Words& words);
void list(Session& session, const Words& words);
void edit(Session& session, const Words& words);
void insert(Session& session, const Words& words);
void erase(Session& session, const Words& words);
void undo(Session& session, const Words& words);
void redo(Session& session, const Words& words);
void begin_new(Session& session, const Words& words);
void variables(Session& session, const Words& words);
// commands_run.cpp
void run(Session& session, const Words& words);
void step(Session& session, const Words& words);
void back(Session& session, const Words& words);
void breakpoints(Session& session, const Words& words);
void check(Session& session, const Words& words);
void time(Session& session, const Words& words);
// commands_files.cpp
void save(Session& session, const Words& words);
void save_over(Session& session, const Words& words);
void load(Session& session, const Words& words);
void archive(Session& session, const Words& words);
void compare(Session& session, const Words& words);
void restore(Session& session, const Words& words);
// commands_points.cpp
void teach(Session& session, const Words& words);
void points(Session& session, const Words& words);
void rename(Session& session, const Words& words);
void forget(Session& session, const Words& words);
}  // namespace command

}  // namespace rob::runtime

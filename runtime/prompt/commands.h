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
void robot(Session& session, const Words& words);
void law(Session& session, const Words& words);
void jog(Session& session, const Words& words);
}  // namespace command

}  // namespace rob::runtime

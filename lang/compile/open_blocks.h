#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lang/code/code_builder.h"

namespace rob::lang {

/// The blocks of the current routine that are open, and what was begun in them: what EXIT, NEXT and
/// RETURN leave on their way.
class OpenScopes {
 public:
  explicit OpenScopes(CodeBuilder& code) : code_(code) {}

  /// A new routine begins.
  void begin_routine() { whens_ = 0; }

  // Loops
  void enter_loop();
  /// NEXT arrives here.
  void land_next() { code_.land(loops_.back().nexts); }
  /// EXIT arrives here: after the loop.
  void leave_loop();
  void exit_loop(Place place);
  void next_turn(Place place);

  // WHENs, which are armed until their block ends
  std::size_t whens() const { return whens_; }
  /// One more; how many stand before it in its frame.
  std::size_t arm() { return whens_++; }
  /// At least so many are armed: by earlier entries of a prompt.
  void armed(std::size_t whens);
  /// Code that disarms what was armed after them, in routines that were called too.
  void disarm_inner(Place place);
  /// A block ends before which `kept` were armed.
  void close_whens(std::size_t kept, Place place);

  // TRY, RESCUE, WITH and PRESS
  enum class Kind : std::uint8_t { Try, Rescue, With, Press };
  void open(Kind kind);
  /// Code that leaves the innermost of these blocks.
  void close(Kind kind, Place place);

  /// Code that leaves all blocks of a routine.
  void leave_routine(Place place);
  /// RETURN at the top level jumps to the end of the program.
  void leave_program(Place place);
  void land_end() { code_.land(returns_); }

 private:
  struct Loop {
    CodeBuilder::Jumps exits;
    CodeBuilder::Jumps nexts;
    std::size_t whens = 0;   ///< that were armed in this frame when it began
    std::size_t guards = 0;  ///< open around the loop
    std::size_t scopes = 0;
  };
  void leave_loop_body(Place place);
  void leave_whens(std::size_t kept, Place place);
  void leave_guards(std::size_t kept, Place place);
  void leave_scopes(std::size_t kept, Place place);

  CodeBuilder& code_;
  std::vector<Loop> loops_;
  std::vector<Kind> guards_;  ///< TRY and RESCUE
  std::vector<Kind> scopes_;  ///< WITH and PRESS
  std::size_t whens_ = 0;     ///< whose block is open
  CodeBuilder::Jumps returns_;
};

}  // namespace rob::lang

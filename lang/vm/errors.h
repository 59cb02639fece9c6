#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "lang/text/diagnostic.h"
#include "lang/values/arithmetic.h"
#include "lang/vm/objection.h"
#include "lang/vm/stack.h"

namespace rob::lang {

/// A routine that was running, and the line that called it.
struct CallSite {
  /// How it has begun: by a call; START, of a TASK; the condition of a WHEN, of its handler: then
  /// the line is that of the WHEN.
  enum class By : std::uint8_t { Call, Start, When };

  std::string routine;  ///< "WHEN": a handler
  int line = 0;
  By by = By::Call;

  bool operator==(const CallSite&) const = default;
};

/// An error of the running program: what a Diagnostic says, found at run time.
struct RuntimeError {
  std::string code;
  Place place;
  std::string message;
  std::string help;
  std::vector<CallSite> calls{};  ///< the routines it happened in, the innermost first
};

Refusal refusal_of(ArithmeticError error);

/// TRY blocks that can be open, those whose RESCUE runs included. [choice] one a call.
inline constexpr std::size_t kMostTries = kMostCalls;

/// Why no further one can be opened.
Refusal tries_too_deep();

/// A TRY block that is open, or whose RESCUE runs.
struct TryBlock {
  const Instruction* rescue;
  std::uint8_t why;      ///< text register
  std::size_t depth;     ///< calls that were open
  std::size_t whens;     ///< WHENs that were armed
  std::size_t settings;  ///< WITHs that were open
  std::size_t presses;   ///< PRESSes that were open
  bool caught = false;   ///< the RESCUE runs: it catches nothing more
  RuntimeError error{};  ///< that it has caught
};

/// The TRY blocks that are open, and the error on its way to one of them, or to the end.
class TryBlocks {
 public:
  bool full() const { return blocks_.size() == kMostTries; }
  std::size_t count() const { return blocks_.size(); }
  void open(TryBlock block) { blocks_.push_back(std::move(block)); }
  void close() { blocks_.pop_back(); }
  /// Closes all beyond the first `kept`.
  void drop(std::size_t kept);

  /// The last error, whether it was caught or not.
  const RuntimeError& error() const { return error_; }
  void fail(RuntimeError error);
  /// With the error of the innermost RESCUE. Where it went wrong, and through which calls, stays
  /// what it was.
  void fail_again();
  /// Whether one of the blocks from `first` on catches an error.
  bool catches(std::size_t first) const;

  /// The error is on its way to a RESCUE.
  bool rescuing() const { return rescuing_; }
  /// The block whose RESCUE that is; those inside it are closed.
  const TryBlock& rescuer();
  /// The RESCUE begins.
  void rescue();
  /// The text that it is given. An error that the program raised itself is its own text; all others
  /// differ by their code.
  std::string reason() const;

 private:
  std::vector<TryBlock> blocks_;
  RuntimeError error_;
  bool rescuing_ = false;
};

/// The longest text that a program can build, in bytes. [choice] far more than a line to be read,
/// and with at most kTextStack text registers and kMemory.texts in arrays and records a program
/// never holds more than 320 MiB of text, and those of kMostTries errors.
inline constexpr std::size_t kMostText = 65536;

Refusal text_too_long();

}  // namespace rob::lang

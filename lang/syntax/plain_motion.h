#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lang/machine/motion_words.h"
#include "lang/machine/move_command.h"
#include "lang/machine/robot_signature.h"

/// Motions that are written in numbers alone: `MOVE(140, , -0.5m)`, and nothing after it but AT and
/// ZONE, each a number with its unit, and a comment. Programs made by programs are a million such
/// lines, so these are read straight from the text, by the rules of the lexer and the grammar, and
/// kept as numbers instead of trees.
namespace rob::lang {

struct PlainMotion {
  /// `-0.5m`: what a place of the tuple holds.
  struct Component {
    std::string_view number;  ///< without sign and unit; empty where the place was left out
    bool negative = false;
    std::optional<Unit> unit;  ///< none: that of the place
  };
  int count = 0;
  std::array<Component, kMaxCoordinates> components;
  MoveCommand::Pace pace = MoveCommand::Pace::Unspecified;
  double pace_value = 0;  ///< as in MoveCommand, above 0
  MoveCommand::Zone zone = MoveCommand::Zone::Unspecified;
  double zone_value = 0;        ///< the same
  std::size_t zone_offset = 0;  ///< of the number after ZONE, from the first letter
  std::size_t length = 0;       ///< bytes from its first letter to after its last sign
};

/// The motion that `text` begins with, at its bracket (`word` bytes after its first letter). None
/// where it is written in any other way, or wrongly: then the parser reports it.
std::optional<PlainMotion> read_plain_motion(std::string_view text, std::size_t word);
/// The same up to its closing bracket, of one that has been read before.
std::optional<PlainMotion> read_plain_target(std::string_view text, std::size_t word);

}  // namespace rob::lang

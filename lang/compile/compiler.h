#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "lang/check/checked_program.h"
#include "lang/code/chunk.h"
#include "lang/code/frame_slots.h"
#include "lang/code/location.h"
#include "lang/machine/robot_signature.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// The room that earlier entries of the prompt have taken.
struct EntryRooms {
  Room now;                              ///< before the entry
  std::map<std::uint32_t, Room> before;  ///< before lines of earlier entries that stand in the text
};

struct Generated {
  std::optional<Chunk> chunk;
  // For an entry:
  Room room;                    ///< what is taken after it
  std::vector<Location> homes;  ///< by Symbol::id
};

/// Turns a program that was checked without errors into code. Fails, with a message, only where a
/// limit of the code is exceeded. `rooms`: null if it is no entry of the prompt.
Generated generate(const CheckedProgram& checked, const RobotSignature& robot,
                   Diagnostics& diagnostics, const EntryRooms* rooms = nullptr);

}  // namespace rob::lang

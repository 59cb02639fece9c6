#include "lang/chunk.h"

namespace rob::lang {

const OpcodeInfo& info(Opcode opcode) {
  static constexpr std::array kInfos = std::to_array<OpcodeInfo>({
#define ROB_OPCODE(name, operands) {#name, operands},
#include "lang/opcodes.def"
  });
  return kInfos[static_cast<std::size_t>(opcode)];
}

}  // namespace rob::lang

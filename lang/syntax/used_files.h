#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"
#include "lang/text/text_parts.h"

namespace rob::lang {

/// Why USE leads nowhere.
struct NoSource {
  std::string message;
  std::string help;
};

/// Where the texts are that a program USEs: the language itself reads no files.
class Sources {
 public:
  virtual ~Sources() = default;
  /// The program's own file, without its text.
  virtual const SourceFile& program() const = 0;
  /// The text that `name` means in the file that is called `by`.
  virtual std::variant<SourceFile, NoSource> find(std::string_view name,
                                                  const std::string& by) const = 0;
};

/// Reads a program and the files that it USEs, each once, however often and by whichever of them
/// it is USEd. The declarations of a file come where it is USEd first (Use), its routines among
/// those of the program. Errors go to `diagnostics`; a USE that leads nowhere leaves
/// Program::whole false. `sources`: null where there are no files; `used`: what was read.
/// For an entry of the prompt: `parts` are its lines, `types` what it can name beside its own;
/// `printed_from`: see SourceContext.
Program read_program(std::string_view source, const Sources* sources, const RobotSignature& robot,
                     Diagnostics& diagnostics, std::vector<SourceFile>& used, TextParts parts = {},
                     std::shared_ptr<TypeTable> types = std::make_shared<TypeTable>(),
                     std::uint32_t printed_from = 0);

}  // namespace rob::lang

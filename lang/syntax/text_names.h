#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lang/syntax/ast.h"
#include "lang/syntax/source_context.h"
#include "lang/syntax/token_reader.h"

namespace rob::lang {

/// The names of a text: reads those that it declares, and knows those that stand for routines,
/// types and files before they are declared.
class TextNames {
 public:
  /// In capitals; defined anywhere in the text.
  struct Defined {
    std::set<std::string> routines;  ///< PROC, FUNC and TASK
    std::set<std::string> records;
    std::set<std::string> enums;
  };

  /// All that `context` points to must outlive it.
  TextNames(TokenReader& tokens, const SourceContext& context);

  /// Reads a name that is declared; `kind` is what stands before it.
  Declaration::Declared declared(std::string_view kind);
  /// How many were declared so far, those of the files before included.
  std::size_t count() const { return names_; }

  /// At `tools.grip`, where `tools` is a USEd file.
  bool at_foreign() const;
  /// Reads it as one name, with its point.
  std::string foreign();

  const Defined& defined();
  /// Whether a PROC, FUNC or TASK is called so, anywhere in the text or in a file that it USEs.
  bool names_routine(std::string_view name);
  /// The RECORD or ENUM of this name, of the text or of a file that it USEs; null if there is none.
  const TypeDetail* record(const Token& name);
  /// The FRAME of this name, which may not be declared yet.
  const TypeDetail* frame(const Token& name);
  TypeDetail& own_record(std::string_view name) { return types_.record(file_, name); }
  TypeDetail& own_enum(std::string_view name);
  TypeDetail& own_frame(std::string_view name) { return types_.frame(file_, name); }

  /// Says which file a USE means. The declarations of the file go to its first USE.
  void resolve(Use& use) const;

 private:
  void count_name();
  const TypeDetail* imported(const Token& name, const TypeTable::Named& types);

  TokenReader& tokens_;
  const Outline& outline_;
  std::vector<Import> imports_;
  TypeTable& types_;
  std::uint32_t file_;
  std::size_t names_;
  std::optional<Defined> defined_;  ///< once asked for
};

/// The device after SEND or RECEIVE, perhaps of a USEd file.
std::string device_name(TokenReader& tokens, TextNames& names, std::string_view word);

}  // namespace rob::lang

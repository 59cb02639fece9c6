#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "lang/syntax/routine_parser.h"
#include "lang/syntax/text_names.h"
#include "lang/syntax/token_reader.h"

namespace rob::lang {

/// Statements as other robots and languages write them: MoveL p10, v100, z10, tool0; · PTP p ·
/// movej(…) · sleep(1) · for i in range(3): · -- a comment · GOTO · REPEAT … UNTIL · SUB · G1 X10.
/// Each gets one message, which shows Rob's line, and is skipped up to its end.
class ForeignHints {
 public:
  ForeignHints(TokenReader& tokens, TextNames& names, RoutineParser& routines)
      : tokens_(tokens), names_(names), routines_(routines) {}

  /// At the beginning of a statement: whether it was one of them. Then it is skipped.
  bool skip();

 private:
  bool skip_word();
  bool skip_motion();
  bool skip_for();
  bool skip_label();
  bool skip_repeat();
  bool skip_sub();
  bool is_call_of_others() const;
  std::string range_text() const;
  /// Reports, and goes on at the end of the line that the byte `end` lies on.
  bool skip_line(std::string message, std::string help);
  bool skip_up_to(std::size_t end, std::string message, std::string help);
  std::string_view rest_of_line() const;

  TokenReader& tokens_;
  TextNames& names_;
  RoutineParser& routines_;
  std::optional<std::set<std::string>> labels_;  ///< after GOTO, in capitals, once asked for
};

}  // namespace rob::lang

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lang/machine/machine.h"

namespace rob::lang {

/// The calls that a machine was given, as text, and how it answers the next ones: Done, unless a
/// test asks for something else.
class CallLog {
 public:
  struct Call {
    int line = 0;  ///< of the source
    std::string text;
  };

  /// The next `times` calls are answered Later.
  void answer_later(int times) { later_ = times; }
  /// The call that comes after `calls` further ones is refused.
  void refuse_after(int calls) { refuse_after_ = calls; }

  /// The answer to a call, which is carried out where it is Done.
  Reply answer();
  /// The same; a call that is Done is written down.
  Reply note(int line, std::string text);
  void write(int line, std::string text) { calls_.push_back({line, std::move(text)}); }

  const std::vector<Call>& calls() const { return calls_; }
  std::vector<std::string> texts() const;

 private:
  std::vector<Call> calls_;
  int later_ = 0;
  std::optional<int> refuse_after_;
};

}  // namespace rob::lang

#include "lang/compile/open_blocks.h"

#include <algorithm>
#include <utility>

namespace rob::lang {
namespace {

using Kind = OpenScopes::Kind;

Opcode leaving(Kind kind) {
  switch (kind) {
    case Kind::Try:
      return Opcode::leave_try;
    case Kind::Rescue:
      return Opcode::leave_rescue;
    case Kind::With:
      return Opcode::end_with;
    case Kind::Press:
      break;
  }
  return Opcode::end_press;
}

bool is_guard(Kind kind) { return kind == Kind::Try || kind == Kind::Rescue; }

}  // namespace

void OpenScopes::enter_loop() {
  loops_.push_back({.exits = {},
                    .nexts = {},
                    .whens = whens_,
                    .guards = guards_.size(),
                    .scopes = scopes_.size()});
}

void OpenScopes::leave_loop() {
  code_.land(loops_.back().exits);
  loops_.pop_back();
}

void OpenScopes::exit_loop(Place place) {
  leave_loop_body(place);
  loops_.back().exits.push_back(code_.jump(place));
}

void OpenScopes::next_turn(Place place) {
  leave_loop_body(place);
  loops_.back().nexts.push_back(code_.jump(place));
}

void OpenScopes::leave_loop_body(Place place) {
  leave_whens(loops_.back().whens, place);
  leave_guards(loops_.back().guards, place);
  leave_scopes(loops_.back().scopes, place);
}

void OpenScopes::armed(std::size_t whens) { whens_ = std::max(whens_, whens); }

void OpenScopes::disarm_inner(Place place) {
  code_.emit(Instruction::ax(Opcode::disarm, 0, static_cast<std::uint16_t>(whens_)), place);
}

void OpenScopes::leave_whens(std::size_t kept, Place place) {
  if (whens_ == kept) return;
  code_.emit(Instruction::ax(Opcode::disarm, 0, static_cast<std::uint16_t>(kept)), place);
}

void OpenScopes::close_whens(std::size_t kept, Place place) {
  leave_whens(kept, place);
  whens_ = kept;
}

void OpenScopes::open(Kind kind) { (is_guard(kind) ? guards_ : scopes_).push_back(kind); }

void OpenScopes::close(Kind kind, Place place) {
  code_.emit(leaving(kind), place);
  (is_guard(kind) ? guards_ : scopes_).pop_back();
}

void OpenScopes::leave_guards(std::size_t kept, Place place) {
  for (std::size_t i = guards_.size(); i > kept; --i) code_.emit(leaving(guards_[i - 1]), place);
}

void OpenScopes::leave_scopes(std::size_t kept, Place place) {
  for (std::size_t i = scopes_.size(); i > kept; --i) code_.emit(leaving(scopes_[i - 1]), place);
}

void OpenScopes::leave_routine(Place place) {
  leave_whens(0, place);
  leave_guards(0, place);
  leave_scopes(0, place);
}

void OpenScopes::leave_program(Place place) {
  leave_guards(0, place);
  leave_scopes(0, place);
  returns_.push_back(code_.jump(place));
}

}  // namespace rob::lang

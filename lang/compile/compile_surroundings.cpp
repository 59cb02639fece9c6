#include <utility>

#include "lang/compile/statement_compiler.h"
#include "lang/values/pose_slots.h"

/// Member functions of StatementCompiler for WITH, IN, PATH, PRESS, OVERRIDE and LOAD.
namespace rob::lang {

void StatementCompiler::enter(const Surroundings& surroundings) {
  if (surroundings.none()) return;
  constexpr unsigned kTool = 1;
  constexpr unsigned kFrame = 2;
  constexpr unsigned kInTool = 4;
  const Place place = place_;
  const auto mark = code_.mark();
  const int slots = (surroundings.tool != nullptr ? kToolSlots : 0) +
                    (surroundings.frame != nullptr ? kPoseSlots : 0);
  const Register first = code_.number_registers(slots);
  Register next = first;
  unsigned parts = surroundings.in_tool ? kInTool : 0;
  if (surroundings.tool != nullptr) {
    expressions_.value_into(*surroundings.tool, next);
    next = static_cast<Register>(next + kToolSlots);
    parts |= kTool;
  }
  if (surroundings.frame != nullptr) {
    expressions_.value_into(*surroundings.frame, next);
    parts |= kFrame;
  }
  code_.emit(Opcode::with, place, first, parts);
  code_.release(mark);
  scopes_.push_back(Scope::With);
}

void StatementCompiler::leave(const Surroundings& surroundings, Place place) {
  if (surroundings.none()) return;
  leave_scopes(scopes_.size() - 1, place);
  scopes_.pop_back();
}

void StatementCompiler::leave_scopes(std::size_t kept, Place place) {
  for (std::size_t i = scopes_.size(); i > kept; --i) {
    code_.emit(scopes_[i - 1] == Scope::With ? Opcode::end_with : Opcode::end_press, place);
  }
}

void StatementCompiler::compile(const With& with) {
  const Place place = place_;
  enter(with.surroundings);
  compile(with.body);
  leave(with.surroundings, place);
}

/// The clauses are evaluated once; their values are copied for the motions that have none.
void StatementCompiler::compile(const PathBlock& path) {
  const Place place = place_;
  enter(path.clauses.surroundings);
  const auto mark = code_.mark();
  for (std::size_t i = 0; i < kClauses; ++i) {
    if (path.clauses.values[i] == nullptr) continue;
    if (path.clauses.live && i == static_cast<std::size_t>(Clause::At)) continue;
    path_values_[i] = code_.number_registers();
    compile_clause(static_cast<Clause>(i), *path.clauses.values[i], path_values_[i]);
  }
  code_.emit(Opcode::begin_path, place);
  path_ = &path;
  compile(path.body);
  path_ = nullptr;
  code_.emit(Opcode::end_path, place);
  code_.release(mark);
  leave(path.clauses.surroundings, place);
}

/// IN is of the axis alone.
void StatementCompiler::compile(const Press& press) {
  const Place place = place_;
  const auto mark = code_.mark();
  const Register force = code_.number_registers(2);
  const auto limit = static_cast<Register>(force + 1);
  expressions_.value_into(*press.force, force);
  if (press.limit != nullptr) {
    expressions_.value_into(*press.limit, limit);
  } else {
    code_.load_real(limit, 0, kSpeed, place);
  }
  enter(press.surroundings);
  code_.emit(Opcode::press, place, force, static_cast<unsigned>(press.axis));
  leave(press.surroundings, place);
  code_.release(mark);
  scopes_.push_back(Scope::Press);
  compile(press.body);
  leave_scopes(scopes_.size() - 1, place);
  scopes_.pop_back();
}

void StatementCompiler::compile(const SetOverride& statement) {
  const auto mark = code_.mark();
  code_.emit(Opcode::set_override, place_, expressions_.value(*statement.share, true));
  code_.release(mark);
}

void StatementCompiler::compile(const Load& load) {
  constexpr int kMassAndCog = 4;
  const Place place = place_;
  const auto mark = code_.mark();
  const Register first = code_.number_registers(kMassAndCog);
  expressions_.value_into(*load.mass, first);
  if (load.cog != nullptr) expressions_.value_into(*load.cog, static_cast<Register>(first + 1));
  code_.emit(Opcode::carry, place, first, load.cog != nullptr ? 1U : 0U);
  code_.release(mark);
}

}  // namespace rob::lang

#include <algorithm>
#include <utility>

#include "lang/compile/statement_compiler.h"

/// Member functions of StatementCompiler for loops, SELECT and ASSERT.
namespace rob::lang {

void StatementCompiler::compile_body(const Block& body) {
  loops_.push_back({.exits = {},
                    .nexts = {},
                    .whens = whens_,
                    .guards = guards_.size(),
                    .scopes = scopes_.size()});
  compile(body);
  code_.land(loops_.back().nexts);
}

void StatementCompiler::leave_loop() {
  code_.land(loops_.back().exits);
  loops_.pop_back();
}

void StatementCompiler::compile(const Exit&) {
  leave_whens(loops_.back().whens);
  leave_guards(loops_.back().guards, place_);
  leave_scopes(loops_.back().scopes, place_);
  loops_.back().exits.push_back(code_.jump(place_));
}

void StatementCompiler::compile(const Next&) {
  leave_whens(loops_.back().whens);
  leave_guards(loops_.back().guards, place_);
  leave_scopes(loops_.back().scopes, place_);
  loops_.back().nexts.push_back(code_.jump(place_));
}

void StatementCompiler::compile(const While& loop) {
  const Place place = place_;
  const std::size_t top = code_.here();
  const CodeBuilder::Jumps exits = expressions_.jumps_if(*loop.condition, false);
  compile_body(loop.body);
  code_.loop(top, place);
  code_.land(exits);
  leave_loop();
}

/// The registers are laid out as opcodes.def says.
void StatementCompiler::compile(const For& loop) {
  const Place place = place_;
  const auto mark = code_.mark();
  const bool real = loop.symbol->type.kind == Type::Kind::Real;
  const Register value = declare_in_registers(*loop.symbol).numbers.reg();
  code_.number_registers(real ? 4 : 2);
  expressions_.value_into(*loop.from, value, real);
  expressions_.value_into(*loop.to, static_cast<Register>(value + 1), real);
  const auto step = static_cast<Register>(value + 2);
  if (loop.step != nullptr) {
    expressions_.value_into(*loop.step, step, real);
  } else if (real) {
    code_.load_real(step, 1, kNone, place);
  } else {
    code_.load_integer(step, 1, place);
  }
  code_.emit(real ? Opcode::for_prepare_real : Opcode::for_prepare_int, place, value);
  const CodeBuilder::Jump none = code_.jump(place);
  const std::size_t top = code_.here();
  compile_body(loop.body);
  if (!real) code_.join_turns(top, value);
  code_.emit(real ? Opcode::for_next_real : Opcode::for_next_int, place, value);
  code_.loop(top, place);
  code_.land(none);
  leave_loop();
  code_.release(mark);
}

void StatementCompiler::compile(const Loop& loop) {
  const Place place = place_;
  const std::size_t top = code_.here();
  compile_body(loop.body);
  code_.loop(top, place);
  leave_loop();
}

/// The value is computed once, into a register of its own: a CASE may call what changes it.
void StatementCompiler::compile(const Select& select) {
  const auto real_value = [](const ExprPtr& value) { return value->type.kind == Type::Kind::Real; };
  const bool real = real_value(select.selector) ||
                    std::ranges::any_of(select.cases, [&](const Select::Case& one) {
                      return std::ranges::any_of(one.values, real_value);
                    });
  const auto mark = code_.mark();
  const bool text = select.selector->type.kind == Type::Kind::String;
  const Register selector = text ? code_.text_register() : code_.number_registers();
  expressions_.value_into(*select.selector, selector, real);
  CodeBuilder::Jumps done;
  for (const Select::Case& one : select.cases) {
    CodeBuilder::Jumps matches;
    for (const ExprPtr& value : one.values) {
      matches.push_back(expressions_.jump_if_equal(selector, *value, real));
    }
    const CodeBuilder::Jump otherwise = code_.jump(one.place);
    code_.land(matches);
    compile(one.body);
    done.push_back(code_.jump(one.place));
    code_.land(otherwise);
  }
  compile(select.otherwise);
  code_.land(done);
  code_.release(mark);
}

void StatementCompiler::compile(const Assert& assertion) {
  const Place place = place_;
  const CodeBuilder::Jumps holds = expressions_.jumps_if(*assertion.condition, true);
  code_.fail_assertion(assertion.text, place);
  code_.land(holds);
}

}  // namespace rob::lang

#include "lang/compile/statement_compiler.h"

/// Member functions of StatementCompiler for TRY and RAISE.
namespace rob::lang {

/// The register of the reason is taken before the body, which thus cannot use it.
void StatementCompiler::compile(const Try& statement) {
  const Place place = place_;
  const auto mark = code_.mark();
  const Register why = code_.text_register();
  code_.emit(Opcode::open_try, place, why);
  const CodeBuilder::Jump failed = code_.jump(place);
  guards_.push_back(Guard::Try);
  compile(statement.body);
  leave_guards(guards_.size() - 1, place);
  const CodeBuilder::Jump done = code_.jump(place);
  guards_.back() = Guard::Rescue;
  code_.land(failed);
  // What was armed inside, in routines that were called too, is left with the block.
  code_.emit(Instruction::ax(Opcode::disarm, 0, static_cast<std::uint16_t>(whens_)), place);
  if (statement.why.symbol != nullptr) {
    Location home;
    home.texts.offset = why;
    name_home(*statement.why.symbol, home);
    expressions_.settle(*statement.why.symbol, home);
  }
  compile(statement.rescue);
  leave_guards(guards_.size() - 1, place);
  guards_.pop_back();
  code_.land(done);
  code_.release(mark);
}

void StatementCompiler::leave_guards(std::size_t kept, Place place) {
  for (std::size_t i = guards_.size(); i > kept; --i) {
    code_.emit(guards_[i - 1] == Guard::Try ? Opcode::leave_try : Opcode::leave_rescue, place);
  }
}

void StatementCompiler::compile(const Raise& statement) {
  const Place place = place_;
  if (statement.value == nullptr) return code_.emit(Opcode::raise_again, place);
  const auto mark = code_.mark();
  code_.emit(Opcode::raise, place, expressions_.value(*statement.value));
  code_.release(mark);
}

}  // namespace rob::lang

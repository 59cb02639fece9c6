#include "lang/compile/expression_compiler.h"

/// Member functions of ExpressionCompiler for signals. The program has quantities, the channel
/// volts.
namespace rob::lang {
namespace {

bool in_volts(const Symbol& symbol) { return symbol.low == 0 && symbol.high == kMostVolts; }

/// What one volt stands for.
double per_volt(const Symbol& symbol) { return (symbol.high - symbol.low) / kMostVolts; }

Instruction on_channel(Opcode op, Register reg, const Symbol& symbol) {
  return Instruction::ax(op, reg, static_cast<std::uint16_t>(symbol.signal));
}

}  // namespace

void ExpressionCompiler::read_signal(const Symbol& symbol, Register target, Place place) {
  code_.uses_signal(place);
  if (!symbol.analog) {
    const Opcode op = latched_ ? Opcode::read_latched : Opcode::read_signal;
    return code_.emit(on_channel(op, target, symbol), place);
  }
  const Opcode op = latched_ ? Opcode::read_analog_latched : Opcode::read_analog;
  code_.emit(on_channel(op, target, symbol), place);
  if (in_volts(symbol)) return;
  const auto mark = code_.mark();
  const Register scale = code_.number_registers();
  code_.load_real(scale, per_volt(symbol), symbol.type.dimension / kVoltage, place);
  code_.emit(Opcode::mul_real, place, target, target, scale);
  if (symbol.low != 0) {
    code_.load_real(scale, symbol.low, symbol.type.dimension, place);
    code_.emit(Opcode::add_real, place, target, target, scale);
  }
  code_.release(mark);
}

void ExpressionCompiler::to_volts(const Symbol& symbol, Register value, Register volts,
                                  Place place) {
  const auto mark = code_.mark();
  const Register scale = code_.number_registers();
  code_.load_real(scale, symbol.low, symbol.type.dimension, place);
  code_.emit(Opcode::sub_real, place, volts, value, scale);
  code_.load_real(scale, per_volt(symbol), symbol.type.dimension / kVoltage, place);
  code_.emit(Opcode::quot_real, place, volts, volts, scale);
  code_.release(mark);
}

void ExpressionCompiler::write_signal(const Symbol& symbol, Register value, Place place) {
  code_.uses_signal(place);
  if (!symbol.analog) return code_.emit(on_channel(Opcode::write_signal, value, symbol), place);
  if (in_volts(symbol)) return code_.emit(on_channel(Opcode::write_analog, value, symbol), place);
  const auto mark = code_.mark();
  const Register volts = code_.number_registers();
  to_volts(symbol, value, volts, place);
  code_.emit(on_channel(Opcode::write_analog, volts, symbol), place);
  code_.release(mark);
}

void ExpressionCompiler::simulate(const Symbol& symbol, Register value, Place place) {
  if (symbol.analog && !in_volts(symbol)) to_volts(symbol, value, value, place);
  code_.emit(on_channel(symbol.analog ? Opcode::simulate_analog : Opcode::simulate, value, symbol),
             place);
}

}  // namespace rob::lang

#include "lang/compile/world_code.h"

namespace rob::lang {
namespace {

bool in_volts(const Symbol& symbol) { return symbol.low == 0 && symbol.high == kMostVolts; }

/// The quantity that one volt stands for.
double per_volt(const Symbol& symbol) { return (symbol.high - symbol.low) / kMostVolts; }

Instruction on_channel(Opcode op, Register reg, const Symbol& symbol) {
  return Instruction::ax(op, reg, static_cast<std::uint16_t>(symbol.signal));
}

}  // namespace

void WorldCode::begin(int observations, Place place) {
  latched_ = observations > 1;
  if (latched_) code_.emit(Opcode::latch, place);
}

void WorldCode::begin_again(Place place) {
  if (latched_) code_.emit(Opcode::latch, place);
}

void WorldCode::read(Reading reading, Register target, Place place) {
  const bool time =
      reading == Reading::Clock || reading == Reading::Unix || reading == Reading::Now;
  if (time) code_.depends_on_time();
  code_.emit(Opcode::read, place, target, static_cast<unsigned>(reading), latched_ ? 1 : 0);
}

void WorldCode::now(const Builtin& function, Register target, Place place) {
  const auto mark = code_.frame().mark();
  const Register numbers = code_.frame().number_registers(slots_of(Reading::Now, 0));
  read(Reading::Now, numbers, place);
  const Register text = code_.frame().text_register();
  const auto index = static_cast<unsigned>(&function - builtins().data());
  code_.emit(Opcode::call_text, place, numbers, text, index);
  code_.emit(Opcode::copy_text, place, target, text);
  code_.frame().release(mark);
}

void WorldCode::read_signal(const Symbol& symbol, Register target, Place place) {
  code_.uses_signal(place);
  if (symbol.group > 0) {
    return on_group(latched_ ? Opcode::read_group_latched : Opcode::read_group, target, symbol,
                    place);
  }
  if (!symbol.analog) {
    const Opcode op = latched_ ? Opcode::read_latched : Opcode::read_signal;
    return code_.emit(on_channel(op, target, symbol), place);
  }
  const Opcode op = latched_ ? Opcode::read_analog_latched : Opcode::read_analog;
  code_.emit(on_channel(op, target, symbol), place);
  if (in_volts(symbol)) return;
  const auto mark = code_.frame().mark();
  const Register scale = code_.frame().number_registers();
  code_.load_real(scale, per_volt(symbol), symbol.type.dimension / kVoltage, place);
  code_.emit(Opcode::mul_real, place, target, target, scale);
  if (symbol.low != 0) {
    code_.load_real(scale, symbol.low, symbol.type.dimension, place);
    code_.emit(Opcode::add_real, place, target, target, scale);
  }
  code_.frame().release(mark);
}

void WorldCode::look_for_file(Register file, Register target, Place place) {
  code_.emit(Opcode::exists, place, target, file, latched_ ? 1 : 0);
}

void WorldCode::on_group(Opcode op, Register value, const Symbol& symbol, Place place) {
  code_.emit(on_channel(op, value, symbol), place);
  code_.emit(Instruction{static_cast<std::uint32_t>(symbol.group)}, place);
}

void WorldCode::write_signal(const Symbol& symbol, Register value, Place place) {
  code_.uses_signal(place);
  if (symbol.group > 0) return on_group(Opcode::write_group, value, symbol, place);
  if (!symbol.analog) return code_.emit(on_channel(Opcode::write_signal, value, symbol), place);
  if (in_volts(symbol)) return code_.emit(on_channel(Opcode::write_analog, value, symbol), place);
  const auto mark = code_.frame().mark();
  const Register volts = code_.frame().number_registers();
  to_volts(symbol, value, volts, place);
  code_.emit(on_channel(Opcode::write_analog, volts, symbol), place);
  code_.frame().release(mark);
}

void WorldCode::pulse(const Symbol& symbol, Register time, Place place) {
  code_.depends_on_time();
  code_.emit(on_channel(Opcode::pulse, time, symbol), place);
}

void WorldCode::simulate(const Symbol& symbol, Register value, Place place) {
  if (symbol.group > 0) return on_group(Opcode::simulate_group, value, symbol, place);
  if (symbol.analog && !in_volts(symbol)) to_volts(symbol, value, value, place);
  code_.emit(on_channel(symbol.analog ? Opcode::simulate_analog : Opcode::simulate, value, symbol),
             place);
}

void WorldCode::simulate_force(int component, Register value, Place place) {
  code_.emit(Opcode::simulate_force, place, value, static_cast<unsigned>(component));
}

void WorldCode::to_volts(const Symbol& symbol, Register value, Register volts, Place place) {
  const auto mark = code_.frame().mark();
  const Register scale = code_.frame().number_registers();
  code_.load_real(scale, symbol.low, symbol.type.dimension, place);
  code_.emit(Opcode::sub_real, place, volts, value, scale);
  code_.load_real(scale, per_volt(symbol), symbol.type.dimension / kVoltage, place);
  code_.emit(Opcode::quot_real, place, volts, volts, scale);
  code_.frame().release(mark);
}

}  // namespace rob::lang

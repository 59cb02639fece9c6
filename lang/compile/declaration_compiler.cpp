#include "lang/compile/declaration_compiler.h"

#include <string>

#include "lang/check/fold.h"
#include "lang/compile/operations.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {

void DeclarationCompiler::know(const Symbol& symbol, const KeptName& kept) {
  variables_.settle(symbol, kept.home);
  name_constant(symbol);
  if (symbol.kind == Symbol::Kind::Signal) name_signal(symbol);
  if (kept.safe) code_.declare_safe(*kept.safe);
}

Location DeclarationCompiler::declare(const Symbol& symbol) {
  const Slots slots = slots_of(symbol.type);
  if (!symbol.type.in_registers() || (frame_.has_memory() && !frame_.has_room(slots))) {
    const Location home = symbol.type.in_registers()
                              ? variables_.memory(slots, symbol.place)
                              : variables_.temporary(symbol.type, symbol.place);
    variables_.settle(symbol, home);
    return home;
  }
  return declare_in_registers(symbol);
}

Location DeclarationCompiler::declare_in_registers(const Symbol& symbol) {
  const Slots slots = slots_of(symbol.type);
  Location home;
  if (slots.numbers > 0) home.numbers.offset = frame_.number_registers(slots.numbers);
  if (slots.texts > 0) home.texts.offset = frame_.text_registers(slots.texts);
  name_home(symbol, home);
  variables_.settle(symbol, home);
  return home;
}

/// Reports call a TOOL by its name.
void DeclarationCompiler::name_constant(const Symbol& symbol) {
  if (symbol.kind != Symbol::Kind::NamedConstant || !symbol.type.is(Type::Kind::Tool)) return;
  const std::vector<Slot> slots = to_slots(symbol.value);
  code_.name_tool({symbol.name, to_si(lang::load_pose(slots.data()))},
                  lang::load_tool(slots.data()).shape.front().radius > 0);
}

/// And a channel by that of its SIGNAL.
void DeclarationCompiler::name_signal(const Symbol& symbol) {
  code_.name_signal({.name = symbol.name,
                     .signal = symbol.signal,
                     .dimension = symbol.type.dimension,
                     .low = symbol.low,
                     .high = symbol.high});
}

void DeclarationCompiler::name_home(const Symbol& symbol, const Location& home) {
  if (symbol.name.empty()) return;
  const bool text = symbol.type.text();
  frame_.name_register(symbol.name, text ? home.texts.reg() : home.numbers.reg(), text);
}

void DeclarationCompiler::compile(const Declaration& declaration, Place place) {
  const Symbol& first = *declaration.names.front().symbol;
  name_constant(first);
  // Constants that are known live in the code.
  if (declaration.constant && known(first.value)) return;
  const Location home = declare(first);
  if (declaration.value != nullptr) {
    expressions_.initialise(*declaration.value, home, first.type);
  } else {
    variables_.clear(home, first.type, place);
  }
  for (std::size_t i = 1; i < declaration.names.size(); ++i) {
    const Location other = declare(*declaration.names[i].symbol);
    variables_.copy(home, other, first.type, place);
  }
  for (const Declaration::Declared& declared : declaration.names) {
    restore(*declared.symbol);
    variables_.publish(*declared.symbol, place);
  }
}

/// The value that an earlier run has left counts, and not that in the program.
void DeclarationCompiler::restore(const Symbol& symbol) {
  if (symbol.persist < 0) return;
  const auto [numbers, texts] = variables_.places(symbol);
  code_.declare_persist(symbol.persist, {symbol.name, symbol.type, symbol.place, numbers, texts});
}

void DeclarationCompiler::compile(const SignalDeclaration& signal) {
  name_signal(*signal.symbol);
  if (signal.safe == nullptr) return;
  code_.declare_safe({signal.symbol->signal, signal.safe_value, line_tag(signal.name_place)});
}

void DeclarationCompiler::load_pose(const PoseValue& pose, Register first, Place place) {
  const auto& [p, q] = pose;
  for (const double part : {p.x, p.y, p.z, q.w, q.i, q.j, q.k}) {
    code_.load_real(first++, part, kNone, place);
  }
}

/// A point without any value is only foretold, or taught before it is used.
void DeclarationCompiler::compile(const PointDeclaration& declaration, Place place) {
  for (const PointDeclaration::Point& point : declaration.points) {
    const Symbol& symbol = *point.declared.symbol;
    if (known(symbol.value)) continue;
    const Location home = declare(symbol);
    if (point.kept || declaration.value == nullptr) {
      const auto mark = frame_.mark();
      const Register pose = frame_.number_registers(kPoseSlots);
      load_pose(point.kept.value_or(PoseValue{}), pose, place);
      variables_.store_variable(symbol, pose, place);
      frame_.release(mark);
    } else {
      expressions_.initialise(*declaration.value, home, symbol.type);
      variables_.publish(symbol, place);
    }
    if (symbol.moved_to && symbol.taught != nullptr) keep_joints(symbol, place);
  }
}

/// A barrier, then HERE; the running copy changes only where the point could be kept.
void DeclarationCompiler::compile(const Teach& teach, Place place) {
  const Symbol& symbol = *teach.target.symbol;
  const auto mark = frame_.mark();
  const Register pose = frame_.number_registers(kPoseSlots);
  code_.emit(Opcode::stop, place);
  code_.emit(Opcode::read, place, pose, static_cast<unsigned>(Reading::Here));
  std::string frame;
  if (const Symbol* const in = teach.frame; in != nullptr) {
    frame = in->name;
    const PoseValue world_t_frame = lang::load_pose(to_slots(in->value).data());
    const Register inverse = frame_.number_registers(kPoseSlots);
    load_pose(pose_math::inverse(world_t_frame), inverse, place);
    code_.emit(Opcode::pose_product, place, pose, inverse, pose);
  }
  const int axes = symbol.moved_to ? static_cast<int>(robot_.axes.size()) : 0;
  const Register joints = symbol.moved_to ? frame_.number_registers(axes) : pose;
  // At the standstill of TEACH the axes are where HERE was read.
  if (symbol.moved_to)
    code_.emit(Opcode::read, place, joints, static_cast<unsigned>(Reading::Joints));
  code_.teach(pose, joints, axes, symbol.name, frame, place);
  variables_.store_variable(symbol, pose, place);
  if (symbol.moved_to) keep_taught_joints(symbol, joints, place);
  frame_.release(mark);
}

/// The joints of a point that TEACH may change: at first those of the points file, if it has them.
void DeclarationCompiler::keep_joints(const Symbol& point, Place place) {
  declare(*point.taught);
  declare(*point.has_taught);
  const auto mark = frame_.mark();
  const Register known = frame_.number_registers();
  code_.load_integer(known, point.joints.empty() ? 0 : 1, place);
  variables_.store_variable(*point.has_taught, known, place);
  const Register joints = frame_.number_registers(static_cast<int>(robot_.axes.size()));
  load_joints(code_, point, robot_, joints, place);
  if (!point.joints.empty()) variables_.store_variable(*point.taught, joints, place);
  frame_.release(mark);
}

void DeclarationCompiler::keep_taught_joints(const Symbol& point, Register joints, Place place) {
  variables_.store_variable(*point.taught, joints, place);
  const Register known = frame_.number_registers();
  code_.load_integer(known, 1, place);
  variables_.store_variable(*point.has_taught, known, place);
}

void DeclarationCompiler::compile(const DeviceDeclaration& device) {
  const auto* const ending =
      device.ending == nullptr ? nullptr : std::get_if<std::string>(&device.ending->constant);
  code_.declare_device(device.declared.symbol->device,
                       {device.declared.name, std::get<std::string>(device.address->constant),
                        ending == nullptr ? "\n" : *ending, device.declared.place});
}

}  // namespace rob::lang

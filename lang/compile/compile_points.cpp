#include "lang/check/fold.h"
#include "lang/compile/statement_compiler.h"
#include "lang/values/pose_slots.h"

/// Member functions of StatementCompiler for POINT and TEACH.
namespace rob::lang {

void StatementCompiler::load_pose(const PoseValue& pose, Register first, Place place) {
  const auto& [p, q] = pose;
  for (const double part : {p.x, p.y, p.z, q.w, q.i, q.j, q.k}) {
    code_.load_real(first++, part, kNone, place);
  }
}

/// A point without any value is only foretold, or taught before it is used.
void StatementCompiler::compile(const PointDeclaration& declaration) {
  for (const PointDeclaration::Point& point : declaration.points) {
    const Symbol& symbol = *point.declared.symbol;
    if (known(symbol.value)) continue;
    const Location home = declare(symbol);
    if (point.kept || declaration.value == nullptr) {
      const auto mark = code_.mark();
      const Register pose = code_.number_registers(kPoseSlots);
      load_pose(point.kept.value_or(PoseValue{}), pose, place_);
      expressions_.store_variable(symbol, pose, place_);
      code_.release(mark);
    } else {
      expressions_.initialise(*declaration.value, home, symbol.type);
      publish(symbol, place_);
    }
    if (symbol.moved_to && symbol.taught != nullptr) keep_joints(symbol);
  }
}

/// A barrier, then HERE; the running copy changes only where the point could be kept.
void StatementCompiler::compile(const Teach& teach) {
  const Symbol& symbol = *teach.target.symbol;
  const auto mark = code_.mark();
  const Register pose = code_.number_registers(kPoseSlots);
  code_.emit(Opcode::stop, place_);
  code_.emit(Opcode::read, place_, pose, static_cast<unsigned>(Reading::Here));
  std::string frame;
  if (const Symbol* const in = teach.frame; in != nullptr) {
    frame = in->name;
    const PoseValue world_t_frame = lang::load_pose(to_slots(in->value).data());
    const Register inverse = code_.number_registers(kPoseSlots);
    load_pose(pose_math::inverse(world_t_frame), inverse, place_);
    code_.emit(Opcode::pose_product, place_, pose, inverse, pose);
  }
  code_.teach(pose, symbol.name, frame, place_);
  expressions_.store_variable(symbol, pose, place_);
  if (symbol.moved_to) teach_joints(symbol);
  code_.release(mark);
}

/// The joints of a point that TEACH may change: at first those of the points file, if it has them.
void StatementCompiler::keep_joints(const Symbol& point) {
  declare(*point.taught);
  declare(*point.has_taught);
  const auto mark = code_.mark();
  const Register known = code_.number_registers();
  code_.load_integer(known, point.joints.empty() ? 0 : 1, place_);
  expressions_.store_variable(*point.has_taught, known, place_);
  const Register joints = code_.number_registers(static_cast<int>(robot_.axes.size()));
  for (std::size_t i = 0; i < point.joints.size(); ++i) {
    code_.load_real(static_cast<Register>(joints + i), point.joints[i], robot_.axes[i].dimension,
                    place_);
  }
  if (!point.joints.empty()) expressions_.store_variable(*point.taught, joints, place_);
  code_.release(mark);
}

/// At the standstill of TEACH the axes are where HERE was read.
void StatementCompiler::teach_joints(const Symbol& point) {
  const Register joints = code_.number_registers(static_cast<int>(robot_.axes.size()));
  code_.emit(Opcode::read, place_, joints, static_cast<unsigned>(Reading::Joints));
  expressions_.store_variable(*point.taught, joints, place_);
  const Register known = code_.number_registers();
  code_.load_integer(known, 1, place_);
  expressions_.store_variable(*point.has_taught, known, place_);
}

}  // namespace rob::lang

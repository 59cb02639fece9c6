#include "lang/fold.h"
#include "lang/pose_slots.h"
#include "lang/statement_compiler.h"

/// The part of StatementCompiler that knows POINT and TEACH.
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
      load_pose(point.kept.value_or(PoseValue{}), home.numbers.reg(), place_);
    } else {
      expressions_.value_into(*declaration.value, home.numbers.reg());
    }
    publish(symbol, place_);
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
  expressions_.store_point(symbol, pose, place_);
  code_.release(mark);
}

}  // namespace rob::lang

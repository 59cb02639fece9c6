#include <string>

#include <fmt/core.h>

#include "lang/check/expression_checker.h"
#include "lang/text/codes.h"
#include "lang/values/pose_functions.h"
#include "lang/values/pose_slots.h"

/// Member functions of ExpressionChecker for poses: their frames, what can be computed with them,
/// and their angles.
namespace rob::lang {
namespace {

using Compound = std::vector<double>;

bool is_length_vector(const Type& type) { return type == Type::vec(kLength); }

std::string frame_words(const Type& type) { return fmt::format("IN {}", frame_name(type)); }

Folded made(ArithmeticError error, const std::vector<Slot>& slots, int count) {
  if (error != ArithmeticError::None) return {error, {}};
  Compound compound;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    compound.push_back(slots[i].real);
  return {error, compound};
}

/// p + v, p - v, p - q: the place alone, part by part as the Vm does it.
Folded fold_sum(BinaryOp op, const Compound& a, const Compound& b, bool pose) {
  Compound result = a;
  for (std::size_t i = 0; i < 3; ++i) {
    const ArithmeticError error = op == BinaryOp::Add ? arithmetic::add(a[i], b[i], result[i])
                                                      : arithmetic::subtract(a[i], b[i], result[i]);
    if (error != ArithmeticError::None) return {error, {}};
  }
  result.resize(pose ? kPoseSlots : 3);
  return {ArithmeticError::None, result};
}

}  // namespace

/// The frame that two poses share; a free one takes the other's. Unknown, and a message, if they
/// are in two.
Type ExpressionChecker::common_frame(const Expr& left, const Expr& right, std::string_view what) {
  const Type a = as_pose(left.type);
  const Type b = as_pose(right.type);
  if (is_free(a)) return b;
  if (is_free(b) || a == b) return a;
  diagnostics_.error(code::kFrames, right.place,
                     fmt::format("{} needs poses in one frame; these are {} and {}", what,
                                 frame_words(a), frame_words(b)),
                     "TO_FRAME(p, f) gives the same place in another frame");
  return {};
}

Type ExpressionChecker::check_place_sum(const Binary& binary, const Expr& expression) {
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  if (left.is_place() && is_length_vector(right)) return as_pose(left);
  if (left.is_place() && right.is_place() && binary.op == BinaryOp::Subtract) {
    return common_frame(*binary.left, *binary.right, "'-'").known() ? Type::vec(kLength) : Type{};
  }
  const bool bare = right.is(Type::Kind::Vec) && right.dimension.none();
  std::string help = "p + (0mm, 0mm, 60mm) shifts a pose; p * q composes two";
  if (bare) help = "write the units, as in p + (0mm, 0mm, 60mm)";
  diagnostics_.error(
      code::kPoseOperands, expression.place,
      fmt::format("'{}' shifts a pose by a VEC of lengths; left is {}, right is {}",
                  symbol_of(binary.op), described(*binary.left), described(*binary.right)),
      help);
  return {};
}

/// What stands on the right is seen from the left, so it has no frame of its own but the world,
/// which stands for none.
Type ExpressionChecker::check_place_product(const Binary& binary, const Expr& expression) {
  const Type& left = binary.left->type;
  const Type& right = binary.right->type;
  if (left.is_place() && is_length_vector(right)) return right;
  if (!left.is_place() || !right.is_place()) {
    diagnostics_.error(
        code::kPoseOperands, expression.place,
        fmt::format("'*' composes a pose with a pose or a VEC of lengths; left is {}, right is {}",
                    described(*binary.left), described(*binary.right)),
        "p + v shifts along the axes of the frame, p * v along those of the pose");
    return {};
  }
  const Type offset = as_pose(right);
  if (is_free(offset) || offset == Type::pose()) return as_pose(left);
  diagnostics_.error(
      code::kFrames, binary.right->place,
      fmt::format("'*' adds what is seen from the left pose, {}; the right one is {}",
                  frame_words(as_pose(left)), frame_words(offset)),
      "TO_FRAME(p, f) gives the same place in another frame");
  return {};
}

Folded ExpressionChecker::fold_places(const Binary& binary) const {
  const auto* const a = std::get_if<Compound>(&binary.left->constant);
  const auto* const b = std::get_if<Compound>(&binary.right->constant);
  if (a == nullptr || b == nullptr) return {};
  if (binary.op != BinaryOp::Multiply) {
    return fold_sum(binary.op, *a, *b, binary.right->type.is(Type::Kind::Vec));
  }
  const std::vector<Slot> p = to_slots(binary.left->constant);
  const std::vector<Slot> q = to_slots(binary.right->constant);
  std::vector<Slot> result(kPoseSlots);
  if (binary.right->type.is_place()) {
    return made(pose_functions::product(p.data(), q.data(), result.data()), result, kPoseSlots);
  }
  return made(pose_functions::transformed(p.data(), q.data(), result.data()), result, 3);
}

/// p.a, p.b, p.c: computed, since they do not lie in the pose.
Type ExpressionChecker::check_angle(const Member& member, int which, Expr& expression) {
  if (known(member.object->constant)) {
    Slot angle{};
    pose_functions::angle(to_slots(member.object->constant).data(), which, angle);
    expression.constant = angle.real;
  }
  return Type::real(kAngle);
}

/// What a function of poses takes and gives, by its signature (builtins.def).
Type ExpressionChecker::check_places(const Builtin& builtin, const Call& call) {
  const std::string needs = fmt::format("{} needs", builtin.name);
  const Expr* first_pose = nullptr;
  Type frame = free_pose();
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const Expr& argument = *call.arguments[i];
    switch (builtin.signature.parameters[i]) {
      case 'L':
        if (!accept(argument, Type::real(kLength), needs)) return {};
        break;
      case 'A':
        if (!accept(argument, Type::real(kAngle), needs)) return {};
        break;
      case 'R':
        if (!accept(argument, Type::real(), needs)) return {};
        break;
      case 'V':
        if (!accept(argument, Type::vec(kLength), needs)) return {};
        break;
      default:
        if (!argument.type.is_place()) {
          diagnostics_.error(code::kTypeMismatch, argument.place,
                             fmt::format("{} a pose here; this is {}", needs, described(argument)),
                             "for example POSE(10mm, 20mm, 0mm)");
          return {};
        }
        if (argument.type.is(Type::Kind::Tool)) argument.place_slots = kPoseSlots;
        if (first_pose == nullptr) first_pose = &argument;
        if (const Type common = common_frame(*first_pose, argument, builtin.name); common.known()) {
          if (is_free(frame)) frame = common;
        } else {
          return {};
        }
    }
  }
  switch (builtin.signature.result) {
    case 'L':
      return Type::real(kLength);
    case 'A':
      return Type::real(kAngle);
    case 'P':
      return frame;
    default:
      return free_pose();
  }
}

}  // namespace rob::lang

#pragma once

#include <span>

#include "lang/values/arithmetic.h"

/// The built-in functions on poses, on slots (pose_slots.h): the geometry is that of pose_math.h.
/// The arguments' slots lie in a row, and are all read before the first of the result is written.
namespace rob::lang::pose_functions {

using Error = ArithmeticError;
using Arguments = std::span<const Slot>;

Error pose_of(Arguments a, Slot& r);       ///< POSE(x, y, z [, a, b, c])
Error pose_at(Arguments a, Slot& r);       ///< POSE(v, p): place v, orientation of p
Error pose_of_zyz(Arguments a, Slot& r);   ///< ZYZ(x, y, z, alpha, beta, gamma)
Error pose_of_quat(Arguments a, Slot& r);  ///< QUAT(x, y, z, w, i, j, k): ZeroQuaternion
Error inverse_of(Arguments a, Slot& r);    ///< INV(p)
Error pose_distance(Arguments a, Slot& r);
Error pose_turn(Arguments a, Slot& r);
Error pose_mix(Arguments a, Slot& r);     ///< MIX(p, q, t): OppositePoses
Error seen_from(Arguments a, Slot& r);    ///< TO_FRAME(p, f), both in the world
Error frame_three(Arguments a, Slot& r);  ///< FRAME3(origin, on_x, on_xy): CollinearPlaces

/// TOOL4(p, q, r, s …): the tool whose tip stays in one place in all of the poses of the flange, by
/// least squares; TOOLMISS the root mean square of how far it does not. ToolNotTurned
Error tool_four(Arguments a, Slot& r);
Error tool_miss(Arguments a, Slot& r);

/// p * q, in the way that the processor at hand has; all ways give the same bits.
extern Error (*const product)(const Slot* p, const Slot* q, Slot* result);
Error product_in_pairs(const Slot* p, const Slot* q, Slot* result);
#if defined(__x86_64__)
Error product_in_fours(const Slot* p, const Slot* q, Slot* result);  ///< needs AVX2
#endif
/// p * v, and the angle a, b or c (0, 1, 2) of p.
Error transformed(const Slot* p, const Slot* v, Slot* result);
void angle(const Slot* p, int which, Slot& result);

}  // namespace rob::lang::pose_functions

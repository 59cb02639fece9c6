#include "motion/generate/effect_order.h"

namespace rob::motion {

/// A WHEN whose block the program has left is disarmed in any case.
void EffectOrder::report(const Effect& effect, bool dropped, double time) noexcept {
  using EventKind = MotionEvent::Kind;
  if (effect.kind == Effect::Kind::Disarm) watches_.disarm(*effect.watched);
  if (effect.kind == Effect::Kind::Arm && !dropped) watches_.arm(*effect.watched);
  events_.report({.kind = dropped ? EventKind::EffectDropped : EventKind::EffectDue,
                  .time = time,
                  .tag = effect.tag,
                  .effect = effect});
}

}  // namespace rob::motion

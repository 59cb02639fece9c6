#pragma once

#include <cstdint>

#include "runtime/command/effect_queue.h"
#include "runtime/command/robot_links.h"

namespace rob::runtime {

/// How what was commanded ends, and how far it has come: what a program waits for. Program and
/// motion share the numbers of segments and the count of effects.
class CommandedProgress {
 public:
  CommandedProgress(const RobotLinks& links, const EffectQueue& effects)
      : links_(links), effects_(effects) {}

  /// `segment` is commanded after all else.
  void follow(const motion::SegmentDescriptor& segment);
  /// The axes stand, or will, at the last target.
  void stand() {
    exact_ = true;
    jogging_ = false;
  }
  /// The last command ends at standstill.
  bool exact() const { return exact_; }
  void set_exact(bool exact) { exact_ = exact; }
  /// It is a jog, and has not reported where it has led.
  bool jogging() const { return jogging_; }

  /// The axes stand after all that was commanded.
  bool stands() const;
  /// They do, and all effects have acted.
  bool has_acted() const;
  /// The same, and no WHEN has interrupted that.
  bool settled() const { return has_acted() && !interrupted(); }
  /// The decision point of the last motion has come.
  bool decided() const;
  /// The world may be read now.
  bool observable() const;
  /// So may where the axes are. After an exact motion no blend is lost by waiting until they stand,
  /// and only then are they where the program sent them.
  bool place_can_be_read() const { return observable() && (!exact_ || stands()); }

  /// A WHEN has ended all that was commanded, and the program has still to learn of it.
  bool interrupted() const;
  /// How what was guarded or braked has ended, once it has. A Rest that a WHEN has
  /// caused is left for whoever handles that.
  bool take_rest(motion::Rest& rest);

 private:
  /// Number of the last segment that is waited for: marks after it are not.
  std::uint32_t awaited() const;
  bool effects_have_acted() const;
  bool changes_have_acted() const;

  const RobotLinks& links_;
  const EffectQueue& effects_;
  bool exact_ = true;
  bool jogging_ = false;
  std::uint32_t awaited_ = 0;
};

}  // namespace rob::runtime

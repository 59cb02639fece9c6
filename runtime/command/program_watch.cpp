#include "runtime/command/program_watch.h"

#include <limits>

#include "lang/values/pose_slots.h"
#include "lang/values/units.h"
#include "runtime/words/pose_values.h"

namespace rob::runtime {

namespace {

/// The world of one control cycle, by the numbers of the language.
class CycleWorld final : public lang::WatchedWorld {
 public:
  CycleWorld(const std::vector<lang::RobotSignature::Signal>& signals,
             const motion::RobotModel& robot, const motion::CycleView& view) noexcept
      : signals_(signals), robot_(robot), view_(view) {}

  bool signal(int signal) const noexcept override {
    const lang::RobotSignature::Signal& asked = signals_[static_cast<std::size_t>(signal)];
    const std::uint64_t bits = asked.output ? view_.outputs : view_.inputs;
    return (bits >> (asked.channel - 1) & 1U) != 0;
  }

  double analog(int signal) const noexcept override {
    const lang::RobotSignature::Signal& asked = signals_[static_cast<std::size_t>(signal)];
    const auto channel = static_cast<std::size_t>(asked.channel - 1);
    return asked.output ? view_.analog_outputs[channel] : view_.analog_inputs[channel];
  }

  /// HERE and JOINTS() come from the references of the axes, as everywhere.
  void read(lang::Reading what, lang::Slot* value) const noexcept override {
    switch (what) {
      case lang::Reading::Clock:
        value->real = view_.time;
        return;
      case lang::Reading::Joints:
        for (const double axis : view_.reference) (value++)->real = axis + 0.0;
        return;
      case lang::Reading::Here:
        return lang::store(to_lang(robot_.kinematics->forward(view_.reference)), value);
      default:
        return store_wrench(what, view_.wrench.force, view_.wrench.torque, value);
    }
  }

 private:
  const std::vector<lang::RobotSignature::Signal>& signals_;
  const motion::RobotModel& robot_;
  const motion::CycleView& view_;
};

}  // namespace

lang::WatchResult ProgramWatch::evaluate(const motion::CycleView& view) const noexcept {
  return lang::evaluate(watch_, CycleWorld(signals_, robot_, view));
}

motion::WatchAnswer ProgramWatch::test(const void* self, const motion::CycleView& view) noexcept {
  const auto& watch = *static_cast<const ProgramWatch*>(self);
  const lang::WatchResult result = watch.evaluate(view);
  if (result.error != lang::ArithmeticError::None) {
    watch.error_ = result.error;
    return motion::WatchAnswer::Failed;
  }
  return result.value.integer != 0 ? motion::WatchAnswer::Yes : motion::WatchAnswer::No;
}

double ProgramWatch::value(const void* self, const motion::CycleView& view) noexcept {
  const auto& watch = *static_cast<const ProgramWatch*>(self);
  const lang::WatchResult result = watch.evaluate(view);
  const bool none = result.error != lang::ArithmeticError::None;
  return none ? std::numeric_limits<double>::quiet_NaN()
              : lang::to_si(result.value.real, watch.dimension_);
}

}  // namespace rob::runtime

#include "runtime/control/program_watch.h"

namespace rob::runtime {

namespace {

/// The world of one control cycle, by the numbers of the language.
class CycleWorld final : public lang::WatchedWorld {
 public:
  CycleWorld(const std::vector<lang::RobotSignature::Signal>& signals,
             const motion::CycleView& view) noexcept
      : signals_(signals), view_(view) {}

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

 private:
  const std::vector<lang::RobotSignature::Signal>& signals_;
  const motion::CycleView& view_;
};

}  // namespace

motion::WatchAnswer ProgramWatch::test(const void* self, const motion::CycleView& view) noexcept {
  const auto& watch = *static_cast<const ProgramWatch*>(self);
  const lang::WatchResult result = lang::evaluate(watch.watch_, CycleWorld(watch.signals_, view));
  if (result.error != lang::ArithmeticError::None) {
    watch.error_ = result.error;
    return motion::WatchAnswer::Failed;
  }
  return result.value.integer != 0 ? motion::WatchAnswer::Yes : motion::WatchAnswer::No;
}

}  // namespace rob::runtime

#include "runtime/tick/simulated_inputs.h"

#include <algorithm>

#include "motion/space/cycle_instant.h"

namespace rob::runtime {

namespace {

using SignalKind = WorldSignal::Kind;

double bit_value(std::uint64_t bits, int channel) noexcept {
  return static_cast<double>(bits >> channel & 1U);
}

double value_of(const WorldSignal& signal, const WorldImage& image) noexcept {
  switch (signal.kind) {
    case SignalKind::Input:
      return bit_value(image.inputs, signal.channel);
    case SignalKind::Output:
      return bit_value(image.outputs, signal.channel);
    case SignalKind::AnalogInput:
      return image.analog_inputs[signal.channel];
    case SignalKind::AnalogOutput:
      return image.analog_outputs[signal.channel];
    case SignalKind::Force:
    case SignalKind::Go:
    case SignalKind::Answer:
    case SignalKind::Hold:
    case SignalKind::Stop:
    case SignalKind::Override:
    case SignalKind::Line:
      break;  // they are set, never looked at
  }
  return 0;
}

/// V by which two voltages may differ and count as equal: what rounding in a SCALE can add.
constexpr double kSameVoltage = 1e-9;

bool holds(const SimulationRule& rule, const WorldImage& image) noexcept {
  using Comparison = SimulationRule::Comparison;
  const double difference = value_of(rule.watched, image) - rule.reference;
  const bool same = difference <= kSameVoltage && difference >= -kSameVoltage;
  switch (rule.comparison) {
    case Comparison::Equal:
      return same;
    case Comparison::NotEqual:
      return !same;
    case Comparison::Less:
      return !same && difference < 0;
    case Comparison::LessEqual:
      return same || difference < 0;
    case Comparison::Greater:
      return !same && difference > 0;
    case Comparison::GreaterEqual:
      return same || difference > 0;
  }
  return false;
}

/// How often a script ends a hold.
OperatorPanel::Promise releases_of(const std::vector<SimulationRule>& rules) {
  OperatorPanel::Promise releases;
  for (const SimulationRule& rule : rules) {
    const SignalKind kind = rule.setting.place.kind;
    if (kind != SignalKind::Stop && (kind != SignalKind::Go || rule.setting.value == 0)) continue;
    releases.whenever = releases.whenever || !rule.timed;
    releases.times += rule.timed ? 1 : 0;
  }
  return releases;
}

}  // namespace

SimulatedInputs::SimulatedInputs(const std::vector<SimulationRule>& rules, OperatorPanel& panel)
    : operator_(panel, releases_of(rules)) {
  for (const SimulationRule& rule : rules) {
    if (rule.timed) {
      script_.push_back({rule.time, rule.setting});
    } else {
      watches_.push_back({.rule = rule});
    }
  }
  std::ranges::stable_sort(script_, {}, &Waiting::time);
  lines_.reserve(rules.size());
}

bool SimulatedInputs::schedule(const SimulatedSetting& setting, double time) noexcept {
  if (waiting_count_ == kMostWaiting) return false;
  std::size_t at = waiting_count_++;
  for (; at > 0 && waiting_[at - 1].time > time; --at) waiting_[at] = waiting_[at - 1];
  waiting_[at] = {time, setting};
  return true;
}

void SimulatedInputs::latch(double now, WorldImage& image) noexcept {
  lines_.clear();
  apply_waiting(now);
  overlay(image);
  for (Watch& watch : watches_) {
    look(watch, now, image);
    overlay(image);
  }
}

void SimulatedInputs::apply_waiting(double now) noexcept {
  while (next_ < script_.size() && script_[next_].time <= now + motion::kSameInstant) {
    apply(script_[next_++].setting);
  }
  std::size_t due = 0;
  while (due < waiting_count_ && waiting_[due].time <= now + motion::kSameInstant) {
    apply(waiting_[due++].setting);
  }
  if (due == 0) return;
  std::move(waiting_.begin() + static_cast<std::ptrdiff_t>(due),
            waiting_.begin() + static_cast<std::ptrdiff_t>(waiting_count_), waiting_.begin());
  waiting_count_ -= due;
  done_ += static_cast<std::int64_t>(due);
}

void SimulatedInputs::look(Watch& watch, double now, const WorldImage& image) noexcept {
  const bool is_true = holds(watch.rule, image);
  if (is_true && !watch.was_true && !watch.due) {
    watch.due = true;
    watch.due_at = now + watch.rule.time;
  }
  watch.was_true = is_true;
  if (!watch.due || watch.due_at > now + motion::kSameInstant) return;
  watch.due = false;
  apply(watch.rule.setting);
}

void SimulatedInputs::apply(const SimulatedSetting& setting) noexcept {
  const WorldSignal& place = setting.place;
  const std::uint64_t bit = std::uint64_t{1} << place.channel;
  switch (place.kind) {
    case SignalKind::Input:
      drives_ = true;
      driven_ |= bit;
      inputs_ = setting.value != 0 ? inputs_ | bit : inputs_ & ~bit;
      return;
    case SignalKind::AnalogInput:
      drives_ = true;
      analog_driven_[place.channel] = true;
      analog_inputs_[place.channel] = motion::within_analog_range(setting.value);
      return;
    case SignalKind::Force:
      drives_ = true;
      force_driven_[place.channel] = true;
      force_[place.channel] = setting.value;
      return;
    case SignalKind::Go:
      if (setting.value != 0) operator_.go();
      return;
    case SignalKind::Answer:
      return operator_.answer(setting.answer);
    case SignalKind::Hold:
      return operator_.hold();
    case SignalKind::Stop:
      return operator_.stop();
    case SignalKind::Override:
      return operator_.set_override(setting.value);
    case SignalKind::Line:
      lines_.push_back(setting.answer);
      return;
    case SignalKind::Output:
    case SignalKind::AnalogOutput:
      return;  // outputs are the program's: no script sets one
  }
}

void SimulatedInputs::overlay(WorldImage& image) const noexcept {
  if (!drives_) return;
  image.inputs = (image.inputs & ~driven_) | (inputs_ & driven_);
  for (std::size_t i = 0; i < analog_driven_.size(); ++i) {
    if (analog_driven_[i]) image.analog_inputs[i] = analog_inputs_[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (force_driven_[i]) image.wrench.force[axis] = force_[i];
    if (force_driven_[i + 3]) image.wrench.torque[axis] = force_[i + 3];
  }
}

}  // namespace rob::runtime

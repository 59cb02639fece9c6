#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/space/analog_channels.h"
#include "motion/space/wrench.h"
#include "runtime/tick/scripted_operator.h"

namespace rob::runtime {

/// The inputs that a signal script and SIMULATE look at and set. `channel` counts from 0; of Force
/// they are x, y, z of the force along the world, then of the torque.
struct WorldSignal {
  enum class Kind : std::uint8_t {
    Input,
    AnalogInput,
    Output,
    AnalogOutput,
    Force,
    // Orders of the operator
    Go,
    Answer,
    Hold,
    Stop,
    Override,
    Line  ///< a DEVICE sends one
  };

  Kind kind = Kind::Input;
  std::uint8_t channel = 0;
};

/// A value for an input, V or 1 for ON, N or Nm; or what the operator does, of Override the share.
struct SimulatedSetting {
  WorldSignal place;
  double value = 0;
  std::uint32_t answer =
      0;  ///< of Answer: index of its text in the OperatorPanel; of Line: its own
};

/// A line of a signal script: `at 2.5s part_here = ON`, `when lift_up == ON after 0.3s : ok = ON`.
struct SimulationRule {
  enum class Comparison : std::uint8_t { Equal, NotEqual, Less, LessEqual, Greater, GreaterEqual };

  bool timed = true;  ///< an `at`; else a `when`
  double time = 0;    ///< s: of the run, or after the condition has become true
  WorldSignal watched;
  Comparison comparison = Comparison::Equal;
  double reference = 0;
  SimulatedSetting setting;
};

/// The inputs as the program sees them in one cycle, and the outputs as they are.
struct WorldImage {
  std::uint64_t inputs = 0;
  std::uint64_t outputs = 0;
  motion::AnalogValues analog_inputs{};
  motion::AnalogValues analog_outputs{};
  motion::Wrench wrench;  ///< along the world
};

/// Inputs that a script or SIMULATE drives, in place of the machine, from the first setting on.
///
/// In each cycle the settings whose time has come act first, in order of time; then the `when`s are
/// looked at in their order, each seeing what those before it have set. A `when` acts whenever its
/// condition becomes true, also if it is true at the start; until it has acted, further times are
/// not counted.
///
/// The constructor takes memory; every other call may be used in the tick.
class SimulatedInputs {
 public:
  /// Settings of SIMULATE that can wait for their time. [choice] far more than a test has.
  static constexpr std::size_t kMostWaiting = 256;

  SimulatedInputs(const std::vector<SimulationRule>& rules, OperatorPanel& panel);

  /// From `time` on the setting holds; false if too many wait.
  bool schedule(const SimulatedSetting& setting, double time) noexcept;
  /// Settings of schedule() that hold by now.
  std::int64_t simulations_done() const noexcept { return done_; }
  /// Whether a force is simulated.
  bool feels() const noexcept {
    return std::ranges::any_of(force_driven_, [](bool driven) { return driven; });
  }
  /// It acts in the operator's place.
  ScriptedOperator& scripted_operator() noexcept { return operator_; }
  /// Lines of devices that have come in this cycle.
  const std::vector<std::uint32_t>& lines() const noexcept { return lines_; }
  /// Puts what is simulated into `image`, which holds what the machine says.
  void latch(double now, WorldImage& image) noexcept;

 private:
  struct Waiting {
    double time = 0;
    SimulatedSetting setting;
  };
  struct Watch {
    SimulationRule rule;
    bool was_true = false;
    bool due = false;
    double due_at = 0;
  };

  void apply_waiting(double now) noexcept;
  void look(Watch& watch, double now, const WorldImage& image) noexcept;
  void apply(const SimulatedSetting& setting) noexcept;
  void overlay(WorldImage& image) const noexcept;

  ScriptedOperator operator_;
  std::vector<Waiting> script_;  ///< the `at`s, by time
  std::size_t next_ = 0;         ///< of them
  std::vector<Watch> watches_;
  std::array<Waiting, kMostWaiting> waiting_{};  ///< of SIMULATE, by time
  std::size_t waiting_count_ = 0;
  std::int64_t done_ = 0;
  std::vector<std::uint32_t> lines_;  ///< room for one a rule

  bool drives_ = false;       ///< any input, or force
  std::uint64_t driven_ = 0;  ///< inputs that are simulated, bit i: channel i
  std::uint64_t inputs_ = 0;  ///< and their values
  std::array<bool, motion::kMostAnalog> analog_driven_{};
  motion::AnalogValues analog_inputs_{};
  std::array<bool, 6> force_driven_{};
  std::array<double, 6> force_{};
};

}  // namespace rob::runtime

#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "motion/generate/foresight.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// The path events of look-ahead motion: each is due when the references pass its place, or `lead`
/// before that. Where they pass it is known from their own σ, the mean of the guide's; what they
/// will pass, by foresight.
///
/// Times are the guide's, s. Every call may be used in the tick.
class PlaceEvents {
 public:
  using Mark = ReferenceMark;

  /// `period`: of the references, which are the mean of the guide, s. Takes memory; nothing else
  /// here does.
  PlaceEvents(const Guide& guide, const ReferenceAverage& average, double period)
      : foresight_(guide, average, period) {}

  /// `sigma`: the place; `earliest`: not before.
  void expect(const PathEvent& event, double sigma, double earliest) noexcept;
  /// A run begins: the references stand at the mark.
  void begin_run(const Mark& mark) noexcept;
  /// Once a period: the references have come to the mark.
  void go_on(const Mark& mark) noexcept;
  /// The same while no run is under way: the references stand, and time goes on.
  void stand(double time) noexcept { go_on({time, now_.sigma, 0}); }
  /// No later than now. An event that motions up to `number` have passed comes before the instant,
  /// at which the last of them ends.
  struct Until {
    double time = 0;
    std::uint32_t number = 0;
  };
  /// The earliest effect that is due, of motions up to a number; null: none.
  const Effect* take(const Until& until, double& due) noexcept;
  /// s by which what was taken last came later than its LEAD asked for, since its motion does not
  /// take so long to its place; 0: it did not.
  double cut() const noexcept { return cut_; }
  /// A LEAD that was not kept: what the guide did was not what had been foreseen.
  struct Missed {
    Tag tag = 0;
    double time = 0;   ///< the references passed the place
    double error = 0;  ///< s by which the event came too early; below 0: too late
  };
  /// One at a time; those by less than `tolerance`, s, count as kept.
  std::optional<Missed> take_missed(double tolerance) noexcept;
  /// When the references passed, in the last period, a place that they have reached; or the
  /// beginning of that period, if they had passed it before.
  double passing(double sigma) const noexcept { return passing_time(before_, now_, sigma); }
  bool pending() const noexcept { return count_ > 0; }
  void drop() noexcept { count_ = led_count_ = 0; }

 private:
  struct Entry {
    double sigma = 0;
    double lead = 0;
    double earliest = 0;
    bool passed = false;
    double when = 0;  ///< the references pass, or will, the place; once `passed`
    Foresight::Outlook outlook;
    Effect effect;
  };
  /// [choice] the events of eight legs, whose lags may overlap
  static constexpr std::size_t kMost = 8 * EventsOnTheWay::kMost;

  /// An event that came before its place, until that is passed.
  struct Led {
    Tag tag = 0;
    double sigma = 0;
    double lead = 0;
    double came = 0;
  };
  std::optional<double> when(Entry& entry) noexcept;
  void remember(const Entry& entry, double due) noexcept;

  Foresight foresight_;
  Mark before_;  ///< at the last two periods
  Mark now_;
  std::array<Led, kMost> led_;
  std::size_t led_count_ = 0;
  std::array<Entry, kMost> entries_;
  std::size_t count_ = 0;
  Effect taken_;
  double cut_ = 0;
};

}  // namespace rob::motion

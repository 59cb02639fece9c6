#pragma once

#include <optional>
#include <vector>

#include "motion/collision/clearance.h"

namespace rob::motion {

/// Proves a path free of contact while its references come one after the other, with the axes going
/// straight from one to the next: a pair is measured again where the axes have gone so far since
/// that it could be in contact, so that nothing lies between two looks. Takes memory in the
/// constructor alone. Far pairs cost a comparison: what the axes have gone brings no pair nearer
/// than the one that they bring nearest.
class PathProof {
 public:
  struct Contact {
    Clearance::Pair pair;
    double distance = 0;      ///< m
    bool from_start = false;  ///< the two touched at begin() already
  };

  /// m: nearer pairs are in contact, so that a look carries at least so far.
  static constexpr double kContact = 0.5e-3;

  /// `near`, m: obstacles within it are measured at each reference, for nearest().
  PathProof(const Clearance& clearance, double near);

  /// From here on; pairs that are in contact here may part, but not come nearer.
  void begin(const JointVector& q);
  /// From here on the axes may be so far beside what follow() is told, m or rad of each: pairs that
  /// did not touch at begin() must be farther apart by as much as that can bring them together.
  void widen(const JointVector& beside);
  /// The next reference; the axes are anywhere between it and the one before. The first pair that
  /// comes into contact, or nearer where it was so from the beginning.
  std::optional<Contact> follow(const JointVector& q);
  /// The last reference.
  const JointVector& last() const noexcept { return last_; }
  /// The least distance of an obstacle since begin(), if within `near`.
  const std::optional<Contact>& nearest() const noexcept { return nearest_; }
  /// Whether some pair was in contact at begin().
  const std::optional<Contact>& at_start() const noexcept { return at_start_; }

 private:
  /// The state of a pair.
  struct Watched {
    double distance = 0;      // m, at the last look
    JointVector since{};      // how far each axis had gone in all by then
    double least = kContact;  // m: below it the pair comes into contact
    double margin = 0;        // m: widen()
    bool touched = false;     // it has
    bool from_start = false;  // it was in contact at begin()
  };
  struct Along {
    std::optional<Contact> contact{};
    double share = 1;  // of the step, where it is
  };

  void measure(std::size_t i, const LinkFrames& frames);
  bool far(std::size_t i, const JointVector& gone);
  double enough(std::size_t i) const noexcept;
  Along look_along(std::size_t i, const JointVector& step, double until);
  double look(std::size_t i, const JointVector& q, const JointVector& gone);
  Contact contact_of(std::size_t i, double distance) const;
  void note(const Contact& contact);

  const Clearance* clearance_;
  double near_;
  std::vector<Watched> watched_;
  std::vector<double>
      due_;                // for each pair: it need not be looked at until approached_ is so large
  double approached_ = 0;  // m by which no pair has come nearer, more or less
  JointVector gone_;       // how far each axis has gone, m or rad
  JointVector last_;
  std::optional<Contact> nearest_;
  std::optional<Contact> at_start_;
};

}  // namespace rob::motion

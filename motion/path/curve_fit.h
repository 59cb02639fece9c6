#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace rob::motion {

/// A cubic B-spline along a polyline, within a tolerance of it, streamed: points come at one end,
/// settled spans of the curve leave at the other. Among all curves within the tolerance it seeks
/// the one with the least sum of squared differences of its control points, which is what lets it
/// be run the fastest: of the second ones where acceleration is bounded, of the third where jerk
/// is. Controls are found in a window by least squares with weights, which grow
/// where a point lies too far away (iteratively reweighted least squares). Where no weight helps,
/// as in a corner that is sharper than the knots, these spans get twice as many knots.
///
/// The curve has a parameter u, one knot for each whole number. The way from vertex to vertex has a
/// length in u in proportion to its length in m, and each point of the polyline has its own u, so
/// the order of the points is kept: the Fréchet distance is bounded by the tolerance, not the
/// nearest distance alone.
///
/// m. Calls take memory; none may be used in the tick.
class CurveFit {
 public:
  /// `knot`: m between knots; `stiffness`: hF/knot, where hF = F·√(ε/A)/4 is the way in which an
  /// acceleration A leads off by the tolerance ε at the speed F, or hF = F·∛(ε/J)/2 with a jerk J.
  /// `order`: of the differences, 2 or 3.
  CurveFit(double knot, double stiffness, int order = 2);

  /// Begins at rest: only the place counts.
  void begin(const Eigen::Vector3d& place);
  /// Begins on a straight line along `direction`, of length 1: the curve joins it with continuous
  /// second derivatives.
  void begin_straight(const Eigen::Vector3d& place, const Eigen::Vector3d& direction);

  /// The next vertex, which the curve may miss by `tolerance`; `dense`: how many times as many
  /// knots as usual on the way to it. Counted from 0.
  void append(const Eigen::Vector3d& place, double tolerance, double dense = 1);

  /// Ends at the last vertex exactly.
  void end();
  /// Goes on from the last vertex along `direction`, of length 1, for 3 to 4 knots, and ends there
  /// on that straight line with continuous second derivatives. The m that it goes on.
  double end_straight(const Eigen::Vector3d& direction);

  /// Whether so much has come, or all, that more spans can be settled.
  bool ready() const noexcept;
  /// Settles the next spans; the u up to which the curve is settled then.
  double settle();
  bool ended() const noexcept { return ended_ && settled_ >= length_; }

  /// u of a vertex that was not dropped; infinite as long as it is not known. It can still change
  /// if it is beyond what is settled.
  double at_vertex(std::size_t i) const;
  struct Place {
    Eigen::Vector3d place;
    Eigen::Vector3d first;   ///< derivative with respect to u
    Eigen::Vector3d second;  ///< likewise
  };
  /// On the settled part that was not dropped.
  Place at(double u) const;
  /// The same of the polynomial from knot `span` to the next, a little beyond it, too.
  Place on_span(double u, std::size_t span) const;
  /// u of a place on the polyline between two u.
  double at_place(double from, double to, const Eigen::Vector3d& place) const;
  double knot() const noexcept { return knot_; }
  /// u up to which it is settled, and at the end of what is known.
  double settled() const noexcept { return settled_; }
  double length() const noexcept { return length_; }
  /// Nobody asks for the curve before u any more.
  void drop(double u);
  /// Vertices before that one are not asked for any more.
  void drop_vertices(std::size_t before);
  /// The greatest share of its tolerance by which a settled point is missed, and how often the
  /// knots were doubled.
  double worst() const noexcept { return worst_; }
  int doubled() const noexcept { return doubled_; }

 private:
  /// A place that the curve has to pass at its u, within `tolerance` of it.
  struct Datum {
    Eigen::Vector3d place;
    double u = 0;
    double tolerance = 0;
    double weight = 0;
    bool exact = false;
    int doubled = 0;  ///< how often the knots around it were doubled
  };
  struct Pending {
    Eigen::Vector3d place;
    double tolerance = 0;
    double dense = 1;
  };
  using Controls = std::vector<Eigen::Vector3d>;

  bool fits_chord(const Pending& next) const;
  void close_chord();
  void add_data(const Datum& to);
  std::size_t span_of(double u) const noexcept;
  std::size_t count() const noexcept;
  Eigen::Vector3d& control(std::size_t i) { return controls_[i - dropped_]; }
  const Eigen::Vector3d& control(std::size_t i) const { return controls_[i - dropped_]; }
  void weigh_new(std::size_t begin, std::size_t end);
  void solve(std::size_t until, std::size_t begin, std::size_t end);
  bool reweigh(std::size_t begin, std::size_t end, int round);
  bool fit(std::size_t until, std::size_t begin, std::size_t end);
  Eigen::Vector3d curve(double u, std::size_t span) const;
  double missed(const Datum& datum) const;
  bool double_knots(std::size_t begin, std::size_t end);
  void stretch(double from, double to);
  void meet(const Datum& datum);

  double knot_;
  int order_;  ///< of the differences
  double first_weight_;
  std::size_t window_;  ///< controls
  std::vector<Datum> data_;
  std::vector<Pending> chord_;  ///< vertices after the last datum that a chord may lead through
  Controls controls_;
  std::size_t dropped_ = 0;    ///< controls before controls_[0]
  std::size_t frozen_ = 0;     ///< controls that no longer change
  std::size_t fixed_end_ = 0;  ///< controls on the straight line at the end: 3, or none
  std::vector<double> vertices_;
  std::size_t dropped_vertices_ = 0;
  double length_ = 0;   ///< u of the last datum
  double settled_ = 0;  ///< u
  bool ended_ = false;
  double worst_ = 0;
  int doubled_ = 0;
};

}  // namespace rob::motion

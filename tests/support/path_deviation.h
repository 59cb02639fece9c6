#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "tests/support/trace_file.h"

namespace rob::test {

/// Where a program leads the tool: straight from place to place, in mm. Curves are given as chords
/// that are near enough; `points`: which places are programmed points, all if it is empty.
struct ProgrammedPath {
  std::vector<Eigen::Vector3d> places;
  std::vector<std::size_t> points{};
};

/// How far a tool was from what was programmed, mm.
struct PathDeviation {
  double from_path = 0;  ///< the greatest distance of a reference from the path
  double miss = 0;       ///< the greatest least distance of the references from a programmed point
  double greatest() const { return from_path > miss ? from_path : miss; }
};

/// Where the references lead the tool of a robot whose first axes are x, y (and z): the cubic
/// Hermite curve through position and velocity of neighbouring rows, in so many parts a row.
std::vector<Eigen::Vector3d> tool_curve(const TraceFile& trace, std::size_t tool_axes,
                                        int parts = 16);

/// The same of any robot, from the trace's poses; velocities are their central differences.
std::vector<Eigen::Vector3d> tool_curve_of_poses(const TraceFile& trace, int parts = 16);

/// Follows the path along with the tool: of its places those count which are, along the path, less
/// than `window` mm before or behind the one where the tool was last. So a path may cross itself
/// and lie beside itself; the window must be longer than what a corner leaves out of it.
PathDeviation path_deviation(const std::vector<Eigen::Vector3d>& curve, const ProgrammedPath& path,
                             double window);

/// By how much a tool was farther from the path than it might be, mm; 0 and less: nowhere.
struct PathExcess {
  double from_path = 0;                             ///< beside it
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< where
  double miss = 0;                                  ///< of a point
  std::size_t point = 0;  ///< that one: its number among the path's points
};

/// mm by which each programmed point may be missed, and by which the tool may be beside the way to
/// it (empty: not at all). Between two points it may be beside the path by what is the greatest.
struct PathBounds {
  std::vector<double> misses;
  std::vector<double> besides{};
};

/// The part of the path between two of its points.
struct PathStretch {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// `where`: of each place of the curve the stretch that the tool was on, as its trace says; the
/// window counts from there. Empty: as path_deviation() follows it, which a path that crosses
/// itself can lead astray.
PathExcess path_excess(const std::vector<Eigen::Vector3d>& curve, const ProgrammedPath& path,
                       const PathBounds& bounds, double window,
                       const std::vector<PathStretch>& where = {});

}  // namespace rob::test

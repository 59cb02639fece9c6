#include "runtime/files/path_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "runtime/words/units.h"

namespace rob::runtime {

PathFile::PathFile(const std::string& path, const motion::RobotModel& robot)
    : robot_(robot), path_(path) {
  text_ = "sigma" + axis_columns(robot_, {"q", "dq", "ddq"}) + "\n";
}

void PathFile::planned(const motion::Piece& piece) {
  put(piece, 0);
  put(piece, piece.length);
}

void PathFile::put(const motion::Piece& piece, double at) {
  constexpr double kMm = 1e-3;
  constexpr double kRounding = 1e-12;  // by which pieces that meet may miss each other
  const motion::PathPoint point = piece.point(at);
  const double sigma = (piece.begin + at) / kMm;
  if (sigma > sigma_ * (1 + kRounding)) sigma_ = sigma;
  std::string row = fmt::format("{:.17g}", sigma_);
  double per_mm = 1;
  for (const motion::JointVector* values : {&point.q, &point.qd, &point.qdd}) {
    for (int i = 0; i < robot_.axis_count(); ++i) {
      const double shown = shown_per_si(axis_of(robot_, i).kind);
      fmt::format_to(std::back_inserter(row), ",{:.17g}", (*values)[i] * shown * per_mm);
    }
    per_mm *= kMm;
  }
  text_ += row + "\n";
}

}  // namespace rob::runtime

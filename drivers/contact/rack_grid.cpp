#include "drivers/contact/rack_grid.h"

#include <algorithm>
#include <cmath>

namespace rob::drivers {

using motion::RackData;

namespace {

/// Which of `count` lines `pitch` apart, the first at 0, is nearest; −1 beyond half a pitch.
int nearest_line(double at, double pitch, int count) noexcept {
  const double line = std::round(at / pitch);
  return line >= 0 && line < count ? static_cast<int>(line) : -1;
}

}  // namespace

RackGrid::RackGrid(const std::vector<RackData>& racks) {
  for (const RackData& rack : racks) {
    racks_.push_back({rack, holes_});
    holes_ += rack.columns * rack.rows;
  }
}

Hole RackGrid::hole(int number) const noexcept {
  const auto& [rack, first] = rack_of(number);
  const int column = (number - first) % rack.columns;
  const int row = (number - first) / rack.columns;
  const double x = rack.x + rack.error.x() + column * rack.pitch;
  const double y = rack.y + rack.error.y() + row * rack.pitch;
  return {Eigen::Vector3d(x, y, rack.face), rack.depth, rack.clearance, rack.chamfer};
}

RackData::Fill RackGrid::fill(int number) const noexcept { return rack_of(number).rack.fill; }

int RackGrid::nearest(double x, double y) const noexcept {
  for (const auto& [rack, first] : racks_) {
    const int column = nearest_line(x - rack.x - rack.error.x(), rack.pitch, rack.columns);
    const int row = nearest_line(y - rack.y - rack.error.y(), rack.pitch, rack.rows);
    if (column >= 0 && row >= 0) return first + row * rack.columns + column;
  }
  return kNone;
}

const RackGrid::Numbered& RackGrid::rack_of(int number) const noexcept {
  const auto later = std::find_if(racks_.begin() + 1, racks_.end(),
                                  [&](const Numbered& rack) { return rack.first > number; });
  return *(later - 1);
}

}  // namespace rob::drivers

#pragma once

#include <vector>

#include "drivers/contact/hole.h"
#include "motion/cell/cell_data.h"

namespace rob::drivers {

/// The holes of all racks, numbered through: rack after rack, row after row.
class RackGrid {
 public:
  static constexpr int kNone = -1;

  explicit RackGrid(const std::vector<motion::RackData>& racks);

  int holes() const noexcept { return holes_; }
  Hole hole(int number) const noexcept;
  /// Whether the hole has something in it when the cell begins.
  motion::RackData::Fill fill(int number) const noexcept;
  /// The hole nearest to a place, of the rack that it is over; kNone if it is over none. A rack
  /// reaches half a pitch beyond its outer holes. No work for each hole. May be used in the tick.
  int nearest(double x, double y) const noexcept;

 private:
  struct Numbered {
    motion::RackData rack;
    int first = 0;
  };

  const Numbered& rack_of(int number) const noexcept;

  std::vector<Numbered> racks_;
  int holes_ = 0;
};

}  // namespace rob::drivers

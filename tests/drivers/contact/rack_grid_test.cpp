#include "drivers/contact/rack_grid.h"

#include <doctest/doctest.h>

#include "tests/drivers/contact/cell_bench.h"
#include "tests/support/relative.h"

namespace rob::drivers {

TEST_CASE("holes are numbered row after row, rack after rack") {
  const RackGrid racks(test::small_cell().racks);
  CHECK(racks.holes() == 8);
  CHECK(racks.hole(0).mouth.isApprox(Eigen::Vector3d(0, 0, 0.06)));
  CHECK(racks.hole(2).mouth.isApprox(Eigen::Vector3d(0.044, 0, 0.06)));
  CHECK(racks.hole(4).mouth.isApprox(Eigen::Vector3d(0.022, 0.022, 0.06)));
  CHECK(racks.hole(test::kEmptyHole).mouth.isApprox(Eigen::Vector3d(0.3, 0, 0.06)));
  CHECK(racks.hole(7).bottom() == test::relative(0.01));
}

TEST_CASE("the nearest hole is that of the cell of the grid, and beyond a rack there is none") {
  const RackGrid racks(test::small_cell().racks);
  for (int number = 0; number < racks.holes(); ++number) {
    const Eigen::Vector3d mouth = racks.hole(number).mouth;
    CHECK(racks.nearest(mouth.x() + 0.010, mouth.y() - 0.010) == number);
  }
  CHECK(racks.nearest(-0.012, 0) == RackGrid::kNone);
  CHECK(racks.nearest(0.056, 0) == RackGrid::kNone);
  CHECK(racks.nearest(0, 0.034) == RackGrid::kNone);
}

TEST_CASE("an error moves the holes of a rack") {
  std::vector<motion::RackData> racks = test::small_cell().racks;
  racks[1].error = {2e-3, -1e-3};
  const RackGrid grid(racks);
  CHECK(grid.hole(6).mouth.isApprox(Eigen::Vector3d(0.302, -0.001, 0.06)));
  CHECK(grid.hole(7).mouth.isApprox(Eigen::Vector3d(0.4, 0, 0.06)));
}

}  // namespace rob::drivers

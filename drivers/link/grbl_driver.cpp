#include "drivers/link/grbl_driver.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/unit_factors.h"
#include "drivers/link/grbl_link.h"

namespace rob::drivers {

using motion::DriverError;

namespace {

constexpr int kLetters = 6;

/// The letter that the file says, that of the axis' name, or the next that is free.
std::vector<int> letters_of(std::span<const WiredAxis> axes) {
  std::vector<int> letters;
  for (const WiredAxis& axis : axes) {
    const std::size_t named = std::string("xyzabc").find(axis.name);
    const bool has_name = axis.name.size() == 1 && named != std::string::npos;
    letters.push_back(axis.letter >= 0 ? axis.letter : has_name ? static_cast<int>(named) : -1);
  }
  for (int& letter : letters)
    for (int free = 0; letter < 0 && free < kLetters; ++free)
      if (std::ranges::find(letters, free) == letters.end()) letter = free;
  return letters;
}

/// m or rad: what a millimetre of grbl is where the file does not say; a degree for a rotary axis.
double travel_of(const WiredAxis& axis) {
  return axis.travel != 0 ? axis.travel : axis.linear ? kMillimetre : kDegree;
}

}  // namespace

std::unique_ptr<WireBackend> make_grbl(WireSettings settings, std::span<const WiredAxis> axes) {
  const std::vector<int> letters = letters_of(axes);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (letters[i] < 0) throw DriverError("grbl has no letter for axis " + axes[i].name);
    settings.axes.push_back(axis_on(axes[i], 1, travel_of(axes[i]), 0));
    settings.axes.back().address = letters[i];
  }
  refuse_same_address(settings.axes, "letter");
  settings.period = GrblLink::kPeriod;
  auto link = grbl_link(settings.axes, settings.baud);
  return std::make_unique<WireBackend>(std::move(settings), std::move(link));
}

}  // namespace rob::drivers

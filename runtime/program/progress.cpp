#include "runtime/program/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace rob::runtime {

namespace {

constexpr double kEvery = 0.1;  // s of the run: as often as an eye reads

}  // namespace

Progress::Progress(double planned) : planned_(planned), terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::show(int line, double time) {
  if (!terminal_ || line == 0 || time - last_ < kEvery) return;
  last_ = time;
  shown_ = true;
  fmt::print(stderr, "\r\033[Kline {}  {:.1f} s", line, time);
  if (planned_ > 0) fmt::print(stderr, "  {:.1f} s left", std::max(0.0, planned_ - time));
}

void Progress::clear() {
  if (!shown_) return;
  shown_ = false;
  fmt::print(stderr, "\r\033[K");
}

}  // namespace rob::runtime

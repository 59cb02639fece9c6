#include "drivers/link/grbl_stream.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rob::drivers {

void GrblStream::begin(const std::vector<int>& letters, const std::vector<double>& steps,
                       double period, const std::vector<double>& speeds) {
  letters_ = letters;
  steps_ = steps;
  speeds_ = speeds;
  period_ = period;
  sent_.clear();
  unacknowledged_ = 0;
  stand_at({});
}

void GrblStream::stand_at(const WireVector& position) noexcept {
  for (std::size_t i = 0; i < steps_.size(); ++i)
    queued_[i] = std::llround(position[i] * steps_[i]);
  lines_.clear();
  idle_ = kAhead;
  collecting_ = true;
}

void GrblStream::push(const WireCommand& command) {
  const bool rests = idle_ >= kAhead;
  const double since = std::max(command.time - last_, 0.0);
  last_ = command.time;
  // From rest the axes have begun to move within the last period only.
  pending_ = rests ? std::min(since, period_) : std::min(pending_ + since, kAhead * period_);
  Steps way{};
  bool moves = false;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const std::int64_t target = std::llround(command.position[i] * steps_[i]);
    way[i] = target - queued_[i];
    moves = moves || way[i] != 0;
  }
  if (!moves) {
    idle_ = std::min(idle_ + 1, kAhead);
    if (idle_ == kAhead && lines_.empty()) collecting_ = true;
    if (idle_ == kAhead && !lines_.empty()) flush();
    return;
  }
  idle_ = 0;
  for (std::size_t i = 0; i < steps_.size(); ++i) queued_[i] += way[i];
  lines_.push_back(line_of(way, std::max(pending_, least_time(way))));
  pending_ = 0;
  if (lines_.size() >= kAhead) flush();
}

/// s that the way takes at the greatest speeds.
double GrblStream::least_time(const Steps& way) const noexcept {
  double least = 1e-3;
  for (std::size_t i = 0; i < speeds_.size(); ++i)
    least = std::max(least, static_cast<double>(std::abs(way[i])) / steps_[i] / speeds_[i]);
  return least;
}

std::string GrblStream::line_of(const Steps& way, double seconds) const {
  std::string line = "G91G21G93G1";
  char text[40];
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (way[i] == 0) continue;
    std::snprintf(text, sizeof text, "%c%.5f", "XYZABC"[letters_[i]],
                  static_cast<double>(way[i]) / steps_[i]);
    line += text;
  }
  std::snprintf(text, sizeof text, "F%.3f\n", 60 / seconds);
  return line + text;
}

bool GrblStream::full() const noexcept {
  return !lines_.empty() && !collecting_ &&
         unacknowledged_ + static_cast<int>(lines_.front().size()) > kBuffer;
}

std::string GrblStream::next_line(double now) {
  if (lines_.empty() || collecting_ || full()) return "";
  const int bytes = static_cast<int>(lines_.front().size());
  std::string line = std::move(lines_.front());
  lines_.pop_front();
  if (sent_.empty()) open_since_ = now;
  sent_.push_back(bytes);
  unacknowledged_ += bytes;
  return line;
}

bool GrblStream::acknowledged() noexcept {
  if (sent_.empty()) return false;
  unacknowledged_ -= sent_.front();
  sent_.pop_front();
  return true;
}

}  // namespace rob::drivers

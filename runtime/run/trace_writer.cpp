#include "runtime/run/trace_writer.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "runtime/run/line_text.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

constexpr std::size_t kRowBuffer = 8192;  // bytes: more than any row has

void append(std::string& row, double value) {
  fmt::format_to(std::back_inserter(row), ",{:.17g}", value);
}

/// The axes' values in the units people read.
void append(std::string& row, const motion::JointVector& values, const motion::RobotModel& robot) {
  for (const double value : shown_joints(robot, values)) append(row, value);
}

}  // namespace

TraceWriter::TraceWriter(const std::string& path, const motion::RobotModel& robot,
                         std::vector<std::string> used)
    : robot_(robot), used_(std::move(used)), file_(open_log(path)) {
  // A row at a time, so that a full disk is noticed with the row that no longer fits.
  std::setvbuf(file_.get(), nullptr, _IOLBF, kRowBuffer);
  header();
}

void TraceWriter::header() {
  std::string names = "t,line,piece,sigma,rate,state,override,limit,late_us";
  names += axis_columns(robot_, {"q", "qd", "qdd", "a"});
  names += ",x,y,z,a,b,c";
  if (robot_.force_sensor) names += ",fx,fy,fz,tx,ty,tz";
  put(names + axis_columns(robot_, {"drive"}) + "\n");
}

void TraceWriter::write(const Snapshot& snapshot) {
  const motion::GeneratorSample& sample = snapshot.sample;
  row_.clear();
  fmt::format_to(std::back_inserter(row_), "{:.17g},{},{},{:.17g},{:.17g},{},{:.17g},{},{:.17g}",
                 sample.reference.time, line_text(static_cast<int>(sample.tag), used_),
                 sample.piece, sample.sigma, sample.rate, static_cast<int>(sample.state),
                 snapshot.override_share, sample.limit, snapshot.lateness * 1e6);
  append(row_, sample.reference.q, robot_);
  append(row_, sample.reference.qd, robot_);
  append(row_, sample.reference.qdd, robot_);
  append(row_, snapshot.measured, robot_);
  for (const double value : shown_pose(robot_.kinematics->forward(sample.reference.q))) {
    append(row_, value);
  }
  if (robot_.force_sensor) {
    for (const double force : snapshot.wrench.force) append(row_, force);
    for (const double torque : snapshot.wrench.torque) append(row_, torque);
  }
  for (int i = 0; i < robot_.axis_count(); ++i) append(row_, snapshot.drive[i]);
  row_ += '\n';
  if (!put(row_)) ++lost_;
}

bool TraceWriter::put(const std::string& text) {
  if (full_) return false;
  const bool taken = std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size();
  // The text that was taken may have been written in part: then the stream remembers an error.
  full_ = !taken || std::ferror(file_.get()) != 0;
  return !full_;
}

bool TraceWriter::close() { return std::fclose(file_.release()) == 0 && !full_; }

}  // namespace rob::runtime

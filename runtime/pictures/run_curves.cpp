#include "runtime/pictures/run_curves.h"

namespace rob::runtime {

void RunCurves::take(const Snapshot& snapshot) {
  const motion::Kinematics& tool = *robot_.kinematics;
  Row row;
  row.reference = snapshot.sample.reference;
  row.measured = snapshot.measured;
  row.tool = tool.forward(row.reference.q).position;
  row.tool_measured = tool.forward(row.measured).position;
  if (last_ && row.reference.time > last_->reference.time)
    row.speed = (row.tool - last_->tool).norm() / (row.reference.time - last_->reference.time);
  row.override_share = snapshot.override_share;
  row.lateness = snapshot.lateness;
  row.wrench = snapshot.wrench;
  row.line = static_cast<int>(snapshot.sample.tag);
  last_ = row;
  if (taken_++ % every_ != 0) return;
  rows_.push_back(row);
  if (rows_.size() < kMostRows) return;
  for (std::size_t i = 0; 2 * i < rows_.size(); ++i) rows_[i] = rows_[2 * i];
  rows_.resize((rows_.size() + 1) / 2);
  every_ *= 2;
}

std::vector<RunCurves::Row> RunCurves::rows() const {
  std::vector<Row> rows = rows_;
  if (last_ && (rows.empty() || rows.back().reference.time < last_->reference.time))
    rows.push_back(*last_);
  return rows;
}

}  // namespace rob::runtime

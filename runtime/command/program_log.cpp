#include "runtime/command/program_log.h"

#include <iterator>
#include <utility>

#include "runtime/tick/channels.h"

namespace rob::runtime {

void ProgramLog::planned(const LoggedSegment& segment) {
  const std::scoped_lock lock(mutex_);
  planned_.insert_or_assign(segment.number, segment);
}

void ProgramLog::queued_effect() {
  const std::scoped_lock lock(mutex_);
  ++effects_;
}

std::uint32_t ProgramLog::keep(Note note) {
  const std::scoped_lock lock(mutex_);
  notes_.emplace(next_note_, std::move(note));
  return next_note_++;
}

void ProgramLog::found(lang::Diagnostic finding) {
  const std::scoped_lock lock(mutex_);
  constexpr int kOfEach = 10;  // [choice] enough to see where, and whether it is everywhere
  const lang::Place& place = finding.place;
  if (!found_.insert({finding.code, place.file, place.line, place.column}).second)
    return;  // a loop finds it only once
  const int before = kept_[finding.code];
  if (findings_.size() >= lang::Diagnostics::kMost && before >= kOfEach) return;
  kept_[finding.code] = before + 1;
  findings_.push_back(std::move(finding));
}

void ProgramLog::expect_failed(FailedExpect failure) {
  const std::scoped_lock lock(mutex_);
  if (failed_expects_.size() < kMostFailedExpects) {
    failed_expects_.push_back(std::move(failure));
  } else {
    ++failed_expects_left_out_;
  }
}

std::vector<FailedExpect> ProgramLog::failed_expects() const {
  const std::scoped_lock lock(mutex_);
  return failed_expects_;
}

std::size_t ProgramLog::failed_expects_left_out() const {
  const std::scoped_lock lock(mutex_);
  return failed_expects_left_out_;
}

std::optional<LoggedSegment> ProgramLog::take_planned(std::uint32_t number) {
  const std::scoped_lock lock(mutex_);
  const auto found = planned_.find(number);
  if (found == planned_.end()) return std::nullopt;
  const LoggedSegment segment = found->second;
  const std::uint32_t first = number > kHandlerNumbers ? kHandlerNumbers : 0;
  planned_.erase(planned_.lower_bound(first), std::next(found));
  return segment;
}

Note ProgramLog::take_note(std::uint32_t id) {
  const std::scoped_lock lock(mutex_);
  const auto found = notes_.find(id);
  if (found == notes_.end()) return {};
  Note note = std::move(found->second);
  notes_.erase(found);
  return note;
}

std::vector<lang::Diagnostic> ProgramLog::findings() const {
  const std::scoped_lock lock(mutex_);
  return findings_;
}

std::size_t ProgramLog::findings_left_out() const {
  const std::scoped_lock lock(mutex_);
  return found_.size() - findings_.size();
}

std::int64_t ProgramLog::effects() const {
  const std::scoped_lock lock(mutex_);
  return effects_;
}

}  // namespace rob::runtime

#include "runtime/files/data_files.h"

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "lang/text/codes.h"

namespace rob::runtime {

namespace {

using namespace std::chrono_literals;

/// Lines that wait for a disk which hangs. [choice]
constexpr std::size_t kMostWaitingLines = 100'000;

Words failed_write(const std::string& name, std::string_view why) {
  return {std::string(lang::code::kFileFailed), fmt::format("cannot write '{}': {}", name, why),
          "what is written from here on would be lost"};
}

}  // namespace

DataFiles::DataFiles(const std::string& folder, Keeps keeps, bool stepped)
    : folder_(folder), in_memory_(keeps == Keeps::InMemory), stepped_(stepped) {}

DataFiles::~DataFiles() { finish(); }

std::optional<Words> DataFiles::admit(const std::string& name) {
  {
    const std::scoped_lock lock(mutex_);
    if (failure_) return std::exchange(failure_, std::nullopt);
  }
  if (admitted_.contains(name)) return std::nullopt;
  if (auto why = folder_.objection(name)) return why;
  if (admitted_.size() == kMostOpen) {
    return Words{std::string(lang::code::kFileRefused),
                 fmt::format("'{}' would be file {}: a program writes {} at most", name,
                             kMostOpen + 1, kMostOpen),
                 "write to fewer files"};
  }
  admitted_.insert(name);
  return std::nullopt;
}

/// A look of the reporting thread that was under way may have missed the last lines, so it is the
/// one after that counts.
bool DataFiles::reported() {
  if (stepped_ || admitted_.empty()) return true;
  const std::int64_t drains = drains_.load(std::memory_order_acquire);
  if (!asked_) asked_ = drains;
  if (drains < *asked_ + 2) return false;
  asked_.reset();
  return true;
}

bool DataFiles::exists(const std::string& name) {
  {
    const std::scoped_lock lock(mutex_);
    if (written_.contains(name)) return true;
  }
  return folder_.exists(name);
}

std::optional<std::string> DataFiles::read(const std::string& name, std::optional<Words>& why) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return lines_.empty() && idle_; });
  const auto found = written_.find(name);
  const bool more = in_memory_ && found != written_.end();
  auto text = folder_.read(name, why);
  if (!more) return text;
  why.reset();
  return text.value_or("") + found->second;
}

void DataFiles::append(const std::string& name, std::string_view line) {
  const std::scoped_lock lock(mutex_);
  std::string& written = written_[name];
  if (in_memory_) {
    written.append(line).append("\n");
    return;
  }
  if (lines_.size() == kMostWaitingLines)
    return fail(failed_write(name, "the disk does not answer"));
  lines_.push_back({name, std::string(line) + "\n"});
  if (!writer_.joinable()) writer_ = std::thread([this] { write_lines(); });
  changed_.notify_all();
}

std::optional<Words> DataFiles::finish() {
  {
    const std::scoped_lock lock(mutex_);
    over_ = true;
    changed_.notify_all();
  }
  if (writer_.joinable()) writer_.join();
  for (const auto& [name, file] : open_) ::close(file.fd);
  open_.clear();
  return std::exchange(failure_, std::nullopt);
}

/// Until all is over and written. The disk is waited for without the lock.
void DataFiles::write_lines() {
  auto next_sync = std::chrono::steady_clock::now() + 1s;
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait_until(lock, next_sync, [&] { return !lines_.empty() || over_; });
    const bool over = over_;
    std::deque<Line> lines = std::exchange(lines_, {});
    idle_ = false;
    lock.unlock();
    for (const Line& line : lines) write(line);
    if (over || std::chrono::steady_clock::now() >= next_sync) {
      sync();
      next_sync = std::chrono::steady_clock::now() + 1s;
    }
    lock.lock();
    idle_ = true;
    changed_.notify_all();
    if (over && lines_.empty()) return;
  }
}

void DataFiles::write(const Line& line) {
  Open& file = open_[line.name];
  std::optional<Words> why;
  if (file.fd < 0) file.fd = folder_.append_to(line.name, why);
  std::string_view rest = line.text;
  while (!why && !rest.empty()) {
    const ssize_t count = ::write(file.fd, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      why = failed_write(line.name, std::strerror(errno));
    } else {
      rest.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  file.dirty = true;
  if (!why) return;
  const std::scoped_lock lock(mutex_);
  fail(std::move(*why));
}

void DataFiles::sync() {
  for (auto& [name, file] : open_) {
    if (!std::exchange(file.dirty, false) || file.fd < 0 || ::fsync(file.fd) == 0) continue;
    const std::scoped_lock lock(mutex_);
    fail(failed_write(name, std::strerror(errno)));
  }
}

/// The first one counts. With the lock.
void DataFiles::fail(Words why) {
  if (!failure_) failure_ = std::move(why);
}

}  // namespace rob::runtime

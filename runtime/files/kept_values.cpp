#include "runtime/files/kept_values.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "lang/text/ascii.h"
#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/words/codes.h"

namespace rob::runtime {

namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr std::size_t kMostValues = std::size_t{64} << 20U;  // bytes [choice]
constexpr auto kBetweenSaves = 1s;

/// ".name.values.lock", beside the file.
std::string lock_file_of(const std::string& values_file) {
  const fs::path path(values_file);
  return (path.parent_path() / fmt::format(".{}.lock", path.filename().string())).string();
}

}  // namespace

std::string values_file_of(const std::string& program_file) {
  constexpr std::string_view kProgram = ".rob";
  const bool program = program_file.ends_with(kProgram);
  return program_file.substr(0, program_file.size() - (program ? kProgram.size() : 0)) + ".values";
}

ValuesLock::ValuesLock(const std::string& values_file) {
  const std::string file = lock_file_of(values_file);
  constexpr unsigned kNewLock = S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH;
  fd_ = ::open(file.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, kNewLock);
  if (fd_ < 0) throw FileError(fmt::format("cannot lock '{}': {}", file, std::strerror(errno)));
  if (::flock(fd_, LOCK_EX | LOCK_NB) == 0) return;
  const int error = errno;
  ::close(fd_);
  if (error != EWOULDBLOCK)
    throw FileError(fmt::format("cannot lock '{}': {}", file, std::strerror(error)));
  throw FileError(
      fmt::format("'{}' is in use: another run of this program has not ended", values_file));
}

ValuesLock::~ValuesLock() { ::close(fd_); }

KeptValues::KeptValues(const std::string& file, const std::vector<KeptVariable>& variables,
                       For what)
    : file_(file), variables_(variables) {
  if (what == For::Run) {
    lock_ = std::make_unique<ValuesLock>(file_);
    try_saving(file_);
  }
  saved_.resize(variables.size());
  std::error_code none;
  if (fs::symlink_status(file, none).type() == fs::file_type::not_found) return;
  WrittenValues values = read_values(read_file(file, kMostValues), variables);
  if (values.diagnostics.has_errors()) {
    const lang::Diagnostic& first = values.diagnostics.all().front();
    throw FileError(fmt::format("{}:{}:{}: {}: {}{}{}", file, first.place.line, first.place.column,
                                first.code, first.message, first.help.empty() ? "" : "; ",
                                first.help));
  }
  saved_ = std::move(values.saved);
  lines_ = std::move(values.lines);
  std::map<std::string, bool> declared;
  for (const KeptVariable& variable : variables) declared[lang::to_upper(variable.name)] = true;
  for (const auto& [key, line] : lines_) {
    if (declared.contains(key)) continue;
    warnings_.push_back(fmt::format(
        "{}:{}:{}: {}: the program has no PERSIST VAR {}; its value is "
        "kept",
        file, line.place.line, line.place.column, code::kValueUnknown, lang::shortened(line.name)));
  }
}

KeptValues::~KeptValues() { finish(); }

void KeptValues::set(std::size_t variable, std::string_view value) {
  const std::scoped_lock lock(mutex_);
  const std::string& name = variables_[variable].name;
  WrittenValues::Line& line = lines_[lang::to_upper(name)];
  if (line.text == value) return;
  line.name = name;
  line.text = value;
  unsaved_ = true;
  if (!saver_.joinable()) saver_ = std::thread([this] { save_from_time_to_time(); });
  changed_.notify_all();
}

std::string KeptValues::finish() {
  {
    const std::scoped_lock lock(mutex_);
    over_ = true;
    changed_.notify_all();
  }
  if (saver_.joinable()) saver_.join();
  lock_.reset();
  return std::exchange(failure_, "");
}

/// The first change is saved at once, all others a second after the save before. The disk is
/// waited for without the lock.
void KeptValues::save_from_time_to_time() {
  auto next = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return unsaved_ || over_; });
    changed_.wait_until(lock, next, [&] { return over_; });
    if (!unsaved_) return;
    unsaved_ = false;
    const auto lines = lines_;
    lock.unlock();
    next = std::chrono::steady_clock::now() + kBetweenSaves;
    std::string why = save(lines);
    lock.lock();
    failure_ = std::move(why);
  }
}

std::string KeptValues::save(const std::map<std::string, WrittenValues::Line>& lines) const {
  try {
    save_file(file_, text_of_values(lines));
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

}  // namespace rob::runtime

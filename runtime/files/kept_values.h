#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "runtime/files/written_values.h"

namespace rob::runtime {

/// Where the values of a program's PERSIST variables are kept: beside it, in NAME.values.
std::string values_file_of(const std::string& program_file);

/// A lock on the values of a program, which one run at a time has. It is on a file of its own: the
/// values file is replaced as often as it is saved.
class ValuesLock {
 public:
  /// Throws FileError where another run has it.
  explicit ValuesLock(const std::string& values_file);
  ~ValuesLock();
  ValuesLock(const ValuesLock&) = delete;
  ValuesLock& operator=(const ValuesLock&) = delete;

 private:
  int fd_;
};

/// The values of a program's PERSIST variables between runs. The thread that reports gives each new
/// value when its turn has come; a thread of its own saves them all, once a second at most and at
/// the end, whole or not at all.
class KeptValues {
 public:
  enum class For : std::uint8_t {
    Look,
    Run  ///< no other run may be under way, and it can be saved
  };

  /// Reads the file; it need not be there. Throws FileError, with line and column, for one that is
  /// not as it should be; and for a run where it is locked or cannot be saved.
  KeptValues(const std::string& file, const std::vector<KeptVariable>& variables, For what);
  /// As finish().
  ~KeptValues();
  KeptValues(const KeptValues&) = delete;
  KeptValues& operator=(const KeptValues&) = delete;

  const lang::SavedValues& saved() const { return saved_; }
  /// All lines of the file, by name in capitals.
  const std::map<std::string, WrittenValues::Line>& lines() const { return lines_; }
  /// A line for people for each name that no variable has.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// A variable, by its number, has this value.
  void set(std::size_t variable, std::string_view value);
  /// All is saved; or why not.
  std::string finish();

 private:
  void save_from_time_to_time();
  std::string save(const std::map<std::string, WrittenValues::Line>& lines) const;

  std::string file_;
  std::vector<KeptVariable> variables_;
  lang::SavedValues saved_;
  std::vector<std::string> warnings_;
  std::unique_ptr<ValuesLock> lock_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, WrittenValues::Line> lines_;
  bool unsaved_ = false;
  bool over_ = false;
  std::string failure_;
  std::thread saver_;
};

}  // namespace rob::runtime

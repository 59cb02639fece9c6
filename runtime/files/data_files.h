#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "runtime/files/data_folder.h"

namespace rob::runtime {

/// The files that programs WRITE and READ. Three threads meet here: the program asks; the thread
/// that reports hands over each line when its turn has come in motion order; and a thread of its
/// own writes them, and brings them to the disk each second and at the end.
class DataFiles {
 public:
  enum class Keeps : std::uint8_t {
    OnDisk,
    InMemory  ///< the program is foretold or tested: what it writes, it alone reads
  };

  /// `stepped`: on the virtual clock, where program and report share a thread.
  DataFiles(const std::string& folder, Keeps keeps, bool stepped);
  /// As finish().
  ~DataFiles();
  DataFiles(const DataFiles&) = delete;
  DataFiles& operator=(const DataFiles&) = delete;

  /// [choice] more than any program of a robot has
  static constexpr std::size_t kMostOpen = 16;
  static constexpr std::size_t kLongestLine = 65536;  ///< bytes

  // The program's thread
  /// Why it cannot WRITE to the file, or could not write before; it will, if nothing.
  std::optional<Words> admit(const std::string& name);
  /// Whether all lines whose turn had come when it was asked first are handed over. To be asked
  /// again until it is so.
  bool reported();
  bool exists(const std::string& name);
  /// With all lines that are handed over. Waits for the disk.
  std::optional<std::string> read(const std::string& name, std::optional<Words>& why);

  // The thread that reports
  void append(const std::string& name, std::string_view line);
  /// It has taken all that had come up to now.
  void drained() { drains_.fetch_add(1, std::memory_order_release); }
  /// All lines are on the disk; or why not, where the program does not know it.
  std::optional<Words> finish();

 private:
  struct Line {
    std::string name;
    std::string text;
  };
  struct Open {
    int fd = -1;
    bool dirty = false;  ///< not yet brought to the disk
  };

  void write_lines();
  void write(const Line& line);
  void sync();
  void fail(Words why);

  DataFolder folder_;
  const bool in_memory_;
  const bool stepped_;
  std::set<std::string> admitted_;  ///< the program's thread alone
  std::optional<std::int64_t> asked_;
  std::atomic<std::int64_t> drains_{0};

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Line> lines_;                      ///< to be written
  std::map<std::string, std::string> written_;  ///< in memory: all; on disk: names alone
  std::optional<Words> failure_;                ///< that the program does not know of yet
  bool over_ = false;
  bool idle_ = true;

  std::map<std::string, Open> open_;  ///< the writing thread alone
  std::thread writer_;
};

}  // namespace rob::runtime

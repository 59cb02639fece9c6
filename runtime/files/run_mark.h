#pragma once

#include <string>
#include <vector>

namespace rob::runtime {

/// A file that lasts as long as a run, in the user's folder for states ($XDG_STATE_HOME/rob, else
/// ~/.local/state/rob; without HOME there is none). Its lock ends with the process whatever ends
/// it, so a file without lock is of a run that was killed (fault 37).
class RunMark {
 public:
  /// `what` runs. Throws FileError.
  RunMark(const std::string& what, const std::string& robot);
  ~RunMark();
  RunMark(const RunMark&) = delete;
  RunMark& operator=(const RunMark&) = delete;

 private:
  std::string file_;
  int lock_ = -1;
};

/// A line for people for each run whose process has gone without an end; each is reported once.
std::vector<std::string> unclean_ends();

}  // namespace rob::runtime

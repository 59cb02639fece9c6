#pragma once

#include <signal.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace rob::test {

/// The reference device of Rob's own protocol in a process of its own (rob_device).
class DeviceProcess {
 public:
  /// What it says when it ends.
  struct End {
    std::vector<double> places;  ///< mm or deg
    double silence = 0;          ///< s, the longest without a reference while it was enabled
    double moved_for = 0;        ///< s from its first motion to the end of its last
  };

  explicit DeviceProcess(int axes) : axes_(axes) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    child_ = ::fork();
    if (child_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::execl(ROB_DEVICE, ROB_DEVICE, std::to_string(axes).c_str(), "60", nullptr);
      ::_exit(127);
    }
    ::close(ends[1]);
    out_ = ::fdopen(ends[0], "r");
    path_ = line();
  }
  ~DeviceProcess() {
    end();
    ::fclose(out_);
  }
  DeviceProcess(const DeviceProcess&) = delete;
  DeviceProcess& operator=(const DeviceProcess&) = delete;

  const std::string& path() const { return path_; }
  void end() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    child_ = 0;
  }
  End finish() {
    ::kill(child_, SIGTERM);
    std::istringstream words(line());
    std::string q;
    End end;
    end.places.resize(static_cast<std::size_t>(axes_));
    words >> q;
    for (double& place : end.places) words >> place;
    words >> end.silence >> end.moved_for;
    if (q != "Q" || words.fail()) throw std::runtime_error("the device does not tell its end");
    return end;
  }

 private:
  std::string line() {
    char text[256] = "";
    if (::fgets(text, sizeof text, out_) == nullptr) throw std::runtime_error("the device is mute");
    return std::string(text).substr(0, std::string(text).find('\n'));
  }

  int axes_;
  pid_t child_ = 0;
  FILE* out_ = nullptr;
  std::string path_;
};

}  // namespace rob::test

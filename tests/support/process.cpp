#include "tests/support/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace rob::test {

namespace fs = std::filesystem;

std::string read_whole_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  // An empty file sets the failbit of `text`, which is no failure.
  if (stream) text << stream.rdbuf();
  if (!stream || stream.bad()) throw std::runtime_error("cannot read " + file.string());
  return text.str();
}

namespace {

/// In the child; only what may be called between fork() and exec().
[[noreturn]] void become(char* const* argv, const char* out, const char* err) {
  die_with_parent();
  lead_group();
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  ::dup2(::open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  ::dup2(::open(out, kWrite | O_CLOEXEC, 0600), STDOUT_FILENO);
  ::dup2(::open(err, kWrite | O_CLOEXEC, 0600), STDERR_FILENO);
  ::execv(argv[0], argv);
  ::_exit(127);
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) name_ += (name_.empty() ? "" : " ") + argument;
  if (::access(arguments.front().c_str(), X_OK) != 0) {
    throw std::system_error(errno, std::generic_category(), arguments.front());
  }
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const std::string out_file = out();
  const std::string err_file = err();
  child_ = ::fork();
  if (child_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child_ == 0) become(argv.data(), out_file.c_str(), err_file.c_str());
}

Process::~Process() {
  if (!ended_) kill_group(child_);
}

void Process::send(int signal) const { ::kill(child_, signal); }

std::string Process::err_so_far() const {
  return std::filesystem::exists(err()) ? read_whole_file(err()) : "";
}

ProcessResult Process::wait(std::chrono::milliseconds patience) {
  const std::optional<int> exit_code = wait_for(child_, patience);
  if (!exit_code) {
    kill_group(child_);
    ended_ = true;
    throw std::runtime_error("'" + name_ + "' has not ended in " +
                             std::to_string(patience.count()) + " ms, and was killed");
  }
  ended_ = true;
  return {*exit_code, read_whole_file(out()), read_whole_file(err())};
}

ProcessResult run_process(const std::vector<std::string>& arguments) {
  return Process(arguments).wait();
}

}  // namespace rob::test

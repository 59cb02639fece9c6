// What `in_time` does with test cases that fail. The cases that it runs here are those of this
// binary that are skipped otherwise.
#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/process.h"
#include "tests/support/trials.h"

using namespace rob::test;

namespace {

/// The environment variable with the folder of the trials. Each trial of a case writes one byte
/// into the file of that case: in_time runs several cases at a time.
constexpr const char* kTrials = "ROB_TRIALS";

/// The number of this trial of the case, from 1.
std::size_t this_trial(const std::string& of_case) {
  const char* const folder = std::getenv(kTrials);
  REQUIRE(folder != nullptr);
  const std::filesystem::path file = std::filesystem::path(folder) / of_case;
  std::ofstream(file, std::ios::app) << '.';
  return read_whole_file(file).size();
}

/// in_time, which measures how late the computer is, stops for a while: as it does on a computer
/// that has no time for it.
void make_late() {
  ::kill(::getppid(), SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  ::kill(::getppid(), SIGCONT);
}

struct Outcome {
  bool passed = false;
  std::size_t trials = 0;
  std::string out;
};

/// Runs in_time on the case of that name.
Outcome in_time(const std::string& name) {
  const ScratchFolder scratch;
  ::setenv(kTrials, scratch.path().c_str(), 1);
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  const ProcessResult result = run_process({ROB_IN_TIME, self, "--no-skip", "--test-case=" + name});
  std::size_t trials = 0;
  for (const auto& of_case : std::filesystem::directory_iterator(scratch.path()))
    trials += of_case.file_size();
  return {result.exit_code == 0, trials, result.out + result.err};
}

/// The verdict over trials that end like this, and how many of them were made.
Verdict judged(std::initializer_list<Trial> trials, std::size_t* made = nullptr) {
  std::size_t number = 1;
  const Verdict verdict = judge_trials(*trials.begin(), [&] { return trials.begin()[number++]; });
  CHECK(number <= trials.size());
  if (made != nullptr) *made = number;
  return verdict;
}

constexpr Trial kPassed{true, false};
constexpr Trial kPassedLate{true, true};
constexpr Trial kFailed{false, false};
constexpr Trial kFailedLate{false, true};

}  // namespace

TEST_CASE("in_time: fails late once" * doctest::skip()) {
  if (this_trial("fails once") > 1) return;
  make_late();
  FAIL("late");
}

TEST_CASE("in_time: fails late twice" * doctest::skip()) {
  const std::size_t trial = this_trial("fails twice");
  make_late();
  CHECK(trial == 3);
}

TEST_CASE("in_time: passes" * doctest::skip()) { this_trial("passes"); }

TEST_CASE("in_time: hangs" * doctest::skip() * doctest::timeout(0.2)) {
  this_trial("hangs");
  for (;;) ::pause();
}

TEST_CASE("in_time runs a case that passes once") {
  const Outcome outcome = in_time("in_time: passes");
  CHECK(outcome.passed);
  CHECK(outcome.trials == 1);
  CHECK(outcome.out == "in_time: 0 of 1 cases failed; reruns: 0\n");
}

TEST_CASE("in_time runs a single case again when the computer was late; it must pass twice") {
  const Outcome once = in_time("in_time: fails late once,in_time: passes");
  CAPTURE(once.out);
  CHECK(once.passed);
  CHECK(once.trials == 3 + 1);  // of both cases
  CHECK(once.out.find("0 of 2 cases failed; reruns: 2\n") != std::string::npos);
  CHECK(once.out.find("this computer was late by") != std::string::npos);

  const Outcome twice = in_time("in_time: fails late twice");
  CAPTURE(twice.out);
  CHECK_FALSE(twice.passed);
  CHECK(twice.trials == 2);
  CHECK(twice.out.find("1 of 1 cases failed; reruns: 1\n") != std::string::npos);
}

TEST_CASE("in_time fails where a case hangs, and where there is none") {
  const Outcome hanging = in_time("in_time: hangs");
  CHECK_FALSE(hanging.passed);
  CHECK(hanging.out.find("This test case takes too long.") != std::string::npos);
  CHECK(hanging.out.find("TEST CASE:  in_time: hangs") != std::string::npos);
  CHECK_FALSE(in_time("in_time: no such case").passed);
}

TEST_CASE("a failure counts at once unless the computer was late") {
  std::size_t made = 0;
  CHECK_FALSE(judged({kFailed}, &made).passed);
  CHECK(made == 1);
  CHECK(judged({kPassedLate}, &made).passed);
  CHECK(made == 1);
  CHECK(judged({kFailedLate, kPassed, kPassed}, &made).passed);
  CHECK(made == 3);
  CHECK_FALSE(judged({kFailedLate, kPassed, kFailedLate}).passed);
  CHECK_FALSE(judged({kFailedLate, kFailedLate}).passed);
  CHECK(judged({kFailedLate, kPassed, kPassed}).reruns == 2);
}

TEST_CASE("reruns hardly help a test that fails in 60 % of its trials") {
  double passes = 0;
  for (int failing = 0; failing < 8; ++failing) {
    int trial = 0;
    double probability = 1;
    const auto next = [&] { return Trial{(failing >> trial++ & 1) == 0, true}; };
    const Trial first = next();
    const Verdict verdict = judge_trials(first, next);
    for (int i = 0; i < 3; ++i) probability *= (failing >> i & 1) != 0 ? 0.6 : 0.4;
    if (verdict.passed) passes += probability;
  }
  CHECK(passes == doctest::Approx(0.4 + 0.6 * 0.4 * 0.4));
}

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <csignal>

#include "tests/support/child.h"

namespace {

/// [choice] Above that of the programs that a test case starts: their message names more.
constexpr double kLongestCase = std::chrono::duration<double>(rob::test::kLongestRun).count() + 60;

void send_alarm_in(double seconds) {
  const double whole = std::floor(seconds);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - whole));
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

/// doctest reports an abort with the name of the test case.
void abort_case(int /*signal*/) {
  constexpr char kMessage[] = "This test case takes too long.\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kMessage, sizeof kMessage - 1);
  ::raise(SIGABRT);
}

/// Ends the whole binary when a test case takes longer than kLongestCase, or than its decorator
/// doctest::timeout() says.
class TimeLimit : public doctest::IReporter {
 public:
  explicit TimeLimit(const doctest::ContextOptions& /*options*/) {}

  void test_case_start(const doctest::TestCaseData& test_case) override {
    std::signal(SIGALRM, abort_case);
    send_alarm_in(test_case.m_timeout > 0 ? test_case.m_timeout : kLongestCase);
  }
  void test_case_end(const doctest::CurrentTestCaseStats& /*stats*/) override { send_alarm_in(0); }

  void report_query(const doctest::QueryData& /*data*/) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats& /*stats*/) override {}
  void test_case_reenter(const doctest::TestCaseData& /*test_case*/) override {}
  void test_case_exception(const doctest::TestCaseException& /*exception*/) override {}
  void subcase_start(const doctest::SubcaseSignature& /*signature*/) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData& /*data*/) override {}
  void log_message(const doctest::MessageData& /*data*/) override {}
  void test_case_skipped(const doctest::TestCaseData& /*test_case*/) override {}
};

}  // namespace

REGISTER_LISTENER("time_limit", 1, TimeLimit);

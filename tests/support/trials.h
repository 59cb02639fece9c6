#pragma once

namespace rob::test {

/// One run of a test in real time.
struct Trial {
  bool passed = false;
  bool late = false;  ///< the computer was late meanwhile
};

/// What becomes of a test in real time after all its trials.
struct Verdict {
  bool passed = false;
  int reruns = 0;
};

/// Judges a test in real time by its first trial, and by `rerun()`, which returns a further one. A
/// failure counts unless the computer was late meanwhile. After a late failure the test must pass
/// twice in a row. So a test that fails in 60 % of its trials passes with the probability
/// 0.4 + 0.6·0.4² = 0.50 even if the computer is always late; one pass out of three trials would
/// let it pass with 1 − 0.6³ = 0.78.
template <typename Rerun>
Verdict judge_trials(const Trial& first, Rerun&& rerun) {
  if (first.passed || !first.late) return {first.passed, 0};
  if (!rerun().passed) return {false, 1};
  return {rerun().passed, 2};
}

}  // namespace rob::test

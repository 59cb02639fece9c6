#pragma once

#include <random>

#include "motion/dynamics/ums7_dynamics.h"

namespace rob::test {

/// Within reach of rounding a plain arm: 2.4 kg·m² of upper arm, 0.9 of forearm, a hand of 2.4 Nm;
/// it carries 2 kg.
inline motion::Ums7Parameters plain_arm() {
  motion::Ums7Parameters p;
  p.c0 = 0.8;
  p.c1 = 2.4;
  p.c2 = 2.24;
  p.c3 = 0.9;
  p.c4 = 3.3;
  p.c5 = 1.12;
  p.c6 = 2.4;
  p.c7 = 0.03;
  p.c8 = 0.004;
  return motion::with_payload(p, 2, 0.4, 0.4, 0.1);
}

/// Six values of -most … most.
inline motion::JointVector random_six(std::mt19937& random, double most) {
  std::uniform_real_distribution<double> value(-most, most);
  motion::JointVector v(6);
  for (int i = 0; i < 6; ++i) v[i] = value(random);
  return v;
}

inline motion::JointVector axis(int i, double value) {
  motion::JointVector v = motion::JointVector::Zero(6);
  v[i] = value;
  return v;
}

}  // namespace rob::test

#include "motion/ahead/reachable.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace rob::motion;

namespace {

Piece random_piece(std::mt19937& random, int terms) {
  std::uniform_real_distribution<double> any(-1, 1);
  Piece piece;
  piece.count = terms;
  piece.length = 0.001 + 0.05 * std::abs(any(random));
  const auto vector = [&](double size) {
    JointVector v(3);
    for (int i = 0; i < 3; ++i) v[i] = size * any(random);
    return v;
  };
  for (int k = 0; k < terms; ++k) piece.terms[static_cast<std::size_t>(k)] = vector(k < 2 ? 1 : 10);
  piece.acceleration = JointVector::Constant(3, 1) + 0.5 * vector(1);
  return piece;
}

/// Whether one σ'' leads from x to at most `end` with every axis within its acceleration at both
/// ends: by trying very many.
bool leads(const Piece& piece, double x, double end, double tolerance) {
  const PathPoint a = piece.point(0);
  const PathPoint b = piece.point(piece.length);
  const double low = -x / (2 * piece.length);
  const double high = (end - x) / (2 * piece.length);
  constexpr int kTries = 20000;
  for (int i = 0; i <= kTries; ++i) {
    const double u = low + (high - low) * i / kTries;
    const double after = x + 2 * u * piece.length;
    bool within = true;
    for (int k = 0; k < 3; ++k) {
      const double most = piece.acceleration[k] * (1 + tolerance);
      within = within && std::abs(a.qd[k] * u + a.qdd[k] * x) <= most &&
               std::abs(b.qd[k] * u + b.qdd[k] * after) <= most;
    }
    if (within) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("on a straight piece the square rises by 2·a·length") {
  Piece piece;
  piece.length = 0.1;
  piece.terms[0] = JointVector::Zero(2);
  piece.terms[1].resize(2);
  piece.terms[1] << 0.6, 0.8;
  piece.acceleration = JointVector::Constant(2, 1);
  CHECK(reachable_square(piece, 0.04, 10) == doctest::Approx(0.04 + 2 * 0.1 / 0.8));
  CHECK(reachable_square(piece, 0.04, 0.1) == 0.1);
}

TEST_CASE("the greatest square leads to the end, and no greater one does") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  int bounded = 0;
  for (int i = 0; i < 60; ++i) {
    const Piece piece = random_piece(random, 3);
    const double end = 0.2 * any(random);
    const double cap = 0.5;
    const double x = reachable_square(piece, end, cap);
    REQUIRE(x >= 0);
    CHECK(leads(piece, x, end, 1e-3));
    if (x >= cap) continue;
    ++bounded;
    CHECK_FALSE(leads(piece, 1.01 * x + 1e-6, end, -1e-6));
  }
  CHECK(bounded > 20);
}

TEST_CASE("each smaller square leads there, too") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 40; ++i) {
    const Piece piece = random_piece(random, 3);
    const double x = reachable_square(piece, 0.1, 0.5);
    CHECK(leads(piece, x * any(random), 0.1, 1e-3));
  }
}

TEST_CASE("an axis that hardly moves and is bent a little too much asks for no great control") {
  Piece piece;
  piece.count = 3;
  piece.length = 0.003;
  for (auto& term : piece.terms) term = JointVector::Zero(2);
  piece.terms[1] << -1e-4, -0.85;
  piece.terms[2] << -32, 2;
  piece.acceleration = JointVector::Constant(2, 1);
  const double x = 1.001 / 64;  // the first axis is asked for 1.001 of what it has
  const PathPoint here = piece.point(0);
  const ControlRange range = control_range(piece, here, piece.point(piece.length), piece.length, x);
  for (const double u : {range.low, range.high}) {
    for (int i = 0; i < 2; ++i)
      CHECK(std::abs(here.qd[i] * u + here.qdd[i] * x) <= 1.01 * piece.acceleration[i]);
  }
}

TEST_CASE("braking evenly keeps the axes on all of a piece") {
  std::mt19937 random(9);
  for (int i = 0; i < 40; ++i) {
    const Piece piece = random_piece(random, 3);
    const double x = 0.05;
    const double u = -even_braking(piece, piece.point(0), piece.point(piece.length), x);
    for (int k = 0; k <= 20; ++k) {
      const double at = piece.length * k / 20;
      const PathPoint p = driven(piece.point(at), std::sqrt(x), u);
      for (int a = 0; a < 3 && u < 0; ++a)
        CHECK(std::abs(p.qdd[a]) <= piece.acceleration[a] * (1 + 1e-9));
    }
  }
}

TEST_CASE("where a bend rises from nothing the axes are held within the piece, too") {
  // Axis 1 brakes with u = −1 at most; axis 2, q = s³/6, asks for x·s − 2.5·s² then: for x²/10, at
  // s = x/5.
  Piece piece;
  piece.count = 4;
  piece.length = 0.01;
  for (int k = 0; k < 4; ++k) piece.terms[static_cast<std::size_t>(k)] = JointVector::Zero(2);
  piece.terms[1][0] = 1;
  piece.terms[3][1] = 1.0 / 6;
  piece.acceleration = JointVector::Constant(2, 1);
  for (double p = 0.42; p < 1; p += 0.01) {
    CAPTURE(p);
    const double exact = 5 * p * piece.length;
    piece.acceleration[1] = exact * exact / 10;
    const double x = reachable_square(piece, 1, 1);
    CHECK(x >= exact * (1 - 1e-6));
    CHECK(x * x / 10 <= 1.021 * piece.acceleration[1]);
    const ControlRange range =
        control_range(piece, piece.point(0), piece.point(piece.length), piece.length, x);
    CHECK(range.low == doctest::Approx(-1).epsilon(1e-3));
    CHECK(range.high == doctest::Approx(-1).epsilon(1e-2));
  }
}

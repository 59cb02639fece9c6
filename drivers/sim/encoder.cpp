#include "drivers/sim/encoder.h"

#include <array>
#include <cmath>

namespace rob::drivers {
namespace {

// Below this share of a count the filter is at rest. Without it the estimate would decay for ever,
// into denormal numbers that cost a hundred times the cycles.
constexpr double kAtRest = 1e-6;

// A sum with 1.5·2^52 has no room for a fraction: rounds to whole numbers, as processors do, ties
// to even, up to 2^51.
constexpr double kRounds = 6755399441055744.0;

double decay() noexcept { return std::exp(-Encoder::kBandwidth * Encoder::kPeriod); }

}  // namespace

/// x and v after n samples that lie d beside the x before them:
///     x + x_of_v[n]·v + Σ x_of_d[last − (n − 1 − k)]·d_k, and v likewise.
struct Encoder::Response {
  Block x_of_d{kBlock};
  Block v_of_d{kBlock};
  std::array<double, kBlock + 1> x_of_v{};
  std::array<double, kBlock + 1> v_of_v{};

  Response() noexcept {
    const double p = decay();
    const double beta = (1 - p) * (1 - p);
    const auto step = [&](double& x, double& v, double d) {
      const double r = d - (x + v * kPeriod);
      x = d - p * p * r;
      v += beta * r / kPeriod;
    };
    double x = 0;
    double v = 0;
    step(x, v, 1);  // one sample that lies beside the others, and what is left of it
    for (int i = kBlock - 1; i >= 0; --i) {
      x_of_d[i] = x;
      v_of_d[i] = v;
      step(x, v, 0);
    }
    x = 0;
    v = 1;
    for (std::size_t n = 0; n <= kBlock; ++n) {
      x_of_v[n] = x;
      v_of_v[n] = v;
      step(x, v, 0);
    }
  }
};

const Encoder::Response& Encoder::response() noexcept {
  static const Response response;
  return response;
}

Encoder::Encoder(double resolution) : resolution_(resolution), per_metre_(1 / resolution) {
  response();  // made here, not in the tick
  const double p = decay();
  alpha_ = 1 - p * p;
  beta_ = (1 - p) * (1 - p);
}

double Encoder::position(double q) const noexcept {
  return (q * per_metre_ + kRounds - kRounds) * resolution_;
}

void Encoder::sample(double q) noexcept {
  const double count = position(q);
  const double r = count - (x_ + v_ * kPeriod);
  x_ = count - (1 - alpha_) * r;
  v_ += beta_ * r / kPeriod;
  const double rest = kAtRest * resolution_;
  if (std::abs(r) < rest && std::abs(v_) * kPeriod < rest) settle(count, 0);
}

void Encoder::sample(const Block& q) noexcept {
  const Response& made = response();
  const auto n = static_cast<std::size_t>(q.size());
  const Block beside = (q * per_metre_ + kRounds - kRounds) * resolution_ - x_;
  const double x = x_;
  x_ += made.x_of_v[n] * v_ + (made.x_of_d.tail(q.size()) * beside).sum();
  v_ = made.v_of_v[n] * v_ + (made.v_of_d.tail(q.size()) * beside).sum();
  const double count = x + beside[q.size() - 1];
  const double rest = kAtRest * resolution_;
  if (std::abs(count - x_) < rest && std::abs(v_) * kPeriod < rest) settle(count, 0);
}

void Encoder::settle(double q, double v) noexcept {
  x_ = position(q);
  v_ = v;
}

}  // namespace rob::drivers

#include "drivers/contact/drawn_cell.h"

#include "drivers/contact/noise.h"

namespace rob::drivers {

using motion::Between;
using motion::CellData;

namespace {

double drawn(Noise& noise, const Between& range) noexcept {
  return noise.between(range.low, range.high);
}

Eigen::Vector3d drawn_vector(Noise& noise, const Between& range) noexcept {
  const double x = drawn(noise, range);
  const double y = drawn(noise, range);
  const double z = drawn(noise, range);
  return {x, y, z};
}

/// Points of the square until one lies in the disc: that takes no function of a library.
Eigen::Vector2d drawn_in_disc(Noise& noise, double radius) noexcept {
  Eigen::Vector2d place;
  do {
    place.x() = noise.between(-radius, radius);
    place.y() = noise.between(-radius, radius);
  } while (place.squaredNorm() > radius * radius);
  return place;
}

}  // namespace

CellData drawn_cell(const CellData& cell, std::uint64_t seed) {
  CellData other = cell;
  other.seed = seed;
  if (!cell.spread) return other;
  const motion::CellSpread& spread = *cell.spread;
  Noise noise(~seed);  // not the numbers that the sensor draws
  other.contact.stiffness = drawn(noise, spread.stiffness);
  other.contact.damping_time = drawn(noise, spread.damping_time);
  other.contact.friction = drawn(noise, spread.friction);
  other.sensor.force_noise = drawn(noise, spread.force_noise);
  other.sensor.torque_noise = drawn(noise, spread.torque_noise);
  other.sensor.force_bias = drawn_vector(noise, spread.force_bias);
  other.sensor.torque_bias = drawn_vector(noise, spread.torque_bias);
  other.sensor.delay = drawn(noise, spread.delay);
  other.cap.running_torque = drawn(noise, spread.running_torque);
  other.cap.slip_torque = drawn(noise, spread.slip_torque);
  for (motion::RackData& rack : other.racks)
    if (!rack.error.isZero(0)) rack.error = drawn_in_disc(noise, spread.hole_error);
  return other;
}

}  // namespace rob::drivers

#pragma once

#include <string>

/// The drawings of docs/motion.md.
namespace rob::test {

struct Drawing {
  double width = 880;
  double height = 0;
  std::string content;
};

/// A corner under both laws, with the same greatest acceleration.
Drawing corner_drawing();
/// The speed along a path: what can be braked from, and what is driven.
Drawing speed_drawing();
/// A motion and its mean over a window.
Drawing mean_drawing();
/// Speed and acceleration of the published triangle on the gantry, from traces that `rob` writes:
/// under Paul's law, look-ahead without and with a bound of the jerk.
Drawing triangle_drawing(const std::string& rob);

/// The last 26 s of examples/20_capping.rob: force, torque, axis 6 (S4).
Drawing capping_drawing(const std::string& rob, const std::string& examples);

}  // namespace rob::test

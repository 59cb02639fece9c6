#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lang/values/pose_math.h"

namespace rob::runtime {

/// Asks for the positions that a FRAME or a TOOL is made of, one after the other.
class PointWizard {
 public:
  enum class Makes : std::uint8_t { Frame, Tool };

  /// `tip`: the TOOL that touches the places of a frame; empty: the flange does.
  PointWizard(Makes makes, std::string name, std::string tip)
      : makes_(makes), name_(std::move(name)), tip_(std::move(tip)) {}

  /// ":frame" or ":tool".
  const char* command() const { return makes_ == Makes::Frame ? ":frame" : ":tool"; }
  const std::string& name() const { return name_; }
  /// The flange, in the world; m.
  void take(const lang::PoseValue& flange) { flanges_.push_back(flange); }
  void begin_again() { flanges_.clear(); }
  /// There are as many as it takes, and as many as it can take.
  bool enough() const;
  bool full() const;
  /// Says what the next position is; for a tool, also what those before show.
  std::string question() const;
  /// "FRAME table = FRAME3(…)": a line of a program.
  std::string declaration() const;

 private:
  std::string found() const;

  Makes makes_;
  std::string name_;
  std::string tip_;
  std::vector<lang::PoseValue> flanges_;
};

}  // namespace rob::runtime

#pragma once

#include <cstdint>
#include <vector>

#include "drivers/contact/cap_thread.h"
#include "drivers/contact/hole.h"
#include "drivers/contact/rack_grid.h"
#include "motion/cell/cell_data.h"

namespace rob::drivers {

/// The gripper's point between its jaws, in the world. SI.
struct ToolMotion {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  double turn = 0;  ///< rad about the vertical, clockwise as seen from above; counted without end
};

/// The force and torque of the cell on the tool, along the world's axes.
struct Reaction {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< where the force acts
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  double torque = 0;  ///< about the vertical, Nm
};

/// A table with racks of holes, tubes and caps, and a gripper that points down. The scene computes
/// the contacts of the tool, and keeps track of the parts that the gripper takes and leaves.
///
/// Tubes and caps stand upright, in the gripper too, and weigh nothing (0.2 N are within a sensor's
/// noise). The gripper centres a part between its jaws. The caller prescribes the motion of the
/// tool: the contacts contain the stiffness of everything, arm included, so a contact never moves
/// the arm. Fingers do not touch the neighbours of the part that they grip.
///
/// Every call but the constructor may be used in the tick.
class CellScene {
 public:
  /// Longest step in contact, s.
  static constexpr double kStep = 0.25e-3;

  explicit CellScene(const motion::CellData& cell);

  /// The tool moves on for `dt`, s.
  void step(const ToolMotion& tool, double dt) noexcept;
  /// The jaws have closed: they take the cap or the tube that is between them, if there is one.
  void close_jaws() noexcept;
  /// The jaws begin to open: what they hold stays where it stands, or falls over and is lost.
  void open_jaws() noexcept;

  const Reaction& reaction() const noexcept { return reaction_; }
  bool touching() const noexcept { return touching_; }
  /// Whether a tool there would touch something.
  bool would_touch(const ToolMotion& tool) const noexcept;
  bool holds_something() const noexcept { return held_ != Held::Nothing; }
  /// m from the tip down to the lower end of what is held; 0 if nothing is.
  double below_tip() const noexcept { return below_tip_; }

  // For tests and benches
  bool holds_tube() const noexcept { return held_ == Held::Tube; }
  bool holds_cap() const noexcept { return held_ == Held::Cap; }
  int dropped() const noexcept { return dropped_; }
  /// Where the lower end of what is carried really is.
  const Eigen::Vector3d& foot() const noexcept { return foot_.place; }
  bool occupied(int hole) const noexcept { return tube_in(hole) != kNone; }
  bool capped(int hole) const noexcept;
  /// rad that the cap of the tube in `hole` is on; 0 without one.
  double cap_turned(int hole) const noexcept;
  const RackGrid& racks() const noexcept { return racks_; }

 private:
  static constexpr int kNone = -1;
  enum class Held : std::uint8_t { Nothing, Tube, Cap };

  struct Tube {
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();
    int hole = kNone;  // none: it is in the gripper, or lost
    bool capped = false;
    double turned = 0;  // rad of the cap's thread that are on
  };

  int tube_in(int hole) const noexcept { return in_hole_[static_cast<std::size_t>(hole)]; }
  Tube& tube(int number) noexcept { return tubes_[static_cast<std::size_t>(number)]; }
  const Tube& tube(int number) const noexcept { return tubes_[static_cast<std::size_t>(number)]; }
  Tube& held_tube() noexcept { return tube(held_number_); }
  int standing_at(double x, double y) const noexcept;
  double cap_bottom(const Tube& tube) const noexcept;
  double top(const Tube& tube) const noexcept;
  int under_cap(const Eigen::Vector3d& cap) const noexcept;
  const motion::CapSupplyData* supply_at(const Eigen::Vector3d& place) const noexcept;
  double obstacle(const Eigen::Vector3d& place) const noexcept;
  Carried carried(const ToolMotion& tool) const noexcept;
  // Contact
  Pressed touch(const ToolMotion& tool, double dt, Foot& foot) const noexcept;
  Pressed touch_top(const Carried& end, const Foot& foot) const noexcept;
  Pressed touch_empty(const ToolMotion& tool) const noexcept;
  void turn_cap(double way) noexcept;
  void begin_thread(double sunk) noexcept;
  // Taking and leaving
  void take(Held held, int number, const Eigen::Vector3d& lower_end) noexcept;
  bool take_standing(int number) noexcept;
  void leave_tube() noexcept;
  void unscrew() noexcept;
  void leave_cap() noexcept;

  motion::CellData cell_;
  RackGrid racks_;
  ContactLaw law_;
  Sinking sinking_;
  CapThread thread_;
  std::vector<Tube> tubes_;
  std::vector<int> in_hole_;  // the number of the tube in each hole

  ToolMotion tool_;
  Held held_ = Held::Nothing;
  int held_number_ = kNone;  // of the tube held, by its cap or its body, or under the cap held
  bool by_cap_ = false;
  double below_tip_ = 0;  // m from the tip down to the lower end of what is held
  Foot foot_;             // that lower end
  Reaction reaction_;
  bool touching_ = false;
  int dropped_ = 0;
};

}  // namespace rob::drivers

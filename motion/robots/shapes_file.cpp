#include "motion/robots/shapes_file.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/unit_factors.h"

namespace rob::motion {

namespace {

// [choice] From a microscope's stage to a port crane; a slip in a unit is out of it.
constexpr Range kBodyPlace{-100, 100};
constexpr Range kBodyTurn{-kFullTurn, kFullTurn};
constexpr Range kBodyMeasure{1e-5, 100};
constexpr Range kClearanceRange{0, 1};
constexpr std::size_t kMostObstacles = 1000;  // [choice] each costs time at every look

Eigen::Vector3d three_lengths(const TableReader& table, std::string_view key, Range range) {
  const std::vector<double> values = table.quantities(key, Quantity::Length, range, 3);
  return {values[0], values[1], values[2]};
}

Capsule read_capsule(const TableReader& table) {
  return {three_lengths(table, "from", kBodyPlace), three_lengths(table, "to", kBodyPlace),
          table.quantity("radius", Quantity::Length, kBodyMeasure)};
}

/// `name`: where the file gives none.
void read_body(const TableReader& owner, std::string name, int frame, CollisionData& data) {
  Body body{owner.has("link") ? owner.text("link") : std::move(name), frame, {}};
  for (const TableReader& table : owner.tables("shape", {"kind", "from", "to", "radius"})) {
    table.choice("kind", {"capsule"});
    body.shapes.push_back(read_capsule(table));
  }
  if (body.shapes.size() > kMostCapsules) owner.fail("shape", "more than three capsules");
  if (body.shapes.empty()) return;
  const bool taken =
      std::ranges::any_of(data.bodies, [&](const Body& other) { return other.name == body.name; });
  if (taken)
    owner.fail(owner.has("link") ? "link" : "shape",
               "there is another body of the name " + body.name + ": give it a `link` of its own");
  data.bodies.push_back(std::move(body));
}

/// Where the box stands, and how it is turned; both may be left out.
Pose read_body_pose(const TableReader& table) {
  Pose pose;
  if (table.has("place")) pose.position = three_lengths(table, "place", kBodyPlace);
  if (table.has("turn")) {
    const std::vector<double> turn = table.quantities("turn", Quantity::Angle, kBodyTurn, 3);
    pose.orientation = orientation_from({turn[0], turn[1], turn[2]});
  }
  return pose;
}

MeshObstacle read_mesh(const TableReader& table) {
  return {.name = table.name("name"),
          .file = table.path("file"),
          .place = read_body_pose(table),
          .where = table.where("file")};
}

/// Each kind has its own keys; others would be a slip.
void refuse_others(const TableReader& table, const std::vector<std::string_view>& own) {
  for (const std::string_view key :
       {"place", "turn", "size", "radius", "from", "to", "height", "file"})
    if (table.has(key) && std::ranges::find(own, key) == own.end())
      table.fail(key, "does not belong to an obstacle of this kind");
}

Obstacle read_obstacle(const TableReader& table) {
  Obstacle obstacle{.name = table.name("name"), .shape = HalfSpace{}};
  switch (table.choice("kind", {"box", "sphere", "capsule", "table", "mesh"})) {
    case 0:
      refuse_others(table, {"place", "turn", "size"});
      obstacle.shape = Box{read_body_pose(table), three_lengths(table, "size", kBodyMeasure) / 2};
      break;
    case 1:
      refuse_others(table, {"place", "radius"});
      obstacle.shape = Sphere{three_lengths(table, "place", kBodyPlace),
                              table.quantity("radius", Quantity::Length, kBodyMeasure)};
      break;
    case 2:
      refuse_others(table, {"from", "to", "radius"});
      obstacle.shape = read_capsule(table);
      break;
    default:
      refuse_others(table, {"height"});
      obstacle.shape = HalfSpace{table.quantity("height", Quantity::Length, kBodyPlace)};
  }
  return obstacle;
}

bool is_body(const CollisionData& data, const std::string& name) {
  return std::ranges::any_of(data.bodies, [&](const Body& body) { return body.name == name; });
}

bool is_obstacle(const std::string& name, const CollisionData& data) {
  const auto same = [&](const auto& other) { return other.name == name; };
  return std::ranges::any_of(data.obstacles, same) || std::ranges::any_of(data.meshes, same);
}

void read_obstacles(const TableReader& file, CollisionData& data) {
  const std::vector<TableReader> tables = file.tables(
      "obstacle",
      {"name", "kind", "place", "turn", "size", "radius", "from", "to", "height", "file"});
  if (tables.size() > kMostObstacles)
    file.fail("obstacle", "more than " + std::to_string(kMostObstacles) + " of them");
  for (const TableReader& table : tables) {
    const std::string& name = table.name("name");
    if (is_obstacle(name, data)) table.fail("name", "there is another obstacle of this name");
    if (is_body(data, name)) table.fail("name", "a body of the robot has this name");
    if (table.text("kind") == "mesh") {
      refuse_others(table, {"file", "place", "turn"});
      data.meshes.push_back(read_mesh(table));
    } else {
      data.obstacles.push_back(read_obstacle(table));
    }
  }
}

void read_apart(const TableReader& file, CollisionData& data) {
  const auto known = [&](const std::string& name) {
    const auto same = [&](const auto& thing) { return thing.name == name; };
    return std::ranges::any_of(data.bodies, same) || is_obstacle(name, data);
  };
  for (const TableReader& table : file.tables("apart", {"first", "second"})) {
    for (const std::string_view key : {"first", "second"})
      if (!known(table.text(key))) table.fail(key, "no body or obstacle has this name");
    if (table.text("first") == table.text("second"))
      table.fail("second", "the same as `first`: a pair is two bodies, or a body and an obstacle");
    data.apart.emplace_back(table.text("first"), table.text("second"));
  }
}

/// The table, and each rack as the body that its holes are in, at which the hand works. Tubes and
/// caps are there to be taken.
void add_cell(const CellData& cell, CollisionData& data) {
  data.obstacles.push_back({.name = "table", .shape = HalfSpace{cell.table}});
  int number = 0;
  for (const RackData& rack : cell.racks) {
    // The middle of the outer holes, and half a pitch of wall around them.
    const Eigen::Vector3d size(rack.columns * rack.pitch, rack.rows * rack.pitch,
                               rack.face - cell.table);
    const Eigen::Vector3d middle(rack.x + (rack.columns - 1) * rack.pitch / 2,
                                 rack.y + (rack.rows - 1) * rack.pitch / 2,
                                 cell.table + size.z() / 2);
    data.obstacles.push_back({.name = "rack_" + std::to_string(++number),
                              .shape = Box{{middle, Eigen::Quaterniond::Identity()}, size / 2},
                              .hand_may_touch = true});
  }
}

/// A body without a `link` is called as its axis, and base and flange so: where an axis has that
/// name they get another.
std::string free_name(const std::vector<TableReader>& axes, const RobotModel& robot,
                      const char* usual, const char* other) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string& name = axes[i].has("link") ? axes[i].text("link") : robot.axes[i].name;
    if (name == usual) return other;
  }
  return usual;
}

/// The names of what stands in the cell are given.
void refuse_names_of_cell(const TableReader& file, const CollisionData& data) {
  for (const Obstacle& obstacle : data.obstacles)
    if (is_body(data, obstacle.name))
      file.fail("cell", "a body has the name " + obstacle.name + ", which is one of the cell's");
}

}  // namespace

void read_shapes(const TableReader& file, const std::vector<TableReader>& axes, RobotModel& robot) {
  CollisionData& data = robot.collision;
  if (file.has("base"))
    read_body(file.table("base", {"link", "shape"}), free_name(axes, robot, "base", "foot"), 0,
              data);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    read_body(axes[i], robot.axes[i].name, static_cast<int>(i) + 1, data);
  }
  if (file.has("flange"))
    read_body(file.table("flange", {"link", "shape"}), free_name(axes, robot, "flange", "hand"),
              robot.axis_count() + 1, data);
  if (robot.cell) add_cell(*robot.cell, data);
  refuse_names_of_cell(file, data);
  read_obstacles(file, data);
  read_apart(file, data);
  if (file.has("clearance"))
    data.clearance = file.quantity("clearance", Quantity::Length, kClearanceRange);
}

void read_cell(std::string_view text, std::string_view file_name, CollisionData& data) {
  const toml::table table = parsed_toml(text, file_name);
  read_obstacles(TableReader(table, file_name, "", {"obstacle"}), data);
}

}  // namespace rob::motion

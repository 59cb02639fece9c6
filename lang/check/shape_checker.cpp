#include "lang/check/shape_checker.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
namespace {

using Kind = Obstacle::Kind;

/// Bodies that every robot has, whatever its file says.
constexpr std::array<std::string_view, 2> kHandBodies{"gripper", "part"};

/// The brackets of a shape hold these.
struct ShapeForm {
  std::size_t values;
  std::string_view example;
};

/// By Obstacle::Kind.
constexpr std::array<ShapeForm, 4> kShapeForms{
    {{4, "BOX(POSE(100mm, 0mm, 20mm), 80mm, 60mm, 40mm)"},
     {2, "SPHERE((100mm, 0mm, 50mm), 40mm)"},
     {3, "CAPSULE((100mm, 0mm, 0mm), (100mm, 0mm, 300mm), 25mm)"},
     {2, "MESH(POSE(100mm, 0mm, 0mm), \"rack.stl\")"}}};

const ShapeForm& form_of(Kind kind) { return kShapeForms[static_cast<std::size_t>(kind)]; }

/// The name as `names` spell it; empty if it is none of them.
std::string_view spelled_among(const std::vector<std::string>& names, std::string_view name) {
  const auto found =
      std::ranges::find_if(names, [&](const std::string& one) { return same_word(one, name); });
  return found == names.end() ? std::string_view() : std::string_view(*found);
}

void add_obstacles(const Block& statements, std::vector<std::string>& names) {
  for (const Statement& statement : statements) {
    if (const auto* const obstacle = std::get_if<ObstacleDeclaration>(&statement.node))
      names.push_back(obstacle->declared.name);
    if (const auto* const use = std::get_if<Use>(&statement.node))
      add_obstacles(use->declarations, names);
  }
}

}  // namespace

void ShapeChecker::check(ObstacleDeclaration& obstacle) {
  const std::size_t told = diagnostics_.error_count();
  if (!check_name(obstacle) || obstacle.values.empty() || !check_count(obstacle)) return;
  obstacle.obstacle = {
      .name = obstacle.declared.name, .place = obstacle.shape_place, .kind = obstacle.kind};
  check_values(obstacle);
  if (diagnostics_.error_count() > told) obstacle.values.clear();
}

/// A name stands for one thing. At the prompt an obstacle may be declared anew.
bool ShapeChecker::check_name(const ObstacleDeclaration& obstacle) {
  const Declaration::Declared& declared = obstacle.declared;
  const auto taken = [&](std::string by) {
    diagnostics_.error(code::kObstacleTwice, declared.place,
                       fmt::format("{} {}", shortened(declared.name), by),
                       "give the OBSTACLE another name");
    return false;
  };
  const auto [earlier, is_new] = obstacles_.try_emplace(to_upper(declared.name), declared.place);
  if (!is_new && program_.entry == 0)
    return taken(fmt::format("is an OBSTACLE already, in line {}", earlier->second.line));
  if (!spelled_among(robot_.obstacles, declared.name).empty())
    return taken("is an obstacle of the robot's file or cell already");
  const bool hand = std::ranges::any_of(
      kHandBodies, [&](std::string_view one) { return same_word(one, declared.name); });
  if (hand || !spelled_among(robot_.bodies, declared.name).empty())
    return taken("is a body of the robot");
  return true;
}

bool ShapeChecker::check_count(const ObstacleDeclaration& obstacle) {
  const ShapeForm& form = form_of(obstacle.kind);
  if (obstacle.values.size() == form.values) return true;
  diagnostics_.error(
      code::kNoObstacleShape, obstacle.shape_place,
      fmt::format("{} takes {} values; these are {}",
                  form.example.substr(0, form.example.find('(')), form.values,
                  obstacle.values.size()),
      fmt::format("OBSTACLE {} = {}", shortened(obstacle.declared.name), form.example));
  return false;
}

void ShapeChecker::check_values(ObstacleDeclaration& declaration) {
  const std::vector<ExprPtr>& values = declaration.values;
  Obstacle& obstacle = declaration.obstacle;
  switch (declaration.kind) {
    case Kind::Box:
      obstacle.pose = pose(values[0], "the centre of a BOX needs");
      obstacle.size = {length(values[1], "the dx of a BOX"), length(values[2], "the dy of a BOX"),
                       length(values[3], "the dz of a BOX")};
      return;
    case Kind::Sphere:
      obstacle.round = {vector(values[0], "the centre of a SPHERE needs"),
                        {},
                        length(values[1], "the radius of a SPHERE")};
      obstacle.round.to = obstacle.round.from;
      return;
    case Kind::Capsule:
      obstacle.round = capsule(values[0], values[1], values[2]);
      return;
    case Kind::Mesh:
      obstacle.pose = pose(values[0], "the place of a MESH needs");
      obstacle.file = file(values[1]);
      return;
  }
}

/// The slots of a value that must be known now; null after an error.
const std::vector<double>* ShapeChecker::constant(const ExprPtr& value, const Type& wanted,
                                                  std::string_view needed) {
  if (!expressions_.check_as(value, wanted, needed) || !value->type.known()) return nullptr;
  const auto* const slots = std::get_if<std::vector<double>>(&value->constant);
  if (slots == nullptr) refuse_computed(*value, needed);
  return slots;
}

Vector3 ShapeChecker::vector(const ExprPtr& value, std::string_view needed) {
  const std::vector<double>* const slots = constant(value, Type::vec(kLength), needed);
  return slots == nullptr ? Vector3{} : to_si(Vector3{(*slots)[0], (*slots)[1], (*slots)[2]});
}

PoseValue ShapeChecker::pose(const ExprPtr& value, std::string_view needed) {
  const std::vector<double>* const slots = constant(value, Type::pose(), needed);
  return slots == nullptr ? PoseValue{} : to_si(load_pose(to_slots(value->constant).data()));
}

double ShapeChecker::length(const ExprPtr& value, std::string_view needed) {
  const std::string needs = fmt::format("{} needs", needed);
  if (!expressions_.check_as(value, Type::real(kLength), needs) || !value->type.known()) return 0;
  const auto number = constant_number(*value);
  if (!number) {
    refuse_computed(*value, needs);
    return 0;
  }
  values_.require_positive(*value, needed);
  return to_si(*number, kLength);
}

CapsuleValue ShapeChecker::capsule(const ExprPtr& from, const ExprPtr& to, const ExprPtr& radius) {
  return {vector(from, "an end of a CAPSULE needs"), vector(to, "an end of a CAPSULE needs"),
          length(radius, "the radius of a CAPSULE")};
}

std::string ShapeChecker::file(const ExprPtr& value) {
  constexpr std::string_view kNeeds = "the file of a MESH needs";
  if (!expressions_.check_as(value, Type::string(), kNeeds) || !value->type.known()) return "";
  const auto* const name = std::get_if<std::string>(&value->constant);
  if (name == nullptr) refuse_computed(*value, kNeeds);
  return name == nullptr ? "" : *name;
}

void ShapeChecker::refuse_computed(const Expr& value, std::string_view needed) {
  diagnostics_.error(
      code::kShapeNotConstant, value.place,
      fmt::format("{} a constant value: it is fixed before the program runs", needed),
      "no variables, and nothing that is taught or read from the robot");
}

void ShapeChecker::check_shape(const Declaration& tool, std::vector<double>& slots) {
  std::vector<Slot> values(kCapsuleSlots);
  auto to = slots.begin() + kShapeSlot;
  for (const auto& [from, end, radius] : tool.shape) {
    const CapsuleValue one = capsule(from, end, radius);
    store(from_si(one.from), values.data());
    store(from_si(one.to), &values[3]);
    values.back().real = from_si(one.radius, kLength);
    to = std::ranges::transform(values, to, [](Slot slot) { return slot.real; }).out;
  }
}

void ShapeChecker::check_names(Allow& allow) {
  const std::vector<std::string> known = known_bodies();
  for (Declaration::Declared& body : allow.bodies) {
    const std::string_view found = spelled_among(known, body.name);
    if (!found.empty()) {
      body.name = found;
      continue;
    }
    const std::vector<std::string_view> words(known.begin(), known.end());
    const std::string meant = did_you_mean(suggest(body.name, words));
    diagnostics_.error(
        code::kUnknownBody, body.place,
        fmt::format("{} is no body of the robot and no obstacle", shortened(body.name)),
        meant.empty() ? fmt::format("there are {}", fmt::join(known, ", ")) : meant);
  }
}

/// Wherever in the program an OBSTACLE stands, it is there.
std::vector<std::string> ShapeChecker::known_bodies() const {
  std::vector<std::string> known = robot_.bodies;
  for (const std::string_view body : kHandBodies)
    if (spelled_among(known, body).empty()) known.emplace_back(body);
  for (const auto* const names : {&robot_.obstacles, &robot_.declared})
    known.insert(known.end(), names->begin(), names->end());
  add_obstacles(program_.statements, known);
  return known;
}

}  // namespace rob::lang

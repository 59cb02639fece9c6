#include "lang/values/types.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "lang/text/ascii.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

struct NamedDimension {
  Dimension dimension;
  std::string_view words;
};

constexpr std::array kNamedDimensions = std::to_array<NamedDimension>({
    {kNone, "a plain number"},
    {kLength, "a length"},
    {kAngle, "an angle"},
    {kTime, "a time"},
    {kSpeed, "a speed"},
    {kAngularSpeed, "an angular speed"},
    {kAcceleration, "an acceleration"},
    {kAngularAcceleration, "an angular acceleration"},
    {kJerk, "a jerk"},
    {kAngularJerk, "an angular jerk"},
    {kForce, "a force"},
    {kTorque, "a torque"},
    {kMass, "a mass"},
    {kFrequency, "a frequency"},
    {kVoltage, "a voltage"},
});

constexpr std::array<std::string_view, 3> kVecFields{"x", "y", "z"};
constexpr std::array<std::string_view, 3> kAngleFields{"a", "b", "c"};
constexpr std::array<std::string_view, 7> kPlaceFields{"x", "y", "z", "a", "b", "c", "pos"};
constexpr std::array<std::string_view, 2> kWrenchFields{"force", "torque"};

}  // namespace

std::string in_words(Dimension dimension) {
  const auto* const named = std::find_if(
      kNamedDimensions.begin(), kNamedDimensions.end(),
      [dimension](const NamedDimension& entry) { return entry.dimension == dimension; });
  if (named != kNamedDimensions.end()) return std::string(named->words);
  return "a [" + unit_text(dimension) + "]";
}

std::string in_words(const Type& type) {
  switch (type.kind) {
    case Type::Kind::Unknown:
      return "something unknown";
    case Type::Kind::Bool:
      return "TRUE or FALSE";
    case Type::Kind::Int:
      return "a whole number";
    case Type::Kind::Real:
      return in_words(type.dimension);
    case Type::Kind::Enum:
      return "a value of the ENUM " + type.detail->name;
    case Type::Kind::String:
      return "a text";
    case Type::Kind::Vec:
      return "a VEC, each " + in_words(type.dimension);
    case Type::Kind::Pose:
      return is_free(type) ? "a pose" : "a pose IN " + frame_name(type);
    case Type::Kind::Joints:
      return "a value for each joint";
    case Type::Kind::Wrench:
      return "a wrench";
    case Type::Kind::Frame:
      return "a frame";
    case Type::Kind::Tool:
      return "a tool";
    case Type::Kind::Array:
      if (type.is_open()) return "an ARRAY of any length, each " + in_words(type.detail->element);
      return "an ARRAY[" + std::to_string(type.detail->length) + "], each " +
             in_words(type.detail->element);
    case Type::Kind::List:
      if (!type.detail->element.known()) return "a LIST without elements";
      return "a LIST, each " + in_words(type.detail->element);
    case Type::Kind::Record:
      return "a record " + type.detail->name;
  }
  return {};
}

bool Type::operator==(const Type& other) const {
  if (kind != other.kind || dimension != other.dimension) return false;
  if (detail == other.detail) return true;
  if (kind == Kind::List) {
    const Type& element = detail->element;
    const bool empty = !element.known() || !other.detail->element.known();
    return empty || element == other.detail->element;
  }
  if (kind != Kind::Array) return false;
  // A faulty type fits everywhere.
  const bool faulty = detail->length == 0 || other.detail->length == 0;
  return faulty ||
         (detail->length == other.detail->length && detail->element == other.detail->element);
}

Type TypeTable::array(const Type& element, std::int64_t length) {
  TypeDetail& detail = details.emplace_back();
  detail.element = element;
  detail.length = length;
  detail.height = height_of(element) + 1;
  const Slots slots = slots_of(element);
  const auto count = length == kAnyLength ? 1 : static_cast<int>(length);
  detail.slots = {.numbers = slots.numbers * count, .texts = slots.texts * count};
  return {Type::Kind::Array, {}, &detail};
}

Type TypeTable::list(const Type& element) {
  TypeDetail& detail = details.emplace_back();
  detail.element = element;
  detail.height = height_of(element) + 1;
  detail.slots = {.numbers = 1};
  return {Type::Kind::List, {}, &detail};
}

TypeDetail& TypeTable::named(Named& types, std::uint32_t file, std::string_view name) {
  TypeDetail*& detail = types[{file, to_upper(name)}];
  if (detail == nullptr) {
    detail = &details.emplace_back();
    detail->name = name;
  }
  return *detail;
}

Type free_pose() {
  static const TypeDetail kFree;
  return Type::pose(&kFree);
}

bool is_free(const Type& type) { return type == free_pose(); }

Type as_pose(const Type& place) {
  if (place.is(Type::Kind::Frame)) return Type::pose();
  return place.is(Type::Kind::Tool) ? free_pose() : place;
}

Type settled(const Type& type) { return is_free(type) ? Type::pose() : type; }

std::string frame_name(const Type& pose) {
  if (is_free(pose)) return "no frame";
  return pose.detail == nullptr ? "world" : pose.detail->name;
}

std::optional<int> angle_of(const Type& type, std::string_view field) {
  if (!type.is_place()) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    if (same_word(kAngleFields[static_cast<std::size_t>(i)], field)) return i;
  }
  return std::nullopt;
}

Slots slots_of(const Type& type) {
  switch (type.kind) {
    case Type::Kind::Unknown:
      return {};
    case Type::Kind::Bool:
    case Type::Kind::Int:
    case Type::Kind::Real:
    case Type::Kind::Enum:
      return {.numbers = 1};
    case Type::Kind::String:
      return {.texts = 1};
    case Type::Kind::Vec:
      return {.numbers = 3};
    case Type::Kind::Wrench:
      return {.numbers = 6};
    case Type::Kind::Pose:
    case Type::Kind::Frame:
      return {.numbers = 7};
    case Type::Kind::Tool:
      return {.numbers = kToolSlots};
    case Type::Kind::Array:
      return type.is_open() ? slots_of(type.detail->element) : type.detail->slots;
    case Type::Kind::Joints:
    case Type::Kind::List:
    case Type::Kind::Record:
      return type.detail->slots;
  }
  return {};
}

bool has_default(const Type& type) {
  switch (type.kind) {
    case Type::Kind::Pose:
    case Type::Kind::Joints:
    case Type::Kind::Frame:
    case Type::Kind::Tool:
      return false;
    case Type::Kind::Array:
      return has_default(type.detail->element);
    case Type::Kind::Record:
      return std::ranges::all_of(type.detail->fields, [](const TypeDetail::Field& field) {
        return has_default(field.type);
      });
    default:
      return true;
  }
}

int height_of(const Type& type) { return type.in_registers() ? 0 : type.detail->height; }

bool holds_place(const Type& type) {
  if (type.has_row()) return holds_place(type.detail->element);
  if (!type.is(Type::Kind::Record)) return type.is_place();
  return std::ranges::any_of(
      type.detail->fields, [](const TypeDetail::Field& field) { return holds_place(field.type); });
}

std::optional<Field> field_of(const Type& type, std::string_view name) {
  if (type.is_place()) {
    if (same_word(name, "pos")) return Field{Type::vec(kLength), {}};
    return field_of(Type::vec(kLength), name);
  }
  if (type.is(Type::Kind::Wrench)) {
    if (same_word(name, "force")) return Field{Type::vec(kForce), {}};
    if (same_word(name, "torque")) return Field{Type::vec(kTorque), {.numbers = 3}};
    return std::nullopt;
  }
  if (type.is(Type::Kind::Vec)) {
    for (std::size_t i = 0; i < kVecFields.size(); ++i) {
      if (!same_word(kVecFields[i], name)) continue;
      return Field{Type::real(type.dimension), {.numbers = static_cast<int>(i)}};
    }
  }
  if (!type.is(Type::Kind::Record)) return std::nullopt;
  Slots offset;
  for (const TypeDetail::Field& field : type.detail->fields) {
    if (same_word(field.name, name)) return Field{field.type, offset};
    offset = offset + slots_of(field.type);
  }
  return std::nullopt;
}

std::vector<std::string_view> field_names(const Type& type) {
  if (type.is(Type::Kind::Vec)) return {kVecFields.begin(), kVecFields.end()};
  if (type.is_place()) return {kPlaceFields.begin(), kPlaceFields.end()};
  if (type.is(Type::Kind::Wrench)) return {kWrenchFields.begin(), kWrenchFields.end()};
  std::vector<std::string_view> names;
  if (!type.is(Type::Kind::Record)) return names;
  for (const TypeDetail::Field& field : type.detail->fields) names.push_back(field.name);
  return names;
}

std::optional<std::int64_t> value_of(const TypeDetail& enumeration, std::string_view name) {
  const auto& names = enumeration.names;
  const auto found =
      std::ranges::find_if(names, [&](const std::string& each) { return same_word(each, name); });
  return found == names.end() ? std::nullopt : std::optional(found - names.begin());
}

std::optional<Elements> elements_of(const Type& type) {
  if (type.is(Type::Kind::Vec)) return Elements{Type::real(type.dimension), 3};
  if (type.is(Type::Kind::Array)) return Elements{type.detail->element, type.detail->length};
  if (type.is(Type::Kind::List)) return Elements{type.detail->element, kAnyLength, true};
  if (type.is(Type::Kind::Joints)) {
    const std::vector<Dimension>& axes = type.detail->axes;
    return Elements{Type::real(axes.front()), static_cast<std::int64_t>(axes.size())};
  }
  return std::nullopt;
}

}  // namespace rob::lang

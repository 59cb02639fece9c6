#include "lang/check/declaration_checker.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/syntax/parser.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/pose_slots.h"
#include "lang/values/saved_value.h"

namespace rob::lang {
namespace {

bool mentions(const Type& type, const TypeDetail* record) {
  if (type.has_row()) return mentions(type.detail->element, record);
  return type.is(Type::Kind::Record) && type.detail == record;
}

/// Whether values of this type can be written to a values file, and read.
bool keeps(const Type& type) {
  switch (type.kind) {
    case Type::Kind::Array:
    case Type::Kind::List:
      return keeps(type.detail->element);
    case Type::Kind::Record:
      return std::ranges::all_of(type.detail->fields,
                                 [](const TypeDetail::Field& field) { return keeps(field.type); });
    default:
      return type.kind <= Type::Kind::Pose;
  }
}

void report_field_twice(const TypeDetail& record, const Declaration::Declared& field,
                        Diagnostics& diagnostics) {
  diagnostics.error(
      code::kDeclaredTwice, field.place,
      fmt::format("{} has a field {} already", shortened(record.name), shortened(field.name)),
      "give one of them another name");
}

}  // namespace

/// The value is checked before the names are known: VAR x = x + 1 means an earlier x.
void DeclarationChecker::check(Declaration& declaration) {
  const bool fixed =
      declaration.constant && declaration.type &&
      (declaration.type->is(Type::Kind::Frame) || declaration.type->is(Type::Kind::Tool));
  bool missed = false;
  const std::size_t told = diagnostics_.error_count();
  Type type = fixed ? expressions_.check_fixed(declaration.value, missed)
                    : expressions_.check(declaration.value);
  Constant value;
  bool accepted = true;
  type = settle_type(declaration, type, accepted);
  // A constant text lives in a register: each use of it in the tree would be a copy.
  if (declaration.constant && declaration.value != nullptr && accepted && type != Type::string()) {
    value = converted(known_value(*declaration.value), type);
  }
  if (fixed && type.known() && declaration.value != nullptr) {
    check_frame(declaration, value, missed || diagnostics_.error_count() > told);
  }
  const auto kind = declaration.constant ? Symbol::Kind::NamedConstant : Symbol::Kind::Variable;
  for (Declaration::Declared& declared : declaration.names) {
    declared.symbol = declarations_.declare(kind, declared.name, declared.place, type, value);
    if (declaration.frame != nullptr) scopes_.frame(*declared.symbol, declaration.frame);
    if (declaration.persist && may_persist(declared, type)) scopes_.persist(*declared.symbol);
  }
}

bool DeclarationChecker::may_persist(const Declaration::Declared& declared, const Type& type) {
  if (program_.entry != 0) {
    diagnostics_.error(code::kPersistAtPrompt, declared.place,
                       "the prompt keeps no variables between runs: a program does",
                       fmt::format("VAR {} = …, or a program and :run", shortened(declared.name)));
    return false;
  }
  if (!keeps(type)) {
    diagnostics_.error(
        code::kNotPersistent, declared.place,
        fmt::format("{} cannot be kept between runs: it is {}", shortened(declared.name),
                    in_words(type)),
        "numbers, BOOL, STRING, ENUM, VEC and POSE can, and ARRAY, LIST and RECORD of them");
    return false;
  }
  const auto bytes = static_cast<std::size_t>(slots_of(type).numbers) * sizeof(Slot);
  if (bytes <= kMostPersistent) return true;
  diagnostics_.error(code::kNotPersistent, declared.place,
                     fmt::format("{} is too large to be kept between runs: it has {} KiB",
                                 shortened(declared.name), bytes / 1024),
                     "1 MiB can be kept; keep what the next run needs");
  return false;
}

/// The type that was written, or that of the value. `accepted`: the value fits it.
Type DeclarationChecker::settle_type(Declaration& declaration, Type given, bool& accepted) {
  if (!declaration.type) {
    const bool refused = given.known() && (values_.refuse_open(*declaration.value) ||
                                           values_.refuse_empty(*declaration.value));
    return refused ? Type{} : settled(given);
  }
  const Declaration::Declared& first = declaration.names.front();
  Type& type = *declaration.type;
  if (!expressions_.complete(type, first.place)) type = Type{};
  if (declaration.value != nullptr) {
    accepted =
        values_.accept(*declaration.value, type, fmt::format("{} needs", shortened(first.name)));
  } else if (!has_default(type)) {
    diagnostics_.error(
        code::kValueNeeded, first.place,
        fmt::format("{} needs a value: it is {}", shortened(first.name), in_words(type)));
  }
  return settled(type);
}

/// FRAME and TOOL are constants of the program. With a point that nobody has taught they are
/// taken as the world and the flange, and so where the value is wrong: nothing runs then.
void DeclarationChecker::check_frame(const Declaration& declaration, Constant& value, bool missed) {
  const Declaration::Declared& declared = declaration.names.front();
  const std::string_view word = declaration.type->is(Type::Kind::Tool) ? "TOOL" : "FRAME";
  if (declaration.value->type.known() && !known(value) && missed) {
    std::vector<double> slots(static_cast<std::size_t>(slots_of(*declaration.type).numbers), 0.0);
    slots[3] = 1;  // w of the quaternion
    value = std::move(slots);
  }
  if (declaration.value->type.known() && !known(value)) {
    diagnostics_.error(
        code::kFrameNotConstant, declaration.value->place,
        fmt::format("{} {} is fixed before the program runs, so it needs a constant value", word,
                    shortened(declared.name)),
        "no variables and nothing that is read from the robot");
  }
  const Constant mass = tool_number(declaration.mass, Type::real(kMass), "MASS needs");
  const Constant cog = tool_number(declaration.cog, Type::vec(kLength), "COG needs");
  auto* const slots = std::get_if<std::vector<double>>(&value);
  if (slots == nullptr) return;
  if (const double* const number = std::get_if<double>(&mass)) slots->at(kPoseSlots) = *number;
  if (const auto* const place = std::get_if<std::vector<double>>(&cog)) {
    std::ranges::copy(*place, slots->begin() + kPoseSlots + 1);
  }
  if (!declaration.shape.empty()) shapes_.check_shape(declaration, *slots);
}

/// The value of MASS or COG, which becomes part of a TOOL's; unknown where there is none.
Constant DeclarationChecker::tool_number(const ExprPtr& value, const Type& wanted,
                                         std::string_view needed) {
  if (value == nullptr) return {};
  expressions_.check(value);
  if (!values_.accept(*value, wanted, needed) || !value->type.known()) return {};
  if (!known(value->constant)) {
    diagnostics_.error(code::kFrameNotConstant, value->place,
                       fmt::format("{} a constant value here", needed), "");
  } else if (const double* const mass = std::get_if<double>(&value->constant);
             mass != nullptr && *mass < 0) {
    diagnostics_.error(code::kFrameNotConstant, value->place, "a mass is 0kg or more", "");
  }
  return value->constant;
}

void DeclarationChecker::check(RecordDeclaration& record) {
  TypeDetail& detail = *record.detail;
  const Declaration::Declared& declared = record.declared;
  declarations_.declare(Symbol::Kind::Record, declared.name, declared.place,
                        {Type::Kind::Record, {}, &detail}, {});
  if (detail.complete) return;  // declared twice
  std::set<std::string> names;  // in capitals
  for (RecordDeclaration::Fields& group : record.groups) {
    const Place place = group.names.front().place;
    if (mentions(group.type, &detail)) {
      diagnostics_.error(code::kRecordInItself, place,
                         fmt::format("a {} cannot hold another {}: it would have no end",
                                     detail.name, detail.name),
                         "keep an index into an ARRAY of them instead");
      group.type = Type{};
    } else if (!expressions_.complete(group.type, place)) {
      group.type = Type{};
    }
    if (group.type.is(Type::Kind::List)) {
      expressions_.refuse_list_inside(place);
      group.type = Type{};
    }
    for (const Declaration::Declared& field : group.names) {
      if (!names.insert(to_upper(field.name)).second) {
        report_field_twice(detail, field, diagnostics_);
      } else {
        add_field(detail, field, group.type);
      }
    }
  }
  if (detail.fields.empty() && record.sound && !detail.faulty) {
    diagnostics_.error(code::kRecordEmpty, declared.place,
                       fmt::format("the record {} has no fields", shortened(detail.name)),
                       "a line for each, as in width: LENGTH");
  }
  detail.complete = true;
  detail.faulty = detail.faulty || !record.sound;
}

void DeclarationChecker::check(EnumDeclaration& enumeration) {
  TypeDetail& detail = *enumeration.detail;
  const Declaration::Declared& declared = enumeration.declared;
  declarations_.declare(Symbol::Kind::Enum, declared.name, declared.place,
                        {Type::Kind::Enum, {}, &detail}, {});
  if (detail.complete) return;  // declared twice
  for (const Declaration::Declared& name : enumeration.names) {
    if (value_of(detail, name.name)) {
      diagnostics_.error(
          code::kDeclaredTwice, name.place,
          fmt::format("{} has {} already", shortened(detail.name), shortened(name.name)),
          "give one of them another name");
    } else {
      detail.names.push_back(name.name);
    }
  }
  detail.complete = true;
}

/// Both texts are known before the program runs: it connects before anything moves.
void DeclarationChecker::check(DeviceDeclaration& device) {
  const Declaration::Declared& declared = device.declared;
  const auto refuse = [&](Place place, std::string message) {
    diagnostics_.error(code::kNotADevice, place, std::move(message),
                       "DEVICE scale = \"tcp://192.168.1.30:4001\" ENDING \"\\r\\n\"");
  };
  const auto text_of = [&](const ExprPtr& expression, std::string_view what) {
    std::string text;
    if (!expressions_.check_as(expression, Type::string(), what)) return text;
    const auto* const known = std::get_if<std::string>(&expression->constant);
    if (known != nullptr) return *known;
    refuse(expression->place, fmt::format("{} a text that is written out", what));
    return text;
  };
  const std::size_t told = diagnostics_.error_count();
  const std::string address = text_of(device.address, "DEVICE needs");
  if (device.address != nullptr && diagnostics_.error_count() == told &&
      !address.starts_with("tcp://"))
    refuse(device.address->place,
           fmt::format("'{}' is no address of a device", shortened(address)));
  if (device.ending != nullptr) {
    const std::size_t before = diagnostics_.error_count();
    const std::string ending = text_of(device.ending, "ENDING needs");
    constexpr std::size_t kLongestEnding = 8;  // [choice]
    if (diagnostics_.error_count() == before && (ending.empty() || ending.size() > kLongestEnding))
      refuse(device.ending->place, fmt::format("an ENDING has 1 to {} characters", kLongestEnding));
  }
  if (program_.entry != 0) refuse(declared.place, "the prompt has no devices: a program has");
  device.declared.symbol = declarations_.declare(Symbol::Kind::Device, declared.name,
                                                 declared.place, Type::boolean(), {});
  scopes_.device(*device.declared.symbol);
}

void DeclarationChecker::add_field(TypeDetail& detail, const Declaration::Declared& field,
                                   const Type& type) {
  detail.height = std::max(detail.height, height_of(type) + 1);
  if (detail.height > kMaxDepth) {
    diagnostics_.error(
        code::kTooDeep, field.place,
        fmt::format("records and arrays are nested too deep: at most {} levels", kMaxDepth));
    detail.height = 1;
    detail.faulty = true;
    return;
  }
  const Slots slots = detail.slots + slots_of(type);
  if (slots.numbers > kMemory.numbers || slots.texts > kMemory.texts) {
    diagnostics_.error(
        code::kArrayTooLarge, field.place,
        fmt::format("with {} the record {} is too large: a program has room for {} "
                    "numbers and {} texts in arrays and records",
                    shortened(field.name), shortened(detail.name), kMemory.numbers, kMemory.texts));
    return;
  }
  detail.slots = slots;
  detail.fields.push_back({field.name, type});
}

void DeclarationChecker::check(PointDeclaration& declaration) {
  const Type given = settled(expressions_.check(declaration.value));
  if (declaration.value != nullptr && given.known() && !given.is(Type::Kind::Pose)) {
    values_.accept(*declaration.value, Type::pose(),
                   fmt::format("{} needs", shortened(declaration.points.front().declared.name)));
  }
  for (PointDeclaration::Point& point : declaration.points) {
    if (!is_of_other_file(point.declared)) declare(point, declaration, given);
  }
}

/// The points file counts, before the value in the program.
void DeclarationChecker::declare(PointDeclaration::Point& point,
                                 const PointDeclaration& declaration, const Type& given) {
  const bool has_value = declaration.value != nullptr;
  Declaration::Declared& declared = point.declared;
  Type type = given.is(Type::Kind::Pose) ? given : Type::pose();
  Constant value;
  const PointTable::Point* const kept = points_.find(declared.name);
  if (kept != nullptr) {
    type = type_of(*kept, declared.place);
    point.kept = from_si(kept->pose);
    value = constant_of(*point.kept);
  } else if (has_value && given == type) {
    value = known_value(*declaration.value);
  }
  if (!declaration.sound) type = Type{};
  // A later entry of the prompt may teach any of them.
  const bool taught = program_.entry != 0 || program_.taught.contains(to_upper(declared.name));
  declared.symbol = declarations_.declare(Symbol::Kind::Point, declared.name, declared.place, type,
                                          taught ? Constant{} : value);
  scopes_.keep(*declared.symbol, std::move(value));
  if (kept != nullptr) keep_joints(*declared.symbol, *kept);
  if (taught) {
    scopes_.teach(*declared.symbol, *scopes_.hide(expressions_.joints()),
                  *scopes_.hide(Type::boolean()), program_.entry != 0);
  }
  if (kept == nullptr && !has_value && declaration.sound) {
    missing_.declare(*declared.symbol);
  }
}

void DeclarationChecker::keep_joints(const Symbol& symbol, PointTable::Point kept) {
  const std::vector<Dimension>& axes = expressions_.joints().detail->axes;
  for (std::size_t i = 0; i < kept.joints.size(); ++i) {
    kept.joints[i] = from_si(kept.joints[i], axes.at(i));
  }
  scopes_.keep_joints(symbol, kept);
}

/// All points of a program are kept in one points file, by their names.
bool DeclarationChecker::is_of_other_file(const Declaration::Declared& point) {
  const auto [earlier, is_new] = points_declared_.try_emplace(to_upper(point.name), point.place);
  if (is_new || earlier->second.file == point.place.file) return false;
  diagnostics_.error(
      code::kPointOfTwoFiles, point.place,
      fmt::format("{} is a POINT of another file already, in {}", shortened(point.name),
                  diagnostics_.line_of(earlier->second, point.place)),
      "all points of a program are kept together: give one another name, or"
      " declare it in one file that both USE");
  return true;
}

/// A pose in the frame that its entry names.
Type DeclarationChecker::type_of(const PointTable::Point& kept, Place place) {
  if (kept.frame.empty()) return Type::pose();
  const Symbol* const frame = scopes_.find_global(kept.frame);
  if (frame != nullptr && frame->frame != nullptr) return Type::pose(frame->frame);
  diagnostics_.error(
      code::kPointFrame, place,
      fmt::format("{} is kept in the frame {}, which is no FRAME declared above", kept.name,
                  shortened(kept.frame)),
      fmt::format("FRAME {} = POSE(…) before the POINT declares one", shortened(kept.frame)));
  return {};
}

void DeclarationChecker::check(Teach& teach, bool surely) {
  const Symbol* const symbol = names_.resolve(teach.target.text, teach.target_place);
  teach.target.symbol = symbol;
  if (symbol == nullptr || !symbol->type.known()) return;
  if (symbol->kind != Symbol::Kind::Point) {
    diagnostics_.error(code::kNotAPoint, teach.target_place,
                       fmt::format("{} is no POINT; TEACH stores the place of the robot in one",
                                   shortened(symbol->name)),
                       fmt::format("POINT pick declares one; here = HERE keeps a place in a "
                                   "variable, for this run only"));
    return;
  }
  teach.frame = values_.frame_of(symbol->type);
  missing_.teach(*symbol, surely);
}

void DeclarationChecker::know(const Symbol& symbol) {
  if (symbol.kind != Symbol::Kind::Point) return;
  points_declared_.try_emplace(to_upper(symbol.name), symbol.place);
}

}  // namespace rob::lang

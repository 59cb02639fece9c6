#include "lang/check/outlet_checker.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {
namespace {

bool is_csv_field(const Type& type) {
  if (type.is(Type::Kind::Record)) {
    return std::ranges::all_of(type.detail->fields, [](const TypeDetail::Field& field) {
      return is_csv_field(field.type);
    });
  }
  return type.kind <= Type::Kind::Pose;
}

/// Whether READ can fill a value of this type.
bool reads_from_csv(const Type& type) {
  return type.has_row() && type.detail->element.is(Type::Kind::Record) &&
         is_csv_field(type.detail->element);
}

}  // namespace

bool assignable(const Symbol& symbol, Place place, Diagnostics& diagnostics) {
  const auto refuse = [&](std::string_view what, std::string help) {
    diagnostics.error(code::kNotAssignable, place,
                      fmt::format("{} {}", shortened(symbol.name), what), std::move(help));
    return false;
  };
  switch (symbol.kind) {
    case Symbol::Kind::Variable:
      return true;
    case Symbol::Kind::NamedConstant:
      return refuse("is a constant", fmt::format("declare it with VAR in {} to change it",
                                                 diagnostics.line_of(symbol.place, place)));
    case Symbol::Kind::LoopVariable:
      return refuse("is the variable of a FOR, which alone changes it",
                    "use a variable of its own, or WHILE");
    case Symbol::Kind::Signal:
      return symbol.output || refuse("is an input of the robot and can only be read", "");
    case Symbol::Kind::Point:
      return refuse("is a point, which TEACH alone changes",
                    "give the value to a variable, or TEACH it where the robot stands");
    case Symbol::Kind::Routine:
      return refuse("is a routine, not a variable", "");
    case Symbol::Kind::Record:
      return refuse("is a record, not a variable", "");
    case Symbol::Kind::Device:
      return refuse("is a device, not a variable", "");
    case Symbol::Kind::Enum:
      return refuse("is an ENUM, not a variable", "");
    case Symbol::Kind::BuiltIn:
    case Symbol::Kind::Reading:
      return refuse("belongs to the language and cannot be changed", "");
  }
  return false;
}

void OutletChecker::check(Write& write) {
  expressions_.check_as(write.file, Type::string(), "WRITE needs");
  values_.check_file(write.file, "WRITE");
  for (const ExprPtr& value : write.values) expressions_.check(value);
}

void OutletChecker::check(Read& read) {
  expressions_.check_as(read.file, Type::string(), "READ needs");
  values_.check_file(read.file, "READ");
  const Type type = expressions_.check(read.target);
  if (read.target == nullptr) return;
  const Name* const root = root_of(*read.target);
  if (root != nullptr && root->symbol == nullptr) return;
  if (root != nullptr && !assignable(*root->symbol, read.target->place, diagnostics_)) return;
  if (root != nullptr) uses_.written(*root->symbol, read.target->place);
  if (!type.known() || (root != nullptr && reads_from_csv(type))) return;
  diagnostics_.error(code::kNotReadable, read.target->place,
                     fmt::format("READ fills a LIST or an ARRAY OF a RECORD; this is {} ({})",
                                 in_words(type), as_written(type)),
                     "the record has a field for each column: numbers, BOOL, STRING, VEC, POSE");
}

void OutletChecker::check(Send& send) {
  send.device.symbol = names_.resolve_device(send.device.text, send.device_place);
  if (send.device.symbol != nullptr) uses_.spoke_with(*send.device.symbol, send.device_place);
  for (const ExprPtr& value : send.values) expressions_.check(value);
}

void OutletChecker::check(Receive& receive) {
  receive.device.symbol = names_.resolve_device(receive.device.text, receive.device_place);
  if (receive.device.symbol != nullptr)
    uses_.spoke_with(*receive.device.symbol, receive.device_place);
  if (expressions_.check_as(receive.timeout, Type::real(kTime), "TIMEOUT needs"))
    values_.require_time(*receive.timeout, "TIMEOUT");
  const Type type = expressions_.check(receive.target);
  if (receive.target == nullptr) return;
  const Name* const root = root_of(*receive.target);
  if (root != nullptr && root->symbol == nullptr) return;
  if (root != nullptr && !assignable(*root->symbol, receive.target->place, diagnostics_)) return;
  if (root != nullptr) uses_.written(*root->symbol, receive.target->place);
  if (!type.known() || (root != nullptr && type == Type::string())) return;
  diagnostics_.error(
      code::kNotReceivable, receive.target->place,
      fmt::format("RECEIVE fills a STRING; this is {} ({})", in_words(type), as_written(type)),
      "VAR line = \"\", and NUM(line) makes a number of it");
}

}  // namespace rob::lang

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "lang/check/statement_checker.h"
#include "lang/syntax/parser.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

/// The parts of the checkers that know RECORD: its fields, and how a value is built.
namespace rob::lang {
namespace {

bool mentions(const Type& type, const TypeDetail* record) {
  if (type.is(Type::Kind::Array)) return mentions(type.detail->element, record);
  return type.is(Type::Kind::Record) && type.detail == record;
}

std::size_t index_of(const TypeDetail& record, std::string_view field) {
  const auto found = std::ranges::find_if(
      record.fields, [&](const TypeDetail::Field& each) { return same_word(each.name, field); });
  return static_cast<std::size_t>(found - record.fields.begin());
}

void report_field_twice(const TypeDetail& record, const Declaration::Declared& field,
                        Diagnostics& diagnostics) {
  diagnostics.error(
      code::kDeclaredTwice, field.place,
      fmt::format("{} has a field {} already", shortened(record.name), shortened(field.name)),
      "give one of them another name");
}

}  // namespace

void StatementChecker::check(RecordDeclaration& record) {
  TypeDetail& detail = *record.detail;
  const Declaration::Declared& declared = record.declared;
  declare(Symbol::Kind::Record, declared.name, declared.place, {Type::Kind::Record, {}, &detail},
          {});
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

void StatementChecker::add_field(TypeDetail& detail, const Declaration::Declared& field,
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

/// `part(width: 20mm)`: what is left out takes its default.
Type ExpressionChecker::check_record(Call& call, const Expr& expression, const Type& record) {
  const TypeDetail& detail = *record.detail;
  call.record = &detail;
  call.bound.assign(detail.fields.size(), nullptr);
  if (&expression == statement_) {
    diagnostics_.error(
        code::kRoutineMisused, expression.place,
        fmt::format("this makes a {}, which is not used here", shortened(detail.name)),
        "assign it to a variable");
    return {};
  }
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    if (!bind_field(call, *call.arguments[i], call.names[i])) return record;
  }
  for (std::size_t i = 0; i < detail.fields.size(); ++i) {
    const TypeDetail::Field& field = detail.fields[i];
    if (call.bound[i] != nullptr || has_default(field.type)) continue;
    diagnostics_.error(code::kFieldNeeded, expression.place,
                       fmt::format("{} needs {}: it is {}", shortened(detail.name),
                                   shortened(field.name), in_words(field.type)),
                       fmt::format("{}({}: …)", shortened(detail.name), shortened(field.name)));
    return record;
  }
  return record;
}

bool ExpressionChecker::bind_field(Call& call, const Expr& value, const std::string& name) {
  const TypeDetail& detail = *call.record;
  if (name.empty()) {
    std::string help;
    if (!detail.fields.empty()) {
      help = fmt::format("{}({}: …)", shortened(detail.name), shortened(detail.fields[0].name));
    }
    diagnostics_.error(
        code::kFieldGiven, value.place,
        fmt::format("the fields of {} are given by their names", shortened(detail.name)), help);
    return false;
  }
  const std::size_t at = index_of(detail, name);
  if (at == detail.fields.size()) {
    if (detail.faulty) return false;
    const std::vector<std::string_view> names = field_names({Type::Kind::Record, {}, &detail});
    std::string help = did_you_mean(suggest(name, names));
    if (help.empty()) help = fmt::format("it has {}", fmt::join(names, ", "));
    diagnostics_.error(code::kNoSuchField, value.place,
                       fmt::format("{} has no field {}", shortened(detail.name), shortened(name)),
                       help);
    return false;
  }
  if (call.bound[at] != nullptr) {
    diagnostics_.error(code::kFieldGiven, value.place,
                       fmt::format("{} is given twice", shortened(detail.fields[at].name)),
                       "leave one of them out");
    return false;
  }
  call.bound[at] = &value;
  return accept(value, detail.fields[at].type,
                fmt::format("{} of {} needs", shortened(name), shortened(detail.name)));
}

}  // namespace rob::lang

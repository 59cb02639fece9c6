#include "lang/check/names.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/check/value_checker.h"
#include "lang/syntax/keywords.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/units.h"

namespace rob::lang {
namespace {

using Found = std::optional<Place>;

Found search(const Block& block, const std::string& key);

struct Search {
  const std::string& key;

  Found operator()(const Declaration& declaration) const {
    for (const Declaration::Declared& declared : declaration.names) {
      if (to_upper(declared.name) == key) return declared.place;
    }
    return std::nullopt;
  }
  Found operator()(const PointDeclaration& points) const {
    for (const PointDeclaration::Point& point : points.points) {
      if (to_upper(point.declared.name) == key) return point.declared.place;
    }
    return std::nullopt;
  }
  Found operator()(const SignalDeclaration& signal) const {
    return to_upper(signal.name) == key ? Found(signal.name_place) : std::nullopt;
  }
  Found operator()(const DeviceDeclaration& device) const {
    return to_upper(device.declared.name) == key ? Found(device.declared.place) : std::nullopt;
  }
  Found operator()(const RecordDeclaration& record) const {
    return to_upper(record.declared.name) == key ? Found(record.declared.place) : std::nullopt;
  }
  Found operator()(const EnumDeclaration& enumeration) const {
    const Declaration::Declared& declared = enumeration.declared;
    return to_upper(declared.name) == key ? Found(declared.place) : std::nullopt;
  }
  Found operator()(const If& conditional) const {
    for (const If::Branch& branch : conditional.branches) {
      if (const Found found = search(branch.body, key)) return found;
    }
    return search(conditional.otherwise, key);
  }
  Found operator()(const While& loop) const { return search(loop.body, key); }
  Found operator()(const For& loop) const {
    if (to_upper(loop.variable) == key) return loop.variable_place;
    return search(loop.body, key);
  }
  Found operator()(const With& with) const { return search(with.body, key); }
  Found operator()(const Press& press) const { return search(press.body, key); }
  Found operator()(const Allow& allow) const { return search(allow.body, key); }
  Found operator()(const Loop& loop) const { return search(loop.body, key); }
  Found operator()(const Select& select) const {
    for (const Select::Case& one : select.cases) {
      if (const Found found = search(one.body, key)) return found;
    }
    return search(select.otherwise, key);
  }
  Found operator()(const Try& guarded) const {
    if (to_upper(guarded.why.name) == key) return guarded.why.place;
    if (const Found found = search(guarded.body, key)) return found;
    return search(guarded.rescue, key);
  }
  template <typename Other>
  Found operator()(const Other&) const {
    return std::nullopt;
  }
};

Found search(const Block& block, const std::string& key) {
  for (const Statement& statement : block) {
    if (const Found found = std::visit(Search{key}, statement.node)) return found;
  }
  return std::nullopt;
}

/// The top level of a file: where it is USEd first. Null if it declares nothing there.
const Block* top_level_of(std::uint32_t file, const Block& statements) {
  for (const Statement& statement : statements) {
    const Use* const use = std::get_if<Use>(&statement.node);
    if (use == nullptr) continue;
    if (use->file == file && !use->declarations.empty()) return &use->declarations;
    if (const Block* const found = top_level_of(file, use->declarations)) return found;
  }
  return nullptr;
}

bool is_definition(Symbol::Kind kind) {
  return kind == Symbol::Kind::Routine || kind == Symbol::Kind::Record ||
         kind == Symbol::Kind::Enum;
}

}  // namespace

std::optional<Place> Names::declaration_of(std::string_view name, std::uint32_t file) const {
  const std::string key = to_upper(name);
  const Block* const top_level =
      file == 0 ? &program_.statements : top_level_of(file, program_.statements);
  if (top_level != nullptr) {
    if (const Found found = search(*top_level, key)) return found;
  }
  for (const Routine& routine : program_.routines) {
    if (routine.place.file != file) continue;
    for (const Routine::Parameters& group : routine.parameters) {
      for (const Declaration::Declared& declared : group.names) {
        if (to_upper(declared.name) == key) return declared.place;
      }
    }
    if (const Found found = search(routine.body, key)) return found;
  }
  return std::nullopt;
}

const Symbol* Names::resolve(std::string_view name, Place place) {
  const Symbol* const symbol = scopes_.find(name);
  if (symbol != nullptr && report_ambiguous(name, place)) return nullptr;
  if (symbol == nullptr) {
    report_unknown(name, place);
  } else if (symbol->kind == Symbol::Kind::Routine) {
    diagnostics_.error(code::kNotAFunction, place,
                       fmt::format("{} is a routine, not a value", shortened(name)),
                       fmt::format("call it: {}(…)", shortened(name)));
    return nullptr;
  } else if (symbol->kind == Symbol::Kind::Record) {
    diagnostics_.error(code::kNotAFunction, place,
                       fmt::format("{} is a record, not a value", shortened(name)),
                       fmt::format("build one: {}(…)", shortened(name)));
    return nullptr;
  } else if (symbol->kind == Symbol::Kind::Enum) {
    const auto& names = symbol->type.detail->names;
    diagnostics_.error(
        code::kNotAFunction, place, fmt::format("{} is an ENUM, not a value", shortened(name)),
        names.empty() ? ""
                      : fmt::format("name a value of it: {}.{}", shortened(name), names.front()));
  } else if (symbol->kind == Symbol::Kind::Device) {
    diagnostics_.error(code::kNotADevice, place,
                       fmt::format("{} is a device, not a value", shortened(name)),
                       fmt::format("SEND {0}: …, RECEIVE {0} INTO …", shortened(name)));
    return nullptr;
  } else {
    uses_.used(*symbol);
  }
  return symbol;
}

const Symbol* Names::resolve_device(std::string_view name, Place place) {
  const Symbol* const symbol = scopes_.find(name);
  if (symbol != nullptr && report_ambiguous(name, place)) return nullptr;
  if (symbol == nullptr) report_unknown(name, place);
  if (symbol == nullptr || symbol->kind == Symbol::Kind::Device) return symbol;
  diagnostics_.error(code::kNotADevice, place, fmt::format("{} is no DEVICE", shortened(name)),
                     "DEVICE scale = \"tcp://192.168.1.30:4001\" declares one");
  return nullptr;
}

const Symbol* Names::resolve_channel(const Name& name, Place place) {
  const auto* const number = std::get_if<std::int64_t>(&name.index->constant);
  if (number == nullptr) {
    diagnostics_.error(code::kChannelNotConstant, name.index->place,
                       fmt::format("the number of {} must be a constant whole number; this is {}",
                                   name.text, described(*name.index)));
    return nullptr;
  }
  if (const Symbol* const found = scopes_.channel(name.text, *number)) return found;
  const std::int64_t count = scopes_.channels(name.text);
  diagnostics_.error(code::kNoSuchChannel, place,
                     fmt::format("the robot has no {}[{}]", name.text, *number),
                     count == 0 ? fmt::format("it has no {} at all", name.text)
                                : fmt::format("it has {0}[1] to {0}[{1}]", name.text, count));
  return nullptr;
}

const Builtin* Names::resolve_function(const Call& call, Place place) {
  if (scopes_.find(call.callee) != nullptr && !is_common_name(call.callee)) {
    diagnostics_.error(code::kNotAFunction, place,
                       fmt::format("{} is a value, not a function", shortened(call.callee)),
                       find_builtin(call.callee, 0) == nullptr
                           ? "leave out the parentheses, or write * between"
                           : "it hides the function of that name: give it another name");
    return nullptr;
  }
  const Builtin* const builtin = find_builtin(call);
  if (builtin != nullptr) return builtin;
  report_unknown_function(call.callee, place);
  return nullptr;
}

void Names::report_unknown(std::string_view name, Place place) {
  // An error that is only counted needs no search.
  if (diagnostics_.error_count() >= Diagnostics::kMost) {
    diagnostics_.error(code::kUnknownName, place, "unknown name");
    return;
  }
  if (find_builtin(name, 0) != nullptr) {
    diagnostics_.error(code::kNotAFunction, place, fmt::format("{} is a function", name),
                       fmt::format("give it its arguments: {}(…)", to_upper(name)));
    return;
  }
  if (scopes_.is_file(name.substr(0, name.find('.')))) {
    return report_no_such_name(name, place);
  }
  if (const auto declared = declaration_of(name, place.file)) {
    const bool later = declared->line > place.line ||
                       (declared->line == place.line && declared->column >= place.column);
    diagnostics_.error(
        code::kUnknownName, place, fmt::format("{} is not known here", shortened(name)),
        later || declared->line == place.line
            ? fmt::format("it is declared in line {}: declare it before using it", declared->line)
            : fmt::format("it is declared in the block of line {} and lives only there",
                          declared->line));
    return;
  }
  std::string help = did_you_mean(suggest(name, scopes_.visible()));
  if (help.empty() && find_unit(name)) {
    help = fmt::format("a unit stands after its number, without a blank: 1{}", name);
  }
  diagnostics_.error(code::kUnknownName, place, fmt::format("unknown name {}", shortened(name)),
                     std::move(help));
}

void Names::report_unknown_function(std::string_view name, Place place) {
  if (name.find('.') != std::string_view::npos) return report_no_such_name(name, place);
  std::vector<std::string_view> names = builtin_names();
  for (const Routine& routine : program_.routines) {
    if (!routine.handler) names.emplace_back(routine.name);
  }
  diagnostics_.error(code::kUnknownFunction, place,
                     fmt::format("unknown function {}", shortened(name)),
                     did_you_mean(suggest(name, names)));
}

bool Names::report_ambiguous(std::string_view name, Place place) {
  const std::vector<std::string> files = scopes_.files_with(name);
  if (files.size() < 2) return false;
  diagnostics_.error(code::kAmbiguousName, place,
                     fmt::format("{} is declared in {} and in {}", shortened(name),
                                 shortened(files[0]), shortened(files[1])),
                     fmt::format("write {0}.{2} or {1}.{2}", shortened(files[0]),
                                 shortened(files[1]), shortened(name)));
  return true;
}

/// `tools.x` where tools.rob has no x, or `tools` alone.
void Names::report_no_such_name(std::string_view name, Place place) {
  const std::size_t point = name.find('.');
  const std::string_view file = name.substr(0, point);
  if (point == std::string_view::npos) {
    diagnostics_.error(code::kUnknownName, place,
                       fmt::format("{} is a file that is USEd here, not a value", shortened(file)),
                       fmt::format("name what is meant of it: {}.x", shortened(file)));
    return;
  }
  if (!scopes_.is_file(file)) {
    diagnostics_.error(code::kUnknownName, place,
                       fmt::format("{} is no file that is USEd here", shortened(file)),
                       "a routine is called by its name alone, or after the name of its file");
    return;
  }
  const std::string_view wanted = name.substr(point + 1);
  diagnostics_.error(
      code::kUnknownName, place,
      fmt::format("{} declares no {}, or not yet", shortened(file), shortened(wanted)),
      did_you_mean(suggest(wanted, scopes_.names_in(file))));
}

void Declarations::warn_of_name(Symbol::Kind kind, const std::string& name, Place place) {
  if (const Symbol* const earlier = scopes_.find_innermost(name)) {
    if (may_be_anew(kind, *earlier)) return;
    report_twice(kind, name, place, *earlier);
  } else if (const auto files = scopes_.files_with(name);
             scopes_.at_top_level() && !files.empty()) {
    warn_of_hiding(name, place, files.front());
  } else if (scopes_.provided(name) ||
             (find_builtin(name, 0) != nullptr && !is_common_name(name))) {
    diagnostics_.warning(
        code::kHidesBuiltIn, place,
        fmt::format("{} hides what the language or the robot calls so", shortened(name)),
        "give it another name");
  }
}

const Symbol* Declarations::declare(Symbol::Kind kind, const std::string& name, Place place,
                                    Type type, Constant value) {
  warn_of_name(kind, name, place);
  if (!is_definition(kind) && elements_of(type) && is_channel_word(name)) {
    diagnostics_.error(
        code::kReservedName, place,
        fmt::format("{0}[1] is a channel of the robot; {0} cannot have elements", to_upper(name)),
        "choose another name");
  }
  Symbol symbol;
  symbol.kind = kind;
  symbol.name = name;
  symbol.type = type;
  symbol.place = place;
  symbol.global = scopes_.at_top_level() && !is_definition(kind);
  // A known value lives in the code.
  if (!is_definition(kind) && !known(value)) count(slots_of(type));
  symbol.value = std::move(value);
  const Symbol* const declared = scopes_.declare(std::move(symbol));
  if (declared->global) uses_.declared(*declared);
  return declared;
}

void Declarations::declare(const Routine& routine) {
  const Symbol* const earlier = scopes_.find_innermost(routine.name);
  if (earlier != nullptr && !may_be_anew(Symbol::Kind::Routine, *earlier)) {
    report_twice(Symbol::Kind::Routine, routine.name, routine.name_place, *earlier);
    return;
  }
  const Symbol* const symbol =
      declare(Symbol::Kind::Routine, routine.name, routine.name_place, routine.result, {});
  scopes_.define(*symbol, routine);
}

const Symbol& Declarations::declare(const KeptName& kept,
                                    std::vector<CheckedProgram::Known>& known) {
  Symbol copy = kept.symbol;
  copy.taught = copy.has_taught = nullptr;
  const Symbol& symbol = *scopes_.declare(std::move(copy));
  known.push_back({&symbol, &kept});
  if (symbol.global) uses_.declared(symbol);
  if (symbol.frame != nullptr) scopes_.frame(symbol, symbol.frame);
  if (symbol.kind == Symbol::Kind::Point && kept.hidden.size() == 2) {
    const Symbol& joints = declare_hidden(kept.hidden[0], known);
    scopes_.teach(symbol, joints, declare_hidden(kept.hidden[1], known), symbol.moved_to);
  }
  return symbol;
}

const Symbol& Declarations::declare_hidden(const KeptName& kept,
                                           std::vector<CheckedProgram::Known>& known) {
  const Symbol& symbol = *scopes_.hide(kept.symbol.type);
  known.push_back({&symbol, &kept});
  return symbol;
}

void Declarations::warn_of_hiding(const std::string& name, const Place& place,
                                  const std::string& file) {
  diagnostics_.warning(code::kHidesUsed, place,
                       fmt::format("{0} hides the {0} of {1}", shortened(name), shortened(file)),
                       fmt::format("write {}.{} for that one, or give this one another name",
                                   shortened(file), shortened(name)));
}

void Declarations::report_twice(Symbol::Kind kind, const std::string& name, Place place,
                                const Symbol& earlier) {
  diagnostics_.error(
      code::kDeclaredTwice, place,
      fmt::format("{} is already declared, in line {}", shortened(name), earlier.place.line),
      is_definition(kind) || is_definition(earlier.kind)
          ? "give one of them another name"
          : "to give it another value, write it without VAR");
}

/// At the prompt the last routine of a name holds, and the last of what has a value. Types stay:
/// there are values of them.
bool Declarations::may_be_anew(Symbol::Kind kind, const Symbol& earlier) const {
  using Kind = Symbol::Kind;
  const bool alike = (kind == Kind::Routine) == (earlier.kind == Kind::Routine);
  const auto is_type = [](Kind one) { return one == Kind::Record || one == Kind::Enum; };
  const bool types = is_type(kind) || is_type(earlier.kind);
  return entry_ != 0 && scopes_.at_top_level() && alike && !types;
}

void Declarations::count(Slots slots) {
  count_.now = count_.now + slots;
  count_.most = {std::max(count_.most.numbers, count_.now.numbers),
                 std::max(count_.most.texts, count_.now.texts)};
}

Declarations::Count Declarations::count_anew() { return std::exchange(count_, Count{}); }

bool Declarations::take_many() {
  const auto [numbers, texts] = count_anew().most;
  return std::max(numbers, texts) > kVariableRegisters / 2;
}

void MissingPoints::teach(const Symbol& point, bool surely) {
  const auto found = states_.find(&point);
  if (found == states_.end()) return;
  found->second.taught = true;
  found->second.surely = found->second.surely || surely;
}

void MissingPoints::use(const Symbol& point) {
  const auto found = states_.find(&point);
  if (found == states_.end()) return;
  State& state = found->second;
  state.needed = state.needed || in_routines_ || !state.surely;
}

std::vector<MissingPoint> MissingPoints::found() const {
  std::vector<MissingPoint> missing;
  for (const auto& [point, state] : states_) {
    if (state.needed || !state.taught) missing.push_back({point->name, point->place});
  }
  std::ranges::sort(missing, [](const MissingPoint& a, const MissingPoint& b) {
    return comes_before(a.place, b.place);
  });
  return missing;
}

}  // namespace rob::lang

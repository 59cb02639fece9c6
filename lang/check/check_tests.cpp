#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "lang/check/statement_checker.h"
#include "lang/check/target.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of StatementChecker for EXPECT and SIMULATE.
namespace rob::lang {

/// What only a TEST may do: the program itself is run on machines that are there.
void StatementChecker::require_test(std::string_view word) {
  const Routine* const routine = inside_.around != nullptr ? inside_.around : inside_.routine;
  if (routine != nullptr && routine->test) return;
  diagnostics_.error(code::kOutsideTest, place_, fmt::format("{} can stand only in a TEST", word),
                     "TEST \"its name\" … ENDTEST holds it; a program has ASSERT and its inputs");
}

/// A report of tests says which one has failed by its name.
void StatementChecker::check_test_names(const Program& program) {
  std::map<std::pair<std::uint32_t, std::string_view>, const Routine*> named;
  for (const Routine& routine : program.routines) {
    if (!routine.test || !routine.sound) continue;
    const auto [earlier, is_new] = named.try_emplace({routine.place.file, routine.name}, &routine);
    if (is_new) continue;
    diagnostics_.error(code::kDeclaredTwice, routine.name_place,
                       fmt::format("there is a TEST of this name already, in line {}",
                                   earlier->second->place.line),
                       "give one of them another name");
  }
}

void StatementChecker::check(Expect& expectation) {
  require_test("EXPECT");
  expressions_.check_condition(expectation.condition, "EXPECT");
}

void StatementChecker::check(Simulate& simulation) {
  require_test("SIMULATE");
  expressions_.check(simulation.value);
  expressions_.check(simulation.after);
  const bool input = simulation.what == Simulate::What::Input;
  if (!input) check_operators_simulation(simulation);
  const Symbol* const symbol =
      input ? resolve_signal(simulation.target, simulation.target_place) : nullptr;
  simulation.target.symbol = symbol;
  if (simulation.after != nullptr) {
    expressions_.accept(*simulation.after, Type::real(kTime), "AFTER needs");
    const std::optional<double> after = constant_number(*simulation.after);
    if (after && *after < 0) {
      diagnostics_.error(code::kNegativeTime, simulation.after->place,
                         fmt::format("AFTER needs a time of 0s or more; this is {}",
                                     described(*simulation.after)));
    }
  }
  if (symbol == nullptr || symbol->type.kind == Type::Kind::Unknown) return;
  if (symbol->kind == Symbol::Kind::Reading && needs_sensor(symbol->reading)) {
    return check_simulated_force(simulation, *symbol);
  }
  if (!simulation.part.empty()) {
    diagnostics_.error(
        code::kForcePart, simulation.part_place,
        fmt::format("{} is one value; only force and torque have parts", shortened(symbol->name)));
    return;
  }
  if (symbol->kind != Symbol::Kind::Signal || symbol->output) {
    diagnostics_.error(
        code::kNotSimulated, simulation.target_place,
        fmt::format("{} is no input; SIMULATE gives an input its value", shortened(symbol->name)),
        "SIMULATE part_here = ON AFTER 2s");
    return;
  }
  if (simulation.value != nullptr) {
    expressions_.accept(*simulation.value, symbol->type,
                        fmt::format("{} needs", shortened(symbol->name)));
  }
}

/// SIMULATE force.z = 5N
void StatementChecker::check_simulated_force(Simulate& simulation, const Symbol& symbol) {
  if (!expressions_.has_sensor(symbol.reading, simulation.target_place)) return;
  const auto part = field_of(symbol.type, simulation.part);
  if (!part) {
    diagnostics_.error(code::kForcePart,
                       simulation.part.empty() ? simulation.target_place : simulation.part_place,
                       fmt::format("SIMULATE sets one part of {} at a time", symbol.name),
                       fmt::format("write {0}.x, {0}.y or {0}.z", symbol.name));
    return;
  }
  simulation.component = part->offset.numbers + (symbol.reading == Reading::Torque ? 3 : 0);
  if (simulation.value != nullptr) {
    expressions_.accept(*simulation.value, part->type,
                        fmt::format("{}.{} needs", symbol.name, simulation.part));
  }
}

}  // namespace rob::lang

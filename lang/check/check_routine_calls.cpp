#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "lang/check/expression_checker.h"
#include "lang/check/routine.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"

/// Member functions of ExpressionChecker for calls of the program's own routines.
namespace rob::lang {

void ExpressionChecker::check_statement(const ExprPtr& call) {
  statement_ = call.get();
  check(call);
  statement_ = nullptr;
}

Type ExpressionChecker::check_routine_call(Call& call, const Expr& expression,
                                           const Routine& routine) {
  const bool statement = &expression == statement_;
  call.routine = &routine;
  uses_.called(routine, expression.place);
  if (routine.task) {
    diagnostics_.error(
        code::kRoutineMisused, expression.place,
        fmt::format("{} is a TASK and is not called", shortened(routine.name)),
        fmt::format("START {} lets it run beside the program", shortened(routine.name)));
    return {};
  }
  complete_header(routine);
  if (statement && routine.function) {
    diagnostics_.error(
        code::kRoutineMisused, expression.place,
        fmt::format("{} is a FUNC, and its value is not used here", shortened(routine.name)),
        "assign it to a variable, or make it a PROC");
    return {};
  }
  if (!statement && !routine.function) {
    diagnostics_.error(code::kRoutineMisused, expression.place,
                       fmt::format("{} is a PROC and has no value", shortened(routine.name)),
                       "write the call on a line of its own, or make it a FUNC");
    return {};
  }
  if (routine.sound && bind(call, expression.place, routine)) {
    const std::vector<Parameter> parameters = parameters_of(routine);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (call.bound[i] == nullptr) continue;
      check_argument(*call.bound[i], routine, *parameters[i].group, parameters[i].declared->name);
    }
  }
  return routine.result;
}

/// Finds the argument of each parameter: the unnamed ones in order, then those by name; null where
/// the default stands in.
bool ExpressionChecker::bind(Call& call, Place place, const Routine& routine) {
  const std::vector<Parameter> parameters = parameters_of(routine);
  const auto refuse = [&](std::string_view code, Place where, std::string message,
                          std::string help = "") {
    diagnostics_.error(code, where, std::move(message), std::move(help));
    return false;
  };
  call.bound.assign(parameters.size(), nullptr);
  bool named = false;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const Expr& argument = *call.arguments[i];
    const std::string& name = call.names[i];
    std::size_t at = i;
    if (name.empty() && named) {
      return refuse(code::kArgumentName, argument.place,
                    "an argument without name behind one with a name",
                    "name it, too, or put it before the named ones");
    }
    if (!name.empty()) {
      named = true;
      for (at = 0; at < parameters.size(); ++at) {
        if (same_word(parameters[at].declared->name, name)) break;
      }
      std::vector<std::string_view> names;
      for (const Parameter& parameter : parameters) names.push_back(parameter.declared->name);
      if (at == parameters.size()) {
        return refuse(
            code::kArgumentName, argument.place,
            fmt::format("{} has no parameter {}", shortened(routine.name), shortened(name)),
            did_you_mean(suggest(name, names)));
      }
    }
    if (at >= parameters.size()) {
      return refuse(
          code::kArgumentCount, place,
          fmt::format("{} has {} parameter{}; here are {} arguments", shortened(routine.name),
                      parameters.size(), parameters.size() == 1 ? "" : "s", call.arguments.size()));
    }
    if (call.bound[at] != nullptr) {
      return refuse(code::kArgumentName, argument.place,
                    fmt::format("{} is given twice", shortened(parameters[at].declared->name)));
    }
    call.bound[at] = &argument;
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (call.bound[i] != nullptr || parameters[i].group->value != nullptr) continue;
    return refuse(code::kArgumentCount, place,
                  fmt::format("{} needs {}", shortened(routine.name),
                              shortened(parameters[i].declared->name)),
                  fmt::format("it is {}", in_words(parameters[i].group->type)));
  }
  return true;
}

bool ExpressionChecker::check_argument(const Expr& argument, const Routine& routine,
                                       const Routine::Parameters& group, std::string_view name) {
  const std::string needs = fmt::format("{} of {} needs", shortened(name), shortened(routine.name));
  if (!group.by_reference) return accept(argument, group.type, needs);
  if (argument.type.kind == Type::Kind::Unknown || group.type.kind == Type::Kind::Unknown) {
    return false;
  }
  const Name* const variable = root_of(argument);
  const bool fits = variable != nullptr && variable->symbol != nullptr &&
                    variable->symbol->kind == Symbol::Kind::Variable && argument.type == group.type;
  if (fits) {
    uses_.referred(*variable->symbol, argument.place);
    return true;
  }
  diagnostics_.error(
      code::kReferenceArgument, argument.place,
      fmt::format("{} a variable here, {}, since it is REF", needs, in_words(group.type)),
      "declare one with VAR and its type, and give its name");
  return false;
}

void ExpressionChecker::report_unknown_function(std::string_view name, Place place) {
  if (name.find('.') != std::string_view::npos) return report_no_such_name(name, place);
  std::vector<std::string_view> names = builtin_names();
  for (const Routine& routine : program_.routines) {
    if (!routine.handler) names.emplace_back(routine.name);
  }
  diagnostics_.error(code::kUnknownFunction, place,
                     fmt::format("unknown function {}", shortened(name)),
                     did_you_mean(suggest(name, names)));
}

}  // namespace rob::lang

#include "runtime/files/signal_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "lang/text/source_text.h"
#include "lang/text/suggest.h"
#include "lang/values/number_text.h"
#include "lang/values/percent_text.h"
#include "lang/values/setting.h"
#include "runtime/files/line_reader.h"
#include "runtime/words/codes.h"
#include "runtime/words/signature.h"

namespace rob::runtime {

namespace {

using lang::TokenKind;
using Comparison = SimulationRule::Comparison;

// [choice] A rule a `when` is looked at in every cycle; a thousand take some microseconds.
constexpr std::size_t kMostRules = 1000;
constexpr double kLatest = 1e6;  // s: as long as a WAIT may be

/// A signal that a name stands for, and what its volts mean.
struct Known {
  std::string name;
  WorldSignal signal;
  lang::NamedSignal scale;

  bool analog() const {
    return signal.kind == WorldSignal::Kind::AnalogInput ||
           signal.kind == WorldSignal::Kind::AnalogOutput;
  }
};

std::optional<Comparison> comparison_of(TokenKind kind) {
  switch (kind) {
    case TokenKind::Equal:
      return Comparison::Equal;
    case TokenKind::NotEqual:
      return Comparison::NotEqual;
    case TokenKind::Less:
      return Comparison::Less;
    case TokenKind::LessEqual:
      return Comparison::LessEqual;
    case TokenKind::Greater:
      return Comparison::Greater;
    case TokenKind::GreaterEqual:
      return Comparison::GreaterEqual;
    default:
      return std::nullopt;
  }
}

/// The comparison with its sides exchanged in meaning: what falls where it rose.
Comparison reversed(Comparison comparison) {
  switch (comparison) {
    case Comparison::Less:
      return Comparison::Greater;
    case Comparison::LessEqual:
      return Comparison::GreaterEqual;
    case Comparison::Greater:
      return Comparison::Less;
    case Comparison::GreaterEqual:
      return Comparison::LessEqual;
    default:
      return comparison;
  }
}

class ScriptReader : LineReader {
 public:
  ScriptReader(SignalScript& script, const motion::RobotModel& robot,
               const std::vector<lang::NamedSignal>& named,
               const std::vector<lang::DeviceCode>& devices)
      : LineReader(script.source, script.diagnostics, code::kScriptLine,
                   "a line is: at 2.5s part_here = ON, or: when lift_up == ON after 0.3s : "
                   "part_here = ON"),
        script_(script),
        devices_(devices) {
    know(robot, named);
  }

  void read() {
    read_lines([&] {
      rule();
      return true;
    });
  }

 private:
  void know(const motion::RobotModel& robot, const std::vector<lang::NamedSignal>& named);
  void rule();
  void condition(SimulationRule& rule);
  SimulatedSetting setting();
  std::optional<SimulatedSetting> operators_setting();
  void pressed(std::string_view name, std::string help);
  double share();
  const Known& signal();
  double time(std::string_view behind);
  double value_for(const Known& known);
  bool truth(std::string_view name);
  double quantity(const Known& known);

  std::optional<SignalScript::Line> line_of_device(double time);

  SignalScript& script_;
  const std::vector<lang::DeviceCode>& devices_;
  std::vector<Known> known_;
};

void ScriptReader::know(const motion::RobotModel& robot,
                        const std::vector<lang::NamedSignal>& named) {
  const lang::RobotSignature signature = signature_of(robot);
  const auto add = [&](std::string name, std::size_t index, const lang::NamedSignal& scale) {
    const lang::RobotSignature::Signal& signal = signature.signals[index];
    using Kind = WorldSignal::Kind;
    const Kind kind = signal.analog ? (signal.output ? Kind::AnalogOutput : Kind::AnalogInput)
                                    : (signal.output ? Kind::Output : Kind::Input);
    known_.push_back(
        {std::move(name), {kind, static_cast<std::uint8_t>(signal.channel - 1)}, scale});
  };
  for (const lang::NamedSignal& signal : named) {
    add(signal.name, static_cast<std::size_t>(signal.signal), signal);
  }
  for (std::size_t i = 0; i < signature.signals.size(); ++i) {
    const lang::RobotSignature::Signal& signal = signature.signals[i];
    const lang::NamedSignal volts{.name = "",
                                  .signal = static_cast<int>(i),
                                  .dimension = lang::kVoltage,
                                  .low = 0,
                                  .high = lang::kMostVolts};
    if (!signal.name.empty()) add(signal.name, i, volts);
    const char* const word = lang::channel_word(signal.output, signal.analog);
    add(fmt::format("{}[{}]", word, signal.channel), i, volts);
  }
}

// rule = "at" TIME setting
//      | "when" signal ( "==" | "<>" | "<" | "<=" | ">" | ">=" ) value [ "after" TIME ] ":" setting
void ScriptReader::rule() {
  SimulationRule rule;
  const lang::Place place = token_.place;
  if (at_word("at")) {
    advance();
    rule.time = time("at");
    if (auto line = line_of_device(rule.time)) {
      script_.lines.push_back(std::move(*line));
      return end_of_line();
    }
  } else if (at_word("when")) {
    advance();
    rule.timed = false;
    condition(rule);
    if (at_word("after")) {
      advance();
      rule.time = time("after");
    }
    take(TokenKind::Colon, "':'");
  } else {
    expected("at or when");
  }
  rule.setting = setting();
  end_of_line();
  if (script_.rules.size() == kMostRules) {
    fail(code::kScriptLine, place, fmt::format("a script has at most {} lines", kMostRules));
  }
  script_.rules.push_back(rule);
}

/// device "=" STRING
std::optional<SignalScript::Line> ScriptReader::line_of_device(double time) {
  const auto device = std::ranges::find_if(
      devices_, [&](const lang::DeviceCode& one) { return at_word(one.name); });
  if (device == devices_.end()) return std::nullopt;
  advance();
  take(TokenKind::Assign, "'='");
  return SignalScript::Line{static_cast<std::size_t>(device - devices_.begin()), time,
                            take_text("a text such as \"12.5 g\"")};
}

void ScriptReader::condition(SimulationRule& rule) {
  const Known& known = signal();
  const auto comparison = comparison_of(token_.kind);
  const bool order =
      comparison && *comparison != Comparison::Equal && *comparison != Comparison::NotEqual;
  if (!comparison) expected("a comparison such as ==");
  if (order && !known.analog()) {
    fail(code::kScriptValue, token_.place,
         fmt::format("{} is ON or OFF; compare it with == or <>", known.name));
  }
  advance();
  rule.watched = known.signal;
  rule.reference = value_for(known);
  const bool falling = known.analog() && known.scale.high < known.scale.low;
  rule.comparison = falling ? reversed(*comparison) : *comparison;
}

// setting = signal "=" value | ( "GO" | "HOLD" | "STOP" ) "=" "ON" | "OVERRIDE" "=" SHARE
//         | "ANSWER" "=" STRING | device "=" STRING
SimulatedSetting ScriptReader::setting() {
  if (auto line = line_of_device(0)) {
    script_.said.push_back(std::move(*line));
    return {{WorldSignal::Kind::Line, 0}, 0, static_cast<std::uint32_t>(script_.said.size() - 1)};
  }
  if (const auto operators = operators_setting()) return *operators;
  const lang::Place place = token_.place;
  const Known& known = signal();
  using Kind = WorldSignal::Kind;
  if (known.signal.kind == Kind::Output || known.signal.kind == Kind::AnalogOutput) {
    fail(code::kScriptSignal, place,
         fmt::format("{} is an output: the program sets it, no script can", known.name),
         "set an input");
  }
  take(TokenKind::Assign, "'='");
  return {known.signal, value_for(known), 0};
}

/// Those of the names that are the operator's; they go before a signal of the same name.
std::optional<SimulatedSetting> ScriptReader::operators_setting() {
  using Kind = WorldSignal::Kind;
  constexpr std::pair<std::string_view, Kind> kNames[] = {{"GO", Kind::Go},
                                                          {"ANSWER", Kind::Answer},
                                                          {"HOLD", Kind::Hold},
                                                          {"STOP", Kind::Stop},
                                                          {"OVERRIDE", Kind::Override}};
  const auto* const found =
      std::ranges::find_if(kNames, [&](const auto& name) { return at_word(name.first); });
  if (found == std::end(kNames)) return std::nullopt;
  const Kind kind = found->second;
  SimulatedSetting setting{{kind, 0}, 1, static_cast<std::uint32_t>(script_.answers.size())};
  advance();
  take(TokenKind::Assign, "'='");
  if (kind == Kind::Go) setting.value = truth("GO") ? 1 : 0;
  if (kind == Kind::Hold) pressed("HOLD", "write HOLD = ON; GO = ON lets the robot go on");
  if (kind == Kind::Stop) pressed("STOP", "write STOP = ON; it ends the run");
  if (kind == Kind::Override) setting.value = share();
  if (kind == Kind::Answer) script_.answers.push_back(take_text("a text such as \"7\""));
  return setting;
}

/// ON, of what the operator can do but not take back.
void ScriptReader::pressed(std::string_view name, std::string help) {
  if (!at_word("ON") && !at_word("TRUE")) {
    fail(code::kScriptValue, token_.place, fmt::format("{} is ON, not {}", name, shown()),
         std::move(help));
  }
  advance();
}

double ScriptReader::share() {
  const lang::NumberLiteral& number = token_.number;
  const bool percent =
      token_.kind == TokenKind::Number && number.has_unit && number.dimension == lang::kNone;
  if (!percent || !(number.value > 0) || number.value > lang::kMostOverride) {
    fail(code::kScriptValue, token_.place,
         fmt::format("OVERRIDE is a share above 0% and at most {}, not {}",
                     lang::percent_text(lang::kMostOverride), shown()),
         "for example OVERRIDE = 30%");
  }
  const double share = number.value;
  advance();
  return share;
}

const Known& ScriptReader::signal() {
  if (token_.kind != TokenKind::Word) expected("the name of a signal");
  std::string name(token_.text);
  lang::Place place = token_.place;
  advance();
  if (token_.kind == TokenKind::LeftBracket) {
    advance();
    if (token_.kind != TokenKind::Number || !token_.number.is_integer) {
      expected("the number of the channel");
    }
    name = fmt::format("{}[{}]", name, token_.number.integer);
    advance();
    if (token_.kind != TokenKind::RightBracket) expected("']'");
    place.length = token_.place.column + 1 - place.column;
    advance();
  }
  const auto found = std::ranges::find_if(
      known_, [&](const Known& known) { return lang::same_word(known.name, name); });
  if (found != known_.end()) return *found;
  std::vector<std::string_view> names;
  for (const Known& known : known_) names.emplace_back(known.name);
  fail(code::kScriptSignal, place,
       fmt::format("neither the program nor the robot has a signal {}", lang::shortened(name)),
       lang::did_you_mean(lang::suggest(name, names)));
}

double ScriptReader::time(std::string_view behind) {
  if (token_.kind != TokenKind::Number || token_.number.dimension != lang::kTime) {
    expected(fmt::format("a time such as 2.5s after {}", behind));
  }
  const double seconds = token_.number.value;
  if (seconds > kLatest) {
    fail(code::kScriptValue, token_.place,
         fmt::format("{} is beyond the {} of a run", lang::number_text(seconds, lang::kTime),
                     lang::number_text(kLatest, lang::kTime)));
  }
  advance();
  return seconds;
}

double ScriptReader::value_for(const Known& known) {
  return known.analog() ? quantity(known) : truth(known.name) ? 1 : 0;
}

bool ScriptReader::truth(std::string_view name) {
  const bool on = at_word("ON") || at_word("TRUE");
  if (!on && !at_word("OFF") && !at_word("FALSE")) {
    fail(code::kScriptValue, token_.place, fmt::format("{} is ON or OFF, not {}", name, shown()));
  }
  advance();
  return on;
}

/// In V.
double ScriptReader::quantity(const Known& known) {
  const lang::Place place = token_.place;
  const bool negative = token_.kind == TokenKind::Minus;
  if (negative) advance();
  const lang::NamedSignal& scale = known.scale;
  if (token_.kind != TokenKind::Number || token_.number.dimension != scale.dimension) {
    fail(code::kScriptValue, token_.place,
         fmt::format("{} is {}, not {}", known.name,
                     lang::in_words(lang::Type::real(scale.dimension)), shown()),
         fmt::format("for example {}", lang::number_text(scale.high, scale.dimension)));
  }
  const lang::NumberLiteral& number = token_.number;
  const double size = number.is_integer ? static_cast<double>(number.integer) : number.value;
  const double value = negative ? -size : size;
  const double volts = (value - scale.low) / ((scale.high - scale.low) / lang::kMostVolts);
  constexpr double kSame = 1e-9;  // V: what rounding can add
  if (volts < -kSame || volts > lang::kMostVolts + kSame) {
    fail(code::kScriptValue, place,
         fmt::format("{} carries {} to {}; {} is beyond that", known.name,
                     lang::number_text(scale.low, scale.dimension),
                     lang::number_text(scale.high, scale.dimension),
                     lang::number_text(value, scale.dimension)));
  }
  advance();
  return volts;
}

}  // namespace

SignalScript parse_signal_script(std::string file, std::string source,
                                 const motion::RobotModel& robot,
                                 const std::vector<lang::NamedSignal>& named,
                                 const std::vector<lang::DeviceCode>& devices) {
  SignalScript script;
  script.file = std::move(file);
  script.source = std::move(source);
  if (!lang::check_source(script.source, script.diagnostics)) return script;
  ScriptReader(script, robot, named, devices).read();
  return script;
}

}  // namespace rob::runtime

#include "runtime/run/json_report.h"

#include <cmath>

#include "lang/text/visible.h"
#include "runtime/run/slow_places.h"

namespace rob::runtime {

using Json = nlohmann::ordered_json;

namespace {

/// To nanoseconds and nanometres: what lies beyond is rounding in the arithmetic.
double rounded(double value, double step) {
  const double result = std::round(value / step) * step;
  // Round once more through the decimal nearest to it, so that 19.1 is written as 19.1.
  const double scale = std::round(1 / step);
  return result == 0 ? 0 : std::round(result * scale) / scale;
}
double seconds(double value) { return rounded(value, 1e-9); }
double millimetres(double value) { return rounded(value, 1e-6); }

Json optional_seconds(const std::optional<double>& value) {
  return value ? Json(seconds(*value)) : Json(nullptr);
}
Json optional_millimetres(const std::optional<double>& value) {
  return value ? Json(millimetres(*value)) : Json(nullptr);
}

/// A line of the program's own file is its number; of another one, with the name of the file.
void put_line(Json& json, const std::vector<std::string>& used, const lang::Place& place) {
  json["line"] = place.line;
  if (place.file > 0) json["file"] = used[place.file - 1];
}
void put_line(Json& json, const std::vector<std::string>& used, int tag) {
  put_line(json, used, lang::tagged_place(tag));
}

/// The planned time of a line or a run, s; null where it was not foretold.
template <typename Result>
Json planned_seconds(const Result& result) {
  return result.foretold ? Json(seconds(result.planned)) : Json(nullptr);
}

Json line_json(const RunResult& result, const LineResult& line, bool measured) {
  Json json;
  put_line(json, result.used, line.line);
  json["starts_s"] = seconds(line.starts);
  json["planned_s"] = planned_seconds(line);
  if (measured) json["measured_s"] = seconds(line.measured);
  json["decides_s"] = optional_seconds(line.decides);
  if (!line.miss_planned) {
    json["corner_miss_mm"] = nullptr;
  } else {
    json["corner_miss_mm"] = Json{{"planned", optional_millimetres(line.miss_planned)}};
    if (measured) json["corner_miss_mm"]["measured"] = optional_millimetres(line.miss_measured);
  }
  if (line.count > 1) json["count"] = line.count;
  if (measured) {
    json["ended"] = line.ended;
    json["s_mm"] = millimetres(line.way);
  }
  return json;
}

Json joints_json(const std::vector<double>& values) {
  Json joints = Json::array();
  for (const double q : values) joints.push_back(millimetres(q));
  return joints;
}

Json final_json(const RunResult& result) {
  if (result.final_joints.empty()) return nullptr;
  Json pose;
  const char* names[] = {"x", "y", "z", "a", "b", "c"};
  for (std::size_t i = 0; i < result.final_pose.size(); ++i) {
    pose[names[i]] = millimetres(result.final_pose[i]);
  }
  return {{"joints", joints_json(result.final_joints)},
          {"measured", joints_json(result.final_measured)},
          {"reference", joints_json(result.final_reference)},
          {"pose", pose}};
}

Json signals_json(const RunResult& result) {
  Json signals = Json::array();
  for (const SignalChange& change : result.signals) {
    Json json{{"t", seconds(change.time)}, {"name", change.name}};
    if (change.number) {
      json["value"] = *change.number;
      json["unit"] = change.unit;
    } else {
      json["value"] = change.value;
    }
    put_line(json, result.used, change.line);
    signals.push_back(std::move(json));
  }
  return signals;
}

Json events_json(const RunResult& result) {
  Json events = Json::array();
  for (const RunEvent& event : result.events) {
    Json json{{"t", seconds(event.time)}, {"kind", event.kind}};
    put_line(json, result.used, event.line);
    json["text"] = event.text;
    json["q"] = joints_json(event.joints);
    events.push_back(std::move(json));
  }
  return events;
}

Json peaks_json(const RunResult& result) {
  Json peaks = Json::object();
  for (const AxisPeak& peak : result.peaks) {
    peaks[peak.axis] = {{"v", peak.v}, {"a", peak.a}, {"j", peak.j}};
  }
  return peaks;
}

const char* name_of(lang::Severity severity) {
  return severity == lang::Severity::Error     ? "error"
         : severity == lang::Severity::Warning ? "warning"
                                               : "note";
}

void put_contact(Json& json, const RunResult& result) {
  json["link"] = result.contact->body;
  json["obstacle"] = result.contact->other;
  json["at_s"] = result.contact->at;
  json["joints"] = result.contact_joints;
}

Json findings_json(const RunResult& result) {
  Json findings = Json::array();
  for (const lang::Diagnostic& finding : result.findings) {
    Json json{{"severity", name_of(finding.severity)}, {"code", finding.code}};
    put_line(json, result.used, finding.place);
    json["column"] = finding.place.column;
    json["message"] = finding.message;
    json["help"] = finding.help;
    if (result.contact && finding.severity == lang::Severity::Error) put_contact(json, result);
    findings.push_back(std::move(json));
  }
  return findings;
}

/// Those that have been left out, too.
std::size_t findings_count(const RunResult& result) {
  return result.findings.size() + result.findings_left_out;
}

Json slow_places_json(const RunResult& result) {
  const auto name = [](SlowPlace::Cause cause) {
    constexpr const char* kNames[] = {"speed", "acceleration", "jerk", "end of path"};
    return kNames[static_cast<std::size_t>(cause)];
  };
  const auto near = [](motion::SingularPlace place) -> Json {
    constexpr const char* kNames[] = {"", "wrist", "shoulder", "elbow", "chain"};
    if (place == motion::SingularPlace::None) return nullptr;
    return kNames[static_cast<std::size_t>(place)];
  };
  Json places = Json::array();
  for (const SlowPlace& place : result.slow_places) {
    Json json;
    put_line(json, result.used, place.line);
    json["t"] = seconds(place.time);
    json["at_mm"] = millimetres(place.at);
    json["speed_mm_s"] = millimetres(place.speed);
    json["asked_mm_s"] = millimetres(place.asked);
    json["limit"] = name(place.cause);
    json["axis"] = place.axis.empty() ? Json(nullptr) : Json(place.axis);
    json["corner"] = place.corner;
    json["near"] = near(place.near);
    json["text"] = cause_of(place);
    places.push_back(std::move(json));
  }
  return places;
}

}  // namespace

Json problem_json(const std::optional<Problem>& problem) {
  if (!problem) return nullptr;
  Json calls = Json::array();
  for (const lang::CallSite& call : problem->calls) {
    Json json{{"routine", call.routine}};
    put_line(json, problem->used, call.line);
    calls.push_back(std::move(json));
  }
  return {{"code", problem->code},
          {"file", problem->file},
          {"line", problem->place.line},
          {"column", problem->place.column},
          {"message", problem->message},
          {"help", problem->help},
          {"calls", calls}};
}

namespace {

// Stands where the list of lines comes.
constexpr const char* kLines = "lines of the run";

Json run_json(const RunResult& result) {
  return {{"status", result.status},
          {"robot", result.robot},
          {"law", result.law},
          {"clock", result.clock},
          {"planned_s", planned_seconds(result)},
          {"measured_s", seconds(result.measured)},
          {"cycles", result.cycles},
          {"late_cycles", result.late_cycles},
          {"worst_lateness_us", rounded(result.worst_lateness * 1e6, 1e-3)},
          {"lines", kLines},
          {"final", final_json(result)},
          {"signals", signals_json(result)},
          {"signals_count", result.signals_count},
          {"output", result.output},
          {"output_count", result.output_count},
          {"events", events_json(result)},
          {"events_count", result.events_count},
          {"findings", findings_json(result)},
          {"findings_count", findings_count(result)},
          {"starved", result.starved},
          {"dropped_effects", result.dropped_effects},
          {"lost_rows", result.lost_rows},
          {"worst_u_sat", result.worst_saturation},
          {"peak", peaks_json(result)},
          {"deviation_mm", millimetres(result.deviation)},
          {"error", problem_json(result.error)}};
}

Json check_json(const RunResult& result) {
  return {{"status", result.status},
          {"robot", result.robot},
          {"law", result.law},
          {"planned_s", planned_seconds(result)},
          {"lines", kLines},
          {"slow_places", slow_places_json(result)},
          {"findings", findings_json(result)},
          {"findings_count", findings_count(result)},
          {"error", problem_json(result.error)}};
}

/// A document as it is printed, `indent` blanks deeper than its first line.
std::string text_of(const Json& json, std::size_t indent) {
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
  const std::string blanks(indent, ' ');
  std::string deeper;
  for (const char c : text) {
    deeper += c;
    if (c == '\n') deeper += blanks;
  }
  return lang::visible_json(deeper);
}

void put_lines(const RunResult& result, bool measured, std::size_t indent, const Put& put) {
  if (result.lines.empty()) return put("[]");
  const std::string margin = std::string(1, '\n').append(indent + 2, ' ');
  const char* comma = "[";
  for (const LineResult& line : result.lines) {
    put(comma);
    put(margin);
    put(text_of(line_json(result, line, measured), indent + 2));
    comma = ",";
  }
  put(std::string(1, '\n').append(indent, ' ').append("]"));
}

void put_document(const Json& json, const RunResult& result, bool measured, std::size_t indent,
                  const Put& put) {
  const std::string text = text_of(json, indent);
  const std::string lines = Json(kLines).dump();
  const std::size_t at = text.find("\"lines\": " + lines) + std::string("\"lines\": ").size();
  put(text.substr(0, at));
  put_lines(result, measured, indent + 2, put);
  put(text.substr(at + lines.size()));
}

}  // namespace

void put_run_json(const RunResult& result, std::size_t indent, const Put& put) {
  put_document(run_json(result), result, true, indent, put);
}

void put_check_json(const RunResult& result, std::size_t indent, const Put& put) {
  put_document(check_json(result), result, false, indent, put);
}

std::string json_text(const Json& document) {
  return lang::visible_json(document.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace rob::runtime

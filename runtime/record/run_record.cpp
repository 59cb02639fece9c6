#include "runtime/record/run_record.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "runtime/run/line_text.h"
#include "runtime/words/state_name.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

using Json = nlohmann::ordered_json;

// JSON Schemas of the messages. Those of Foxglove have the fields of its own schemas of these
// names.
constexpr const char* kJointsSchema =
    R"({"title":"rob.Joints","type":"object","properties":{"line":{"type":"string"},"q":{"type":"array","items":{"type":"number"}},"qd":{"type":"array","items":{"type":"number"}},"qdd":{"type":"array","items":{"type":"number"}},"a":{"type":"array","items":{"type":"number"}},"drive":{"type":"array","items":{"type":"number"}}}})";
constexpr const char* kPoseSchema =
    R"({"title":"foxglove.PoseInFrame","type":"object","properties":{"timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer","minimum":0},"nsec":{"type":"integer","minimum":0,"maximum":999999999}}},"frame_id":{"type":"string"},"pose":{"title":"foxglove.Pose","type":"object","properties":{"position":{"title":"foxglove.Vector3","type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},"orientation":{"title":"foxglove.Quaternion","type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"},"w":{"type":"number"}}}}}}})";
constexpr const char* kStateSchema =
    R"({"title":"rob.State","type":"object","properties":{"state":{"type":"string"},"line":{"type":"string"},"override":{"type":"number"},"limit":{"type":"integer"}}})";
constexpr const char* kSignalSchema =
    R"({"title":"rob.Signal","type":"object","properties":{"name":{"type":"string"},"value":{"type":["boolean","number"]},"unit":{"type":"string"},"line":{"type":"string"}}})";
constexpr const char* kLogSchema =
    R"({"title":"foxglove.Log","type":"object","properties":{"timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer","minimum":0},"nsec":{"type":"integer","minimum":0,"maximum":999999999}}},"level":{"type":"integer"},"message":{"type":"string"},"name":{"type":"string"},"file":{"type":"string"},"line":{"type":"integer","minimum":0}}})";

// foxglove.Log's levels.
constexpr int kInfo = 2;
constexpr int kError = 4;

/// A run begins at 0; what is before it, at its beginning.
std::uint64_t nanoseconds(double seconds) {
  return seconds > 0 ? static_cast<std::uint64_t>(std::llround(seconds * 1e9)) : 0;
}

Json timestamp(std::uint64_t time) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  return {{"sec", time / kSecond}, {"nsec", time % kSecond}};
}

void put_values(std::string& text, const char* name, const std::vector<double>& values) {
  fmt::format_to(std::back_inserter(text), ",\"{}\":[", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{}{:.17g}", i == 0 ? "" : ",", values[i]);
  text += ']';
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

RunRecord::RunRecord(const std::string& path, const motion::RobotModel& robot, std::string program,
                     std::vector<std::string> used, const std::vector<RecordedFile>& files)
    : robot_(robot), program_(std::move(program)), used_(std::move(used)), writer_(path) {
  joints_ = writer_.add_channel("/joints", "rob.Joints", kJointsSchema);
  pose_ = writer_.add_channel("/pose", "foxglove.PoseInFrame", kPoseSchema);
  state_ = writer_.add_channel("/state", "rob.State", kStateSchema);
  signals_ = writer_.add_channel("/signals", "rob.Signal", kSignalSchema);
  log_ = writer_.add_channel("/log", "foxglove.Log", kLogSchema);
  for (const RecordedFile& file : files) writer_.attach(file.name, file.media_type, file.text);
}

void RunRecord::row(const Snapshot& snapshot) {
  const std::uint64_t time = nanoseconds(snapshot.sample.reference.time);
  put_joints(snapshot, time);
  put_pose(robot_.kinematics->forward(snapshot.sample.reference.q), time);
  put_state(snapshot, time);
}

/// The numbers as in the trace: mm or deg, 17 digits.
void RunRecord::put_joints(const Snapshot& snapshot, std::uint64_t time) {
  const motion::GeneratorSample& sample = snapshot.sample;
  std::string text = "{\"line\":" + dumped(line_text(static_cast<int>(sample.tag), used_));
  put_values(text, "q", shown_joints(robot_, sample.reference.q));
  put_values(text, "qd", shown_joints(robot_, sample.reference.qd));
  put_values(text, "qdd", shown_joints(robot_, sample.reference.qdd));
  put_values(text, "a", shown_joints(robot_, snapshot.measured));
  std::vector<double> drive;
  for (int i = 0; i < robot_.axis_count(); ++i) drive.push_back(snapshot.drive[i]);
  put_values(text, "drive", drive);
  writer_.add_message(joints_, time, text + "}");
}

/// m, as Foxglove wants it.
void RunRecord::put_pose(const motion::Pose& pose, std::uint64_t time) {
  const Eigen::Quaterniond& turn = pose.orientation;
  const Json json{
      {"timestamp", timestamp(time)},
      {"frame_id", "world"},
      {"pose",
       {{"position",
         {{"x", pose.position.x()}, {"y", pose.position.y()}, {"z", pose.position.z()}}},
        {"orientation", {{"x", turn.x()}, {"y", turn.y()}, {"z", turn.z()}, {"w", turn.w()}}}}}};
  writer_.add_message(pose_, time, dumped(json));
}

/// When it changes.
void RunRecord::put_state(const Snapshot& snapshot, std::uint64_t time) {
  const motion::GeneratorSample& sample = snapshot.sample;
  const Json json{{"state", state_name(sample.state)},
                  {"line", line_text(static_cast<int>(sample.tag), used_)},
                  {"override", snapshot.override_share},
                  {"limit", sample.limit}};
  std::string text = dumped(json);
  if (text == last_state_) return;
  writer_.add_message(state_, time, text);
  last_state_ = std::move(text);
}

void RunRecord::signal(const SignalChange& change) {
  Json json{{"name", change.name}};
  if (change.number) {
    json["value"] = *change.number;
    json["unit"] = change.unit;
  } else {
    json["value"] = change.value;
  }
  json["line"] = line_text(change.line, used_);
  writer_.add_message(signals_, nanoseconds(change.time), dumped(json));
}

void RunRecord::print(double time, int line, const std::string& text) {
  log(time, kInfo, line, text);
}

void RunRecord::log(double time, int level, int line, const std::string& text) {
  const std::uint64_t at = nanoseconds(time);
  const Json json{{"timestamp", timestamp(at)},
                  {"level", level},
                  {"message", text},
                  {"name", "rob"},
                  {"file", file_of(line)},
                  {"line", lang::tagged_place(line).line}};
  writer_.add_message(log_, at, dumped(json));
}

bool RunRecord::finish(const RunResult& result) {
  for (const RunEvent& event : result.events)
    log(event.time, kInfo, event.line,
        event.text.empty() ? event.kind : event.kind + ": " + event.text);
  if (result.error)
    log(result.measured, kError, static_cast<int>(lang::line_tag(result.error->place)),
        fmt::format("{}: {}", result.error->code, result.error->message));
  return writer_.close();
}

/// By its base name: a record does not depend on where it was made.
std::string RunRecord::file_of(int tag) const {
  const lang::Place place = lang::tagged_place(tag);
  const std::string& path = place.file == 0 ? program_ : used_.at(place.file - 1);
  return path.substr(path.rfind('/') + 1);
}

}  // namespace rob::runtime

#include "runtime/record/recorded_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/files/kept_values.h"
#include "runtime/files/points_file.h"
#include "runtime/record/mcap_reader.h"
#include "runtime/words/version.h"

namespace rob::runtime {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kOptions = "options.json";
constexpr std::size_t kMostFile = std::size_t{64} << 20U;  // bytes [choice] as a record has

/// The files, gathered under names that differ.
class Gathering {
 public:
  explicit Gathering(fs::path root) : root_(std::move(root)) {}

  /// Returns where it is, seen from the root. A file that is not there is left out.
  std::string add(const std::string& path, const char* media_type) {
    const fs::path absolute = fs::weakly_canonical(path);
    const std::string place = absolute.lexically_relative(root_).string();
    if (!fs::is_regular_file(absolute)) return place;
    const std::string name = free_name(absolute.filename().string());
    places_[name] = place;
    files_.push_back({name, media_type, read_file(path, kMostFile)});
    return place;
  }
  std::vector<RecordedFile> take() { return std::move(files_); }
  Json places() const { return places_; }

 private:
  std::string free_name(const std::string& base) const {
    std::string name = base;
    for (int i = 2; places_.contains(name) || name == kOptions; ++i)
      name = fmt::format("{}.{}", base, i);
    return name;
  }

  fs::path root_;
  std::vector<RecordedFile> files_;
  std::map<std::string, std::string> places_;
};

/// The innermost folder that all of these are in.
fs::path common_folder(const std::vector<std::string>& paths) {
  fs::path common = fs::weakly_canonical(paths.front()).parent_path();
  for (const std::string& path : paths) {
    const fs::path folder = fs::weakly_canonical(path).parent_path();
    const auto [end, other] =
        std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
    fs::path shared;
    for (auto part = common.begin(); part != end; ++part) shared /= *part;
    common = shared;
  }
  return common;
}

Json json_of(const RecordedOptions& options, const Json& places) {
  return {{"version", kVersion},
          {"program", options.program},
          {"robot", options.robot},
          {"law", options.law},
          {"signals", options.signals},
          {"seed", options.seed},
          {"cell", options.cell ? Json(*options.cell) : Json()},
          {"override", options.override_share},
          {"date", {{"unix", options.date.unix}, {"offset", options.date.offset}}},
          {"clock", options.virtual_clock ? "virtual" : "system"},
          {"files", places}};
}

RecordedOptions options_of(const Json& json) {
  RecordedOptions options;
  options.program = json.at("program").get<std::string>();
  options.robot = json.at("robot").get<std::string>();
  options.law = json.at("law").get<std::string>();
  options.signals = json.at("signals").get<std::string>();
  options.seed = json.at("seed").get<std::uint64_t>();
  if (!json.at("cell").is_null()) options.cell = json.at("cell").get<std::uint64_t>();
  options.override_share = json.at("override").get<double>();
  options.date = {json.at("date").at("unix").get<double>(),
                  json.at("date").at("offset").get<int>()};
  options.virtual_clock = json.at("clock") == "virtual";
  return options;
}

/// The line, q, qd and qdd of a message of /joints, as RunRecord writes it.
std::string_view reference_of(std::string_view joints) {
  return joints.substr(0, joints.find(",\"a\":"));
}

/// A name that leads out of the folder is nobody's who means well.
fs::path inside(const fs::path& folder, const std::string& place) {
  const fs::path relative = fs::path(place).lexically_normal();
  if (relative.empty() || relative.is_absolute() || *relative.begin() == "..")
    throw FileError(fmt::format("the record names a file outside its folder: '{}'", place));
  return folder / relative;
}

}  // namespace

std::vector<RecordedFile> files_of_run(const LoadedProgram& program, RecordedOptions options,
                                       const std::string& robot_file,
                                       const std::string& script_file) {
  std::vector<std::string> sources = used_names(program);
  sources.push_back(program.file);
  if (!robot_file.empty()) sources.push_back(robot_file);
  if (!script_file.empty()) sources.push_back(script_file);
  Gathering gathering(common_folder(sources));
  options.program = gathering.add(program.file, "text/x-rob");
  for (const std::string& used : used_names(program)) gathering.add(used, "text/x-rob");
  gathering.add(points_file_of(program.file), "text/plain");
  gathering.add(values_file_of(program.file), "text/plain");
  if (!robot_file.empty()) options.robot = gathering.add(robot_file, "application/toml");
  if (!script_file.empty()) options.signals = gathering.add(script_file, "text/plain");
  const std::string text = json_of(options, gathering.places()).dump(2) + "\n";
  std::vector<RecordedFile> files = gathering.take();
  files.push_back({kOptions, "application/json", text});
  return files;
}

RecordedOptions unpack(const std::vector<RecordedFile>& files, const std::string& folder) {
  const auto options = std::ranges::find(files, kOptions, &RecordedFile::name);
  if (options == files.end())
    throw FileError("the record has no options.json: it is not one of rob run --mcap");
  try {
    const Json json = Json::parse(options->text);
    for (const RecordedFile& file : files) {
      if (file.name == kOptions) continue;
      const fs::path path = inside(folder, json.at("files").at(file.name).get<std::string>());
      fs::create_directories(path.parent_path());
      save_file(path.string(), file.text);
    }
    RecordedOptions recorded = options_of(json);
    recorded.program = inside(folder, recorded.program).string();
    if (recorded.robot.ends_with(".toml")) recorded.robot = inside(folder, recorded.robot).string();
    if (!recorded.signals.empty()) recorded.signals = inside(folder, recorded.signals).string();
    return recorded;
  } catch (const Json::exception& error) {
    throw FileError(fmt::format("options.json of the record is damaged: {}", error.what()));
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("the record cannot be unpacked: {}", error.code().message()));
  }
}

Comparison compare_records(const std::string& first, const std::string& second, bool measured) {
  constexpr std::string_view kTopic = "/joints";
  constexpr double kSecond = 1e9;  // ns
  McapReader one(first);
  McapReader other(second);
  Comparison comparison;
  McapReader::Message a;
  McapReader::Message b;
  for (;;) {
    const bool more = one.next(kTopic, a);
    const bool other_more = other.next(kTopic, b);
    if (!more && !other_more) return comparison;
    const bool same = a.time == b.time &&
                      (measured ? a.text == b.text : reference_of(a.text) == reference_of(b.text));
    if (more != other_more || !same) {
      comparison.differs_from = static_cast<double>(more ? a.time : b.time) / kSecond;
      return comparison;
    }
    ++comparison.references;
  }
}

}  // namespace rob::runtime

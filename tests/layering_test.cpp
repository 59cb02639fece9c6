// Holds every include of the layers to docs/architecture.md: who may know whom, and which
// package may be seen where.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/source_files.h"

namespace fs = std::filesystem;

using rob::test::Include;
using rob::test::includes_of;
using rob::test::layers;
using rob::test::SourceFile;
using rob::test::sources_in;

namespace {

/// Folders whose names begin a path, and files: "motion/space" covers "motion/space/pose.h".
bool lies_in(std::string_view path, std::string_view folder) {
  if (path == folder) return true;
  return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

/// What each folder may include of the project, itself aside. The first entry that covers a file
/// counts.
struct LayerRule {
  std::string_view folder;
  std::vector<std::string_view> may_include;
};

const std::vector<LayerRule>& layer_rules() {
  static const std::vector<LayerRule> rules = [] {
    std::vector<LayerRule> made = {{"base", {}}};
    // Inside lang: each room knows those before it; the Vm, the formatter and help stand beside
    // check and compile.
    std::vector<std::string_view> known;
    for (const char* folder : {"lang/text", "lang/values", "lang/machine", "lang/code",
                               "lang/syntax", "lang/check", "lang/compile"}) {
      made.push_back({folder, known});
      known.push_back(folder);
    }
    const std::vector<std::string_view> up_to_syntax(known.begin(), known.begin() + 5);
    for (const char* folder : {"lang/vm", "lang/format", "lang/help"}) {
      made.push_back({folder, up_to_syntax});
    }
    // The facade, for programs that embed the language.
    made.push_back({"lang", {"lang"}});
    // Inside motion: space → kinematics → collision; with dynamics, cell → robots → path → plan →
    // ahead → generate → force.
    const std::vector<LayerRule> of_motion = {
        {"motion/space", {}},
        {"motion/kinematics", {"motion/space"}},
        {"motion/cell", {"motion/space"}},
        {"motion/collision", {"motion/space", "motion/kinematics"}},
        {"motion/dynamics", {"motion/space"}},
        {"motion/servo", {"motion/space", "motion/dynamics"}},
    };
    made.insert(made.end(), of_motion.begin(), of_motion.end());
    std::vector<std::string_view> below = {"motion/space", "motion/cell", "motion/kinematics",
                                           "motion/dynamics", "motion/collision"};
    for (const char* folder : {"motion/robots", "motion/path", "motion/plan", "motion/ahead",
                               "motion/generate", "motion/force"}) {
      made.push_back({folder, below});
      below.push_back(folder);
    }
    // The facade, for programs that embed the motion; nothing in motion knows it.
    below.push_back("motion/motion.h");
    for (const char* file : {"motion/motion.h", "motion/motion.cpp"}) made.push_back({file, below});
    const std::vector<LayerRule> of_drivers = {
        {"drivers/sim", {"motion/space", "motion/dynamics", "motion/servo"}},
        {"drivers/contact", {"drivers/sim", "motion/space", "motion/cell", "motion/kinematics"}},
        {"drivers/serial", {"motion/servo"}},
        {"drivers/protocol", {}},
        {"drivers/link", {"drivers/protocol", "drivers/serial", "motion/space", "motion/servo"}},
        {"drivers/device", {"drivers/protocol"}},
    };
    made.insert(made.end(), of_drivers.begin(), of_drivers.end());
    // Inside runtime: each room knows those before it; the tick knows no word of lang.
    std::vector<std::string_view> runtime = {"motion", "drivers"};
    for (const char* folder :
         {"runtime/time", "runtime/tick", "runtime/words", "runtime/meshes", "runtime/files",
          "runtime/devices", "runtime/command", "runtime/run", "runtime/pictures", "runtime/record",
          "runtime/import", "runtime/prompt", "runtime/cli"}) {
      made.push_back({folder, runtime});
      runtime.push_back(folder);
      if (made.back().folder == "runtime/tick") runtime.push_back("lang");
    }
    return made;
  }();
  return rules;
}

/// The layers that may see a package, by the first part of its headers' names.
const std::map<std::string, std::set<std::string>, std::less<>>& package_layers() {
  static const std::map<std::string, std::set<std::string>, std::less<>> layers = {
      {"fmt", {"lang", "runtime"}}, {"Eigen", {"motion", "drivers", "runtime"}},
      {"toml++", {"motion"}},       {"nlohmann", {"runtime"}},
      {"CLI", {"runtime"}},         {"readline", {"runtime"}},
      {"dtl", {"runtime"}},         {"urdf_model", {"runtime"}},
      {"urdf_parser", {"runtime"}}, {"console_bridge", {"runtime"}},
      {"assimp", {"runtime"}},      {"libqhull_r", {"runtime"}},
      {"fcl", {"runtime"}},

  };
  return layers;
}

/// Packages that only one file of the project may see: they compile slowly, or are to be
/// replaceable in one place.
constexpr std::array<std::string_view, 9> kOneFileEach = {
    "CLI",    "readline",   "dtl", "urdf_model", "urdf_parser", "console_bridge",
    "assimp", "libqhull_r", "fcl"};

/// Time and threads belong to runtime; a driver may need a thread for its wire.
constexpr std::array<std::string_view, 7> kThreading = {
    "thread", "mutex", "shared_mutex", "condition_variable", "future", "semaphore", "stop_token"};

std::string layer_of(std::string_view file) { return std::string(file.substr(0, file.find('/'))); }

std::string package_of(std::string_view header) {
  return std::string(header.substr(0, header.find_first_of("/.")));
}

bool known_package(std::string_view header) {
  return package_layers().contains(package_of(header)) &&
         header.find('/') != std::string_view::npos;
}

/// Empty, or why `file` may not include a header of this project.
std::string breach_of_layers(std::string_view file, std::string_view header) {
  for (const LayerRule& rule : layer_rules()) {
    if (!lies_in(file, rule.folder)) continue;
    if (lies_in(header, rule.folder) || lies_in(header, "base")) return "";
    for (std::string_view folder : rule.may_include) {
      if (lies_in(header, folder)) return "";
    }
    // A robot file describes its drives.
    if (rule.folder == "motion/robots" && header == "motion/servo/drive_data.h") return "";
    return std::string(rule.folder) + " may not know " + std::string(header);
  }
  return "no layer is known for this folder";
}

/// Empty, or why `file` may not include a header of the system or of a package.
std::string breach_of_packages(std::string_view file, std::string_view header) {
  const std::string layer = layer_of(file);
  if (known_package(header)) {
    return package_layers().at(package_of(header)).contains(layer)
               ? ""
               : layer + " may not see the package " + package_of(header);
  }
  if (layer != "base" && layer != "lang" && layer != "motion") return "";
  // Instructions of one kind of processor, in files that say so by their names.
  if (header == "immintrin.h" && file.ends_with("_avx2.cpp")) return "";
  // What is left are the headers of C++, which have neither a dot nor a folder, and the system's.
  if (header.find_first_of("./") != std::string_view::npos) {
    return layer + " may not see the system's " + std::string(header);
  }
  if (std::find(kThreading.begin(), kThreading.end(), header) != kThreading.end()) {
    return layer + " knows no threads";
  }
  return "";
}

std::string breach(std::string_view file, const Include& include) {
  return include.angled ? breach_of_packages(file, include.path)
                        : breach_of_layers(file, include.path);
}

}  // namespace

TEST_CASE("no layer includes what lies above or beside it") {
  const std::vector<SourceFile> files = layers();
  REQUIRE(files.size() > 20);
  for (const SourceFile& file : files) {
    for (const Include& include : includes_of(file.text)) {
      const std::string found = breach(file.path, include);
      CHECK_MESSAGE(found.empty(), file.path << ": " << found);
    }
  }
}

TEST_CASE("a package that belongs in one place is seen by one file") {
  for (std::string_view package : kOneFileEach) {
    std::set<std::string> seen_by;
    for (const SourceFile& file : layers()) {
      for (const Include& include : includes_of(file.text)) {
        if (include.angled && known_package(include.path) && package_of(include.path) == package) {
          seen_by.insert(file.path);
        }
      }
    }
    CHECK_MESSAGE(seen_by.size() <= 1, package << " is seen by " << seen_by.size() << " files");
  }
}

TEST_CASE("fault 17: no source asks for the time of day, so that setting it moves nothing") {
  for (const SourceFile& file : layers()) {
    if (file.path == "runtime/time/wall_time.cpp") continue;  // once, at the start, for NOW()
    for (const char* asking : {"CLOCK_REALTIME", "system_clock", "gettimeofday", "localtime"}) {
      CHECK_MESSAGE(file.text.find(asking) == std::string::npos, file.path << " uses " << asking);
    }
  }
}

TEST_CASE("the rules refuse what the architecture forbids") {
  const auto refused = [](std::string_view file, std::string_view directive) {
    const std::vector<Include> includes = includes_of(directive);
    REQUIRE(includes.size() == 1);
    return !breach(file, includes.front()).empty();
  };
  CHECK(refused("lang/vm/vm.cpp", "#include \"motion/plan/motion_request.h\""));
  CHECK(refused("base/split_mix.h", "#include \"lang/values/random.h\""));
  CHECK(refused("base/split_mix.h", "#include <Eigen/Core>"));
  CHECK(refused("lang/vm/vm.cpp", "#include \"language/vm.h\""));
  CHECK(refused("motion/plan/feasibility.cpp", "#include \"lang/machine/machine.h\""));
  CHECK(refused("motion/plan/feasibility.cpp", "#include \"motion/generate/motion_event.h\""));
  CHECK(refused("motion/plan/feasibility.cpp", "#include \"feasibility.h\""));
  CHECK(refused("motion/space/pose.h", "  #  include \"motion/kinematics/kinematics.h\""));
  CHECK(refused("motion/kinematics/kinematics.h", "#include \"motion/dynamics/dynamics.h\""));
  CHECK(refused("motion/servo/servo_law.h", "#include \"motion/robots/robot_model.h\""));
  CHECK(refused("motion/robots/robot_model.h", "#include \"motion/servo/servo_law.h\""));
  CHECK(refused("motion/new_folder/thing.h", "#include \"motion/space/pose.h\""));
  CHECK(refused("drivers/sim/sim_gantry.cpp", "#include \"motion/robots/robot_model.h\""));
  CHECK(refused("drivers/sim/sim_gantry.cpp", "#include \"runtime/time/clock.h\""));
  CHECK(refused("drivers/sim/sim_gantry.cpp", "#include \"drivers/contact/sim_cell.h\""));
  CHECK(refused("drivers/device/rob_device.cpp", "#include \"motion/servo/servo_backend.h\""));
  CHECK(refused("runtime/cli/main.cpp", "#include \"tests/support/judge.h\""));
  CHECK(refused("runtime/tick/motion_task.cpp", "#include \"lang/values/slot.h\""));
  CHECK(refused("runtime/tick/motion_task.cpp", "#include \"runtime/words/codes.h\""));
  CHECK(refused("runtime/run/run.cpp", "#include \"runtime/cli/options.h\""));
  CHECK(refused("motion/force/press.cpp", "#include \"motion/motion.h\""));
  CHECK(refused("motion/motion.h", "#include \"motion/servo/servo_law.h\""));
  CHECK(refused("drivers/sim/sim_gantry.cpp", "#include \"motion/motion.h\""));
  CHECK(refused("motion/plan/feasibility.cpp", "#include <fmt/format.h>"));
  CHECK(refused("lang/values/types.cpp", "#include <Eigen/Core>"));
  CHECK(refused("runtime/run/json_report.cpp", "#include <toml++/toml.h>"));
  CHECK(refused("motion/robots/robot_file.cpp", "#include <nlohmann/json.hpp>"));
  CHECK(refused("lang/vm/vm.cpp", "#include <CLI/CLI.hpp>"));
  CHECK(refused("motion/generate/paul.cpp", "#include <thread>"));
  CHECK(refused("motion/generate/paul.cpp", "#include <pthread.h>"));
  CHECK(refused("lang/syntax/lexer.cpp", "#include <sys/stat.h>"));
}

TEST_CASE("the rules admit what the architecture allows") {
  const auto admitted = [](std::string_view file, std::string_view directive) {
    const std::vector<Include> includes = includes_of(directive);
    REQUIRE(includes.size() == 1);
    return breach(file, includes.front()).empty();
  };
  CHECK(admitted("lang/vm/vm.cpp", "#include \"lang/code/opcodes.def\""));
  CHECK(admitted("motion/space/pose.h", "#include \"base/unit_factors.h\""));
  CHECK(admitted("lang/values/types.cpp", "#include <fmt/format.h>"));
  CHECK(admitted("motion/generate/paul.cpp", "#include \"motion/plan/segment_descriptor.h\""));
  CHECK(admitted("motion/generate/paul.cpp", "#include <atomic>  // one writer"));
  CHECK(admitted("motion/robots/robot_model.h", "#include \"motion/servo/drive_data.h\""));
  CHECK(admitted("motion/servo/servo_law.h", "#include <Eigen/Core>"));
  CHECK(admitted("motion/motion.cpp", "#include \"motion/generate/motion_chain.h\""));
  CHECK(admitted("drivers/serial/serial_port.cpp", "#include <termios.h>"));
  CHECK(admitted("drivers/sim/sim_gantry.cpp", "#include \"motion/servo/servo_backend.h\""));
  CHECK(admitted("drivers/contact/sim_cell.h", "#include \"motion/kinematics/kinematics.h\""));
  CHECK(admitted("drivers/contact/sim_cell.h", "#include \"motion/cell/cell_data.h\""));
  CHECK(admitted("runtime/tick/motion_task.cpp", "#include \"drivers/sim/sim_gantry.h\""));
  CHECK(admitted("runtime/prompt/repl.cpp", "#include <readline/readline.h>"));
}

TEST_CASE("what is no include is not taken for one") {
  CHECK(includes_of("// #include \"runtime/main.h\"\nint include;\n#include\n").empty());
}

TEST_CASE("the tables of tests/programs name tests that are there") {
  std::string cases;
  for (const SourceFile& file : sources_in({"tests"})) cases += file.text;
  cases = std::regex_replace(cases, std::regex(R"(TEST_CASE\(\s*")"), "TEST_CASE(\"");
  const fs::path folder = fs::path(ROB_SOURCE_DIR) / "tests" / "programs";
  std::ifstream tables(folder / "README.md");
  int named = 0;
  for (std::string line; std::getline(tables, line);) {
    if (!line.starts_with("| ")) continue;
    static const std::regex name("`([a-z_/]+\\.rob)`|\"([^\"]+)\"");
    for (std::sregex_iterator at(line.begin(), line.end(), name), end; at != end; ++at, ++named) {
      const std::string file = (*at)[1];
      const bool there = file.empty()
                             ? cases.find("TEST_CASE(\"" + (*at)[2].str() + "\"") != cases.npos
                             : fs::exists(folder / file);
      CHECK_MESSAGE(there, "there is no test " << at->str());
    }
  }
  CHECK(named > 150);
}

TEST_CASE("the programs that docs/embedding.md shows are those that are built") {
  const std::string page = rob::test::text_of("docs/embedding.md");
  int programs = 0;
  for (const SourceFile& file : rob::test::sources_in({"tests/embedding"})) {
    const bool shown = page.find("```cpp\n" + file.text + "```\n") != std::string::npos;
    CHECK_MESSAGE(shown, file.path << " is not what the page shows");
    ++programs;
  }
  CHECK(programs == 2);
}

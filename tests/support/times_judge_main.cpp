// Runs random programs of an arm through a built `rob`, each twice: with corners, and with FINE at
// every target. Passing a corner must not take longer than standing in it.
//
//   times_judge ROB ROBOT [N [SEED]]
//   times_judge ROB ROBOT --show SEED     prints one program

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/process.h"
#include "tests/support/random_text.h"

namespace {

using namespace rob::test;

constexpr int kUsage = 64;
/// What a program with corners may take of the time of the same with stops.
constexpr double kMost = 1.01;

/// Where an arm is to work, mm, with a tool that hangs down; deg: its c. Free of what is in cells.
struct Place {
  const char* robot;
  std::array<int, 3> least, most;
  int turn;
};
constexpr Place kPlaces[] = {
    {"irb120", {280, -120, 250}, {400, 120, 370}, 180},
    {"lwa4p", {360, -100, 250}, {470, 100, 350}, 180},
    {"pc104", {680, -200, 450}, {880, 200, 650}, 0},
    {"puma560", {440, -260, -160}, {600, 0, 0}, 180},
    {"ums7", {500, -150, 420}, {680, 150, 580}, 180},
};

/// Lines of motions: what leads to a target, and the ZONE of its corner.
struct Line {
  std::string motion;
  std::string zone;
};

class Writer {
 public:
  Writer(const Place& place, std::uint64_t seed) : place_(place), choice_(seed) {}

  std::vector<Line> program() {
    const int kind = choice_.below(4);  // MOVE, MOVEL, both, and arcs, too
    const bool far = choice_.percent(75);
    const std::string zone =
        choice_.of<std::string>({"", " ZONE 1mm", " ZONE 3mm", " ZONE 5mm", " ZONE 15mm"});
    const std::string pace = choice_.of<std::string>({"", "", " AT 400mm/s", " AT 100mm/s"});
    here_ = anywhere();
    std::vector<Line> lines = {{"MOVE " + tuple(here_, true), ""}};
    for (int left = choice_.between(3, 8); left > 0; --left) {
      const std::array<int, 3> to = far ? anywhere() : near_by();
      const bool line = kind == 1 || (kind > 1 && choice_.percent(50));
      if (kind == 3 && choice_.percent(30)) {
        lines.push_back({arc(to) + pace, zone});
      } else {
        const bool turns = choice_.percent(40);
        lines.push_back({(line ? "MOVEL " : "MOVE ") + tuple(to, turns) + pace, zone});
      }
      here_ = to;
    }
    return lines;
  }

 private:
  std::array<int, 3> anywhere() {
    std::array<int, 3> place{};
    for (std::size_t i = 0; i < 3; ++i) place[i] = choice_.between(place_.least[i], place_.most[i]);
    return place;
  }
  std::array<int, 3> near_by() {
    std::array<int, 3> place = here_;
    for (std::size_t i = 0; i < 3; ++i)
      place[i] = std::clamp(place[i] + choice_.between(-12, 12), place_.least[i], place_.most[i]);
    return place;
  }
  std::string tuple(const std::array<int, 3>& place, bool turns) {
    std::string text = "(";
    for (const int number : place) text += (text.size() > 1 ? ", " : "") + std::to_string(number);
    if (turns) {
      for (const int angle : {180, 0, place_.turn})
        text += ", " + std::to_string(angle + choice_.between(-15, 15));
    }
    return text + ")";
  }
  std::string arc(const std::array<int, 3>& to) {
    std::array<int, 3> via{};
    for (std::size_t i = 0; i < 3; ++i) via[i] = (here_[i] + to[i]) / 2 + choice_.between(-20, 20);
    return "MOVEC VIA " + tuple(via, false) + " TO " + tuple(to, false);
  }

  const Place& place_;
  Choice choice_;
  std::array<int, 3> here_{};
};

std::string text_of(const std::vector<Line>& lines, bool stops) {
  std::string text = "LAW LOOKAHEAD\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool exact = stops || i == 0 || i + 1 == lines.size();
    text += lines[i].motion + (exact ? " FINE" : lines[i].zone) + "\n";
  }
  return text;
}

/// s; none where the program is refused.
std::optional<double> time_of(const std::string& rob, const std::string& robot,
                              const std::string& text) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "program.rob") << text;
  const ProcessResult run =
      run_process({rob, "check", scratch.file("program.rob"), "--robot", robot, "--json"});
  if (run.exit_code != 0) return std::nullopt;
  const auto report = nlohmann::json::parse(run.out);
  if (report.at("status") != "done") return std::nullopt;
  return report.at("planned_s").get<double>();
}

struct Tally {
  std::uint64_t judged = 0, slower = 0, refused = 0;
  double sum = 0, worst = 0;

  bool right() const {
    constexpr double kLeastJudged = 0.6;  // [choice] of all: arcs that leave the reach are refused
    const double all = static_cast<double>(judged + refused);
    return slower == 0 && static_cast<double>(judged) >= kLeastJudged * all;
  }
};

void judge(const std::string& rob, const std::string& robot, std::uint64_t number,
           const std::vector<Line>& lines, Tally& tally) {
  const auto corners = time_of(rob, robot, text_of(lines, false));
  const auto stops = time_of(rob, robot, text_of(lines, true));
  if (!corners || !stops) {
    ++tally.refused;
    return;
  }
  ++tally.judged;
  const double share = *corners / *stops;
  tally.sum += share;
  tally.worst = std::max(tally.worst, share);
  if (share <= kMost) return;
  ++tally.slower;
  std::printf("program %" PRIu64 " on %s: %.3f s with corners, %.3f s with stops\n", number,
              robot.c_str(), *corners, *stops);
}

/// Along a wall and up it. The corner once slowed all of both lines: 5.30 s, and 1.40 s with a
/// stop.
constexpr double kTwoLines = 1.40;
std::vector<Line> two_lines() {
  return {{"MOVE (350, -150, 250, 180, 0, 180)", ""},
          {"MOVEL (350, 150, 250)", ""},
          {"MOVEL (350, 150, 400)", ""}};
}

int judge_all(const std::string& rob, const Place& place, std::uint64_t count, std::uint64_t seed) {
  Tally tally;
  if (std::string(place.robot) == "irb120") {
    judge(rob, place.robot, 0, two_lines(), tally);
    const auto time = time_of(rob, place.robot, text_of(two_lines(), false));
    if (!time || *time > kTwoLines) ++tally.slower;
  }
  for (std::uint64_t number = seed; number < seed + count; ++number)
    judge(rob, place.robot, number, Writer(place, number).program(), tally);
  std::printf("%" PRIu64 " programs on %s judged, %" PRIu64 " slower, %" PRIu64
              " refused; with corners %.3f of the time with stops, %.3f at most\n",
              tally.judged, place.robot, tally.slower, tally.refused,
              tally.sum / static_cast<double>(std::max<std::uint64_t>(tally.judged, 1)),
              tally.worst);
  return tally.right() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 2 || arguments.size() > 4) {
    std::fprintf(stderr, "usage: times_judge ROB ROBOT [N [SEED]] | --show SEED\n");
    return kUsage;
  }
  try {
    const auto* const place = std::ranges::find(kPlaces, arguments[1], &Place::robot);
    if (place == std::end(kPlaces)) throw std::runtime_error("no place to work is known of it");
    const std::uint64_t seed = arguments.size() > 3 ? std::stoull(arguments[3]) : 1;
    if (arguments.size() > 2 && arguments[2] == "--show") {
      std::printf("%s", text_of(Writer(*place, seed).program(), false).c_str());
      return 0;
    }
    const std::uint64_t count = arguments.size() > 2 ? std::stoull(arguments[2]) : 10;
    return judge_all(arguments[0], *place, count, seed);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

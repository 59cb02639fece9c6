#include "tests/support/random_program.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "tests/support/gantry.h"
#include "tests/support/random_text.h"

namespace rob::test {

namespace {

constexpr std::size_t kAxes = 3;
constexpr std::array<const char*, kAxes> kNames = {"x", "y", "theta"};
/// The gantry's limits in tenths of a millimetre or of a degree.
constexpr std::array<int, kAxes> kLeast = {0, 0, -1800};
constexpr std::array<int, kAxes> kGreatest = {4000, 3000, 1800};

/// One written component: start + slope·i, i being the variable of the loop around it.
struct Component {
  std::string text;
  double start = 0;
  double slope = 0;
};

/// AT, OVER, ZONE and FINE as they stand behind a target, and what they mean.
struct Clauses {
  std::string text;
  double over = 0;                      ///< s
  double share = 1;                     ///< of all maxima
  std::optional<double> tool_speed;     ///< mm/s
  std::optional<double> angular_speed;  ///< deg/s
  PaulZone zone{};
};

struct WrittenMove {
  int line = 0;
  std::array<std::optional<Component>, kAxes> components;
  Clauses clauses;
};

/// The values that a loop's variable takes.
struct Loop {
  int from = 0;
  int to = 0;
  int step = 1;
};

/// Writes a program statement by statement and keeps the model of what it does. It can be copied,
/// so that a statement can be tried and dropped.
class ProgramWriter {
 public:
  explicit ProgramWriter(std::uint64_t seed) : choice_(seed) {}

  Choice& choice() { return choice_; }
  bool doubtful() const { return doubtful_; }

  void statement();
  void end();
  RandomProgram take() { return std::move(program_); }

 private:
  int write(const std::string& line);
  std::string word(std::string keyword);

  void move();
  void repeated_move();
  void stop(int line) { program_.steps.push_back({.line = line, .stop = true, .target = {}}); }
  void print();
  void loop();

  Component constant_component(std::size_t axis);
  Component loop_component(std::size_t axis, const Loop& loop);
  std::string target_text(const std::array<std::optional<Component>, kAxes>& components);
  WrittenMove written_move(const Loop* loop);
  Clauses clauses();
  void zone(Clauses& made);
  WrittenQuantity speed();
  void carry_out(const WrittenMove& move, int i);

  Choice choice_;
  RandomProgram program_;
  int lines_ = 0;
  std::string indent_;
  std::array<double, kAxes> last_{};  ///< what was commanded last, mm and deg
  std::array<std::string, kAxes> last_text_;
  bool doubtful_ = false;
};

int ProgramWriter::write(const std::string& line) {
  program_.text += indent_ + line;
  if (choice_.percent(10)) program_.text += "  // " + std::to_string(choice_.below(1000));
  program_.text += "\n";
  return ++lines_;
}

/// Keywords and names are read in either case.
std::string ProgramWriter::word(std::string keyword) {
  if (choice_.percent(10)) {
    for (char& c : keyword) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return keyword;
}

Component ProgramWriter::constant_component(std::size_t axis) {
  const auto place = [&] {
    const int here = static_cast<int>(std::lround(last_[axis] * 10));
    const int kind = choice_.below(10);
    if (kind == 0) return kLeast[axis];
    if (kind == 1) return kGreatest[axis];
    if (kind <= 4) return here + choice_.between(-100, 100);  // a short move
    return choice_.between(kLeast[axis], kGreatest[axis]);
  };
  const int tenths = std::clamp(place(), kLeast[axis], kGreatest[axis]);
  const auto written = [&](int value) {
    return axis < 2 ? written_length(choice_, value) : written_angle(choice_, value);
  };
  // Rounding of a sum may pass a limit by one bit, so limits are written plainly.
  const bool inside = tenths > kLeast[axis] + 10 && tenths < kGreatest[axis] - 10;
  if (inside && choice_.percent(15)) {
    const std::string unit = choice_.percent(50) ? "" : axis < 2 ? "mm" : "deg";
    const int part = choice_.between(1, 10);
    return {decimal(tenths - part, 1) + unit + " + " + decimal(part, 1) + unit, tenths / 10.0};
  }
  if (inside && choice_.percent(10)) {
    const WrittenQuantity half = written(tenths);
    return {"2 * " + half.text + " / 2", half.value};
  }
  const WrittenQuantity plain = written(tenths);
  return {plain.text, plain.value};
}

/// start + slope·i, within the limits for every value of i.
Component ProgramWriter::loop_component(std::size_t axis, const Loop& loop) {
  const int most = std::max(loop.from, loop.to);
  const int room = kGreatest[axis] / 10;
  const int slope = choice_.between(1, room / (2 * most));
  const int start = choice_.between(0, room / 2 - 1);
  const std::string unit = choice_.percent(50) ? "" : axis < 2 ? "mm" : "deg";
  const std::string factor = std::to_string(slope) + unit;
  const std::string product = choice_.percent(50) ? "i * " + factor : factor + " * i";
  return {std::to_string(start) + unit + " + " + product, static_cast<double>(start),
          static_cast<double>(slope)};
}

std::string ProgramWriter::target_text(
    const std::array<std::optional<Component>, kAxes>& components) {
  std::string text;
  const auto separate = [&](const char* separator) { text += text.empty() ? "" : separator; };
  if (choice_.percent(40)) {  // named, in any order
    const int first = choice_.below(3);
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>((first + 2 * k) % 3);
      if (!components[axis]) continue;
      separate(", ");
      text += word(kNames[axis]) + ": " + components[axis]->text;
    }
    return "(" + text + ")";
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (axis > 0) text += ",";
    text += components[axis] ? (axis > 0 ? " " : "") + components[axis]->text : " ";
  }
  return "(" + text + ")";
}

WrittenQuantity ProgramWriter::speed() {
  static const std::vector<WrittenQuantity> speeds = {
      {"5mm/s", 5}, {"12.5mm/s", 12.5}, {"1cm/s", 10}, {"0.018m/s", 18}, {"600mm/min", 10}};
  return choice_.of(speeds);
}

Clauses ProgramWriter::clauses() {
  static const std::vector<WrittenQuantity> turning = {
      {"5deg/s", 5}, {"15deg/s", 15}, {"2rpm", 12}, {"1.5rev/min", 9}};
  Clauses made;
  const int pace = choice_.below(100);
  if (pace < 12) {
    const int percent = choice_.between(10, 100);
    made.share = percent / 100.0;
    made.text = " " + word("AT") + " " + std::to_string(percent) + "%";
  } else if (pace < 24) {
    const WrittenQuantity chosen = speed();
    made.tool_speed = chosen.value;
    made.text = " " + word("AT") + " " + chosen.text;
  } else if (pace < 32) {
    const WrittenQuantity& chosen = choice_.of(turning);
    made.angular_speed = chosen.value;
    made.text = " " + word("AT") + " " + chosen.text;
  }
  if (choice_.percent(20)) {
    const WrittenQuantity over = written_time(choice_, choice_.between(6, 90));
    made.over = over.value;
    const std::string clause = " " + word("OVER") + " " + over.text;
    made.text = choice_.percent(50) ? made.text + clause : clause + made.text;
  }
  if (choice_.percent(30)) zone(made);
  return made;
}

/// Zones that the gantry's axes can take: t_acc from 0.4 s on, which a miss of 4.5 mm leaves at
/// any speed.
void ProgramWriter::zone(Clauses& made) {
  static const std::vector<WrittenQuantity> times = {{"0.4s", 0.4}, {"500ms", 0.5}, {"2s", 2}};
  const std::string word_of_zone = " " + word("ZONE") + " ";
  const int kind = choice_.below(10);
  if (kind < 3) {
    const WrittenQuantity& time = choice_.of(times);
    made.zone = {PaulZone::Kind::Time, time.value};
    made.text += word_of_zone + time.text;
  } else if (kind < 5) {
    const int percent = choice_.between(30, 150);
    made.zone = {PaulZone::Kind::Share, percent / 100.0};
    made.text += word_of_zone + std::to_string(percent) + "%";
  } else if (kind < 8) {
    const WrittenQuantity length = written_length(choice_, choice_.between(45, 200));
    made.zone = {PaulZone::Kind::Length, length.value};
    // A bare number has a unit in a target alone.
    const bool bare = length.text.find('m') == std::string::npos;
    made.text += word_of_zone + length.text + (bare ? "mm" : "");
  } else {
    made.zone = {PaulZone::Kind::Fine, 0};
    made.text += " " + word("FINE");
  }
}

WrittenMove ProgramWriter::written_move(const Loop* loop) {
  WrittenMove made;
  const auto always = static_cast<std::size_t>(choice_.below(kAxes));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (axis != always && choice_.percent(35)) continue;
    const bool follows = loop != nullptr && (axis == always || choice_.percent(40));
    made.components[axis] = follows ? loop_component(axis, *loop) : constant_component(axis);
  }
  made.clauses = clauses();
  const std::string target = target_text(made.components);
  made.line = write(word("MOVE") + target + made.clauses.text);
  return made;
}

/// What the model makes of a MOVE: every left-out component keeps what was commanded last, and AT
/// bounds the time from below (S1: T_user).
void ProgramWriter::carry_out(const WrittenMove& move, int i) {
  PaulStep step{.line = move.line,
                .stop = false,
                .target = AxisValues(last_.begin(), last_.end()),
                .t_user = move.clauses.over,
                .zone = move.clauses.zone};
  bool same = true;
  bool same_text = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!move.components[axis]) continue;
    const Component& component = *move.components[axis];
    step.target[axis] = component.start + component.slope * i;
    std::string text = component.text;
    if (component.slope != 0) text += " with i = " + std::to_string(i);
    same_text = same_text && text == last_text_[axis];
    last_text_[axis] = text;
    same = same && std::abs(step.target[axis] - last_[axis]) < 1e-6;
  }
  // 4cm and 40 may differ in their last bit, which decides whether such a MOVE has a length.
  doubtful_ = doubtful_ || (same && !same_text);
  const double distance =
      tool_distance(step.target, AxisValues(last_.begin(), last_.end()), gantry_robot().tool_axes);
  const auto at_least = [&](double time) { step.t_user = std::max(step.t_user, time); };
  if (move.clauses.tool_speed) at_least(distance / *move.clauses.tool_speed);
  if (move.clauses.angular_speed) {
    at_least(std::abs(step.target[2] - last_[2]) / *move.clauses.angular_speed);
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    at_least(std::abs(step.target[axis] - last_[axis]) /
             (gantry_robot().v_max[axis] * move.clauses.share));
  }
  std::copy(step.target.begin(), step.target.end(), last_.begin());
  program_.steps.push_back(std::move(step));
}

void ProgramWriter::move() { carry_out(written_move(nullptr), 0); }

/// The same statement twice: the target is reached exactly.
void ProgramWriter::repeated_move() {
  WrittenMove twice = written_move(nullptr);
  carry_out(twice, 0);
  const std::size_t end = program_.text.size() - 1;
  const std::size_t begin = program_.text.rfind('\n', end - 1) + 1;
  std::string same = program_.text.substr(begin, end - begin);
  same.erase(std::min(same.size(), same.find("  //")));
  twice.line = write(same);
  carry_out(twice, 0);
}

void ProgramWriter::print() {
  const std::string number = std::to_string(choice_.below(100));
  write(word("PRINT") + " \"at \", " + number);
  program_.output.push_back("at " + number);
}

void ProgramWriter::loop() {
  static const std::vector<Loop> loops = {{1, 3, 1}, {0, 3, 1}, {1, 5, 2}, {3, 1, -1}, {2, 2, 1}};
  const Loop chosen = choice_.of(loops);
  const std::string step = chosen.step == 1 ? "" : " STEP " + std::to_string(chosen.step);
  write(word("FOR") + " i = " + std::to_string(chosen.from) + " TO " + std::to_string(chosen.to) +
        step + " DO");
  indent_ = choice_.percent(80) ? "  " : "\t";
  std::vector<WrittenMove> moves;
  for (int k = choice_.between(1, 3); k > 0; --k) moves.push_back(written_move(&chosen));
  const int stop_line = choice_.percent(20) ? write(word("STOP")) : 0;
  const bool prints = choice_.percent(30);
  if (prints) write("PRINT \"turn \", i");
  indent_.clear();
  write(word("ENDFOR"));
  for (int i = chosen.from; chosen.step > 0 ? i <= chosen.to : i >= chosen.to; i += chosen.step) {
    for (const WrittenMove& move : moves) carry_out(move, i);
    if (stop_line > 0) stop(stop_line);
    if (prints) program_.output.push_back("turn " + std::to_string(i));
  }
}

void ProgramWriter::statement() {
  if (choice_.percent(5)) write("");
  const int kind = choice_.below(100);
  if (kind < 68) return move();
  if (kind < 76) return repeated_move();
  if (kind < 86) return stop(write(word("STOP")));
  if (kind < 94) return loop();
  print();
}

void ProgramWriter::end() { stop(write(word("END"))); }

}  // namespace

RandomProgram random_gantry_program(std::uint64_t seed) {
  ProgramWriter writer(seed);
  for (int statements = writer.choice().between(1, 10); statements > 0;) {
    ProgramWriter tried = writer;
    tried.statement();
    if (tried.doubtful()) {
      writer.choice().below(2);  // draw differently the next time
      continue;
    }
    writer = std::move(tried);
    --statements;
  }
  writer.end();
  return writer.take();
}

}  // namespace rob::test

#include "runtime/prompt/pendant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/plan/capability.h"
#include "motion/space/cycle_instant.h"
#include "runtime/prompt/commands.h"
#include "runtime/words/signature.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using lang::JogFrame;

namespace {

/// Shares of full speed, and steps in mm or deg. [choice]
constexpr std::array kShares = {0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1.0};
constexpr std::array kSteps = {0.1, 1.0, 10.0, 50.0};

/// m/s of the tool at full speed: what ISO 10218-1 permits while a person is near; and rad/s.
constexpr double kToolSpeed = 0.25;
constexpr double kTurningSpeed = 0.5236;  // 30 deg/s [choice]

/// s that a press moves for, and that a repeat adds: issue and docs/prompt.md. A key that is held
/// repeats after half a second at most. [choice]
constexpr double kPulse = 0.3;
constexpr double kFirstHold = 0.75;

/// s that a step takes at least: longer than any robot's axes need to come to speed. [choice]
constexpr double kShortestStep = 0.5;

}  // namespace

Pendant::Pendant(Session& session, DeadMan& dead_man, bool releases)
    : session_(session),
      dead_man_(dead_man),
      releases_(releases),
      style_(releases ? Style::Hold : Style::Step) {}

bool Pendant::fastest() const { return speed_ + 1 == kShares.size(); }
bool Pendant::largest_step() const { return step_ + 1 == kSteps.size(); }

bool Pendant::can_move() const {
  const LiveRobot& robot = session_.robot();
  return !robot.over() && !robot.guided() && (moving() || robot.idle());
}

bool Pendant::has(JogFrame frame) const {
  const motion::RobotModel& robot = session_.robot().robot();
  return frame == JogFrame::Joint ||
         (robot.tool_coordinates && motion::can(robot, motion::Capability::Lead));
}

bool Pendant::can_set(std::string_view output) const {
  const auto& signals = session_.robot().robot().signals;
  return can_move() && std::ranges::any_of(signals, [&](const motion::RobotSignal& signal) {
           return signal.output && signal.name == output;
         });
}

int Pendant::outputs() const {
  return can_move() ? std::min(session_.robot().robot().outputs, 9) : 0;
}

double Pendant::share() const { return kShares[speed_]; }
double Pendant::step() const { return kSteps[step_]; }

std::vector<std::string> Pendant::coordinates() const {
  const motion::RobotModel& robot = session_.robot().robot();
  const lang::RobotSignature signature = signature_of(robot);
  std::vector<std::string> names;
  const bool axes = frame_ == JogFrame::Joint;
  for (const auto& one : axes ? signature.axes : signature.coordinates) names.push_back(one.name);
  return names;
}

bool Pendant::linear(std::size_t coordinate) const {
  const lang::RobotSignature signature = signature_of(session_.robot().robot());
  const auto& all = frame_ == JogFrame::Joint ? signature.axes : signature.coordinates;
  return all[coordinate].dimension == lang::kLength;
}

void Pendant::press(const Key& key) {
  if (naming_) {
    if (key.event != Key::Event::Release) name(key);
    return;
  }
  if (const auto way = way_of(key)) return move(*way, key.event);
  if (key.event == Key::Event::Release) return;
  const bool moved = active_.has_value();
  stop();
  // Any other key ends a motion, and a pulse does nothing else.
  if (moved && style_ == Style::Pulse) return;
  command(key);
}

/// Arrows and page keys move the first three coordinates, + and − the chosen one.
std::optional<Pendant::Way> Pendant::way_of(const Key& key) const {
  switch (key.kind) {
    case Key::Kind::Right:
      return Way{0, 1};
    case Key::Kind::Left:
      return Way{0, -1};
    case Key::Kind::Up:
      return Way{1, 1};
    case Key::Kind::Down:
      return Way{1, -1};
    case Key::Kind::PageUp:
      return Way{2, 1};
    case Key::Kind::PageDown:
      return Way{2, -1};
    default:
      break;
  }
  if (key.is('+') || key.is('=')) return Way{chosen_, 1};
  if (key.is('-')) return Way{chosen_, -1};
  return std::nullopt;
}

void Pendant::move(const Way& way, Key::Event event) {
  if (way.coordinate >= coordinates().size()) return;
  if (event == Key::Event::Release) {
    if (style_ == Style::Hold && active_ == way) stop();
    if (pending_ == way) pending_.reset();
    return;
  }
  if (style_ == Style::Step) {
    if (active_ && event == Key::Event::Repeat) return;
    if (active_) {
      pending_ = way;
    } else {
      begin(way);
    }
    return;
  }
  // A held key that has come to an end of the way is pressed anew, or another one is.
  if (!active_) return style_ == Style::Hold && event == Key::Event::Repeat ? void() : begin(way);
  const double now = session_.robot().reports().time();
  if (active_ == way) return dead_man_.hold_until(now + kPulse);
  stop();
  if (style_ == Style::Hold) pending_ = way;
}

void Pendant::begin(const Way& way) {
  if (!can_move() || !session_.robot().idle()) return;  // a program runs, or it brakes
  active_ = way;
  const double rate = full_rate(way.coordinate) * share();
  if (style_ != Style::Step) {
    dead_man_.hold_until(session_.robot().reports().time() +
                         (style_ == Style::Hold ? kFirstHold : kPulse));
    return session_.jog(jog(way, rate, 0), dead_man_.watch());
  }
  // In whole periods, so that it is as long as it says.
  const double way_length =
      step() / (linear(way.coordinate) ? kMillimetresPerMetre : kDegreesPerRadian);
  const double period = session_.robot().robot().reference_period;
  const double lasts = std::ceil(std::max(way_length / rate, kShortestStep) / period) * period;
  dead_man_.hold();
  session_.jog(jog(way, way_length / lasts, lasts), dead_man_.watch());
}

lang::MoveCommand Pendant::jog(const Way& way, double rate, double lasts) const {
  lang::MoveCommand command;
  command.kind = lang::MotionKind::Jog;
  command.jog = frame_;
  command.count = static_cast<int>(coordinates().size());
  command.given = lang::given_all(command.count);
  command.target[way.coordinate] = way.sign * rate;
  command.lasts = lasts;
  return command;
}

/// m/s or rad/s: of an axis its own, of the tool what is safe beside a person and an axis can make.
double Pendant::full_rate(std::size_t coordinate) const {
  const motion::RobotModel& robot = session_.robot().robot();
  if (frame_ == JogFrame::Joint) return robot.axes[coordinate].v_max;
  double fastest = linear(coordinate) ? kToolSpeed : kTurningSpeed;
  if (robot.tool_coordinates) return fastest;
  return std::min(fastest, robot.axes[coordinate].v_max);
}

void Pendant::go_on() {
  if (!session_.robot().idle()) return;
  active_.reset();
  if (!pending_) return;
  const Way way = *pending_;
  pending_.reset();
  begin(way);
}

void Pendant::stop() {
  dead_man_.release();
  pending_.reset();
}

void Pendant::give_up() {
  stop();
  naming_.reset();
}

void Pendant::choose_frame(JogFrame frame) {
  if (!has(frame)) return;
  frame_ = frame;
  chosen_ = std::min(chosen_, coordinates().size() - 1);
}

/// The number of an output; any other key chooses none.
void Pendant::choose_output(const Key& key) {
  choosing_output_ = false;
  if (key.kind == Key::Kind::Character && key.character >= '1' &&
      key.character < static_cast<char32_t>('1' + outputs()))
    toggle(fmt::format("DOUT[{}]", static_cast<char>(key.character)));
}

void Pendant::command(const Key& key) {
  if (choosing_output_) return choose_output(key);
  if (key.kind == Key::Kind::Escape || key.is('q')) {
    over_ = true;
  } else if (key.kind != Key::Kind::Character) {
    return;
  } else if (key.character >= '1' && key.character - '1' < coordinates().size()) {
    chosen_ = key.character - '1';
  } else {
    switch (key.character) {
      case 'j':
        return choose_frame(JogFrame::Joint);
      case 'w':
        return choose_frame(JogFrame::World);
      case 't':
        return choose_frame(JogFrame::Tool);
      case ']':
        speed_ = std::min(speed_ + 1, kShares.size() - 1);
        return;
      case '[':
        speed_ -= speed_ > 0 ? 1 : 0;
        return;
      case '.':
        step_ = std::min(step_ + 1, kSteps.size() - 1);
        return;
      case ',':
        step_ -= step_ > 0 ? 1 : 0;
        return;
      case 'm':
        if (style_ == Style::Step) {
          style_ = releases_ ? Style::Hold : Style::Pulse;
        } else {
          style_ = Style::Step;
        }
        return;
      case 'l':
        if (can_set("lift")) toggle("lift");
        return;
      case 'g':
        if (can_set("gripper")) toggle("gripper");
        return;
      case 'o':
        choosing_output_ = outputs() > 0;
        return;
      case 'p':
        if (can_teach()) naming_.emplace();
        return;
      default:
        return;
    }
  }
}

void Pendant::toggle(const std::string& output) {
  if (!session_.robot().idle()) return;
  enter(session_, fmt::format("{0} = NOT {0}", output));
}

/// The name of a point to be taught here: Enter takes it, Esc leaves it.
void Pendant::name(const Key& key) {
  if (key.kind == Key::Kind::Escape) {
    naming_.reset();
  } else if (key.kind == Key::Kind::Enter) {
    if (!naming_->empty()) {
      session_.screen().message(fmt::format("{} is here from now on\n", *naming_));
      enter(session_, ":teach " + *naming_);
    }
    naming_.reset();
  } else if (key.kind == Key::Kind::Backspace) {
    if (!naming_->empty()) naming_->pop_back();
  } else if (key.kind == Key::Kind::Character && key.character < 128 && key.character > ' ') {
    naming_->push_back(static_cast<char>(key.character));
  }
}

}  // namespace rob::runtime

#include "tests/bench/cell_runs.h"

#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "runtime/run/load.h"
#include "runtime/run/run.h"
#include "runtime/run/simulation.h"

namespace rob::bench {

namespace {

/// s of the cell after which a program that has not ended will not. [choice] ten times the longest
constexpr double kLongest = 1500;

/// A cell whose every reading is written down.
class WatchedCell final : public motion::ServoBackend {
 public:
  WatchedCell(std::unique_ptr<motion::ServoBackend> cell, const motion::RobotModel& robot,
              CellRun& run)
      : owned_(std::move(cell)),
        cell_(dynamic_cast<drivers::SimCell&>(*owned_)),
        robot_(robot),
        run_(run) {}

  int axes() const noexcept override { return cell_.axes(); }
  void open() override { cell_.open(); }
  void close() noexcept override { cell_.close(); }
  motion::DriverStatus enable(double now) noexcept override { return cell_.enable(now); }
  void disable(double now) noexcept override { cell_.disable(now); }
  motion::DriverStatus read(double now, motion::ServoState& state) noexcept override {
    const motion::DriverStatus status = cell_.read(now, state);
    run_.instants.push_back(instant(now));
    leave();
    return now > kLongest ? motion::DriverStatus::Lost : status;
  }
  motion::DriverStatus write(double now, const motion::ServoCommand& command) noexcept override {
    return cell_.write(now, command);
  }

 private:
  Instant instant(double now) const {
    const drivers::CellScene& scene = cell_.scene();
    motion::JointVector q(cell_.axes());
    for (int i = 0; i < cell_.axes(); ++i) q[i] = cell_.machine().true_position(i);
    const Eigen::Vector3d tip(0, 0, robot_.cell->gripper.tip);
    Instant made;
    made.time = now;
    made.tip = motion::place_of(tip, robot_.kinematics->forward(q));
    made.foot = scene.foot();
    made.force = scene.reaction().force;
    made.torque = scene.reaction().torque;
    made.turned = q[cell_.axes() - 1];
    made.held = scene.holds_something();
    return made;
  }

  void leave() {
    const drivers::CellScene& scene = cell_.scene();
    const auto holes = static_cast<std::size_t>(scene.racks().holes());
    run_.end.dropped = scene.dropped();
    run_.end.occupied.resize(holes);
    run_.end.turned.resize(holes);
    for (std::size_t i = 0; i < holes; ++i) {
      run_.end.occupied[i] = scene.occupied(static_cast<int>(i));
      run_.end.turned[i] = scene.cap_turned(static_cast<int>(i));
    }
  }

  std::unique_ptr<motion::ServoBackend> owned_;
  drivers::SimCell& cell_;
  const motion::RobotModel& robot_;
  CellRun& run_;
};

}  // namespace

CellRun run_in_cell(const std::string& file, const std::string& source,
                    const motion::RobotModel& robot) {
  const runtime::LoadedProgram program = runtime::compile_program(file, source, robot);
  if (!program.runnable()) throw std::runtime_error(file + " does not compile");
  CellRun made;
  runtime::OpenMachine machine{
      std::make_unique<WatchedCell>(runtime::simulation_of(robot), robot, made),
      robot.servo_period,
      {}};
  runtime::Foretold not_foretold;
  runtime::RunOptions options;
  options.fast = true;
  options.foretold = &not_foretold;
  runtime::ProgramStores stores(program, options.data, false);
  made.result = runtime::run(program, std::move(machine), stores, options, {});
  return made;
}

void CellBench::add_to(BenchOptions& line) {
  line.add("--program", program);
  line.add("--first", first, "seed");
  line.add("--cells", cells, "how many");
  line.add_flag("--by-hand", by_hand, "the skill as it is spelt out in velocity mode");
  line.add_flag("--every", every, "a line for each, not only for those that fail");
}

std::string CellBench::source() const {
  std::string text = text_of(program);
  if (by_hand) text = edited(text, "CONST by_hand = FALSE", "CONST by_hand = TRUE");
  return text;
}

motion::RobotModel CellBench::robot(int i) const {
  motion::RobotModel robot = runtime::load_robot("lwa4p");
  runtime::change_cell(robot, seed(i));
  return robot;
}

std::string said_by(const CellRun& run) {
  std::string said;
  for (const std::string& line : run.result.output) said += line;
  if (run.result.error) said += run.result.error->message;
  return said;
}

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  if (!in || text.str().empty()) throw std::runtime_error("cannot read " + file);
  return text.str();
}

std::string edited(std::string text, const std::string& was, const std::string& is) {
  const std::size_t at = text.find(was);
  if (at == std::string::npos || text.find(was, at + 1) != std::string::npos)
    throw std::runtime_error("not there once: " + was);
  return text.replace(at, was.size(), is);
}

}  // namespace rob::bench

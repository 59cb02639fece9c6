// A small interpreter host: it compiles a program of Rob's language and runs it. Its machine is a
// table with two axes, which prints each target.
#include <rob/lang.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace lang = rob::lang;

namespace {

/// A table with two axes. It overrides what it has; the rest is refused by name.
class Table final : public lang::Machine {
 public:
  lang::Reply move(int line, const lang::MoveCommand& command) override {
    for (int axis = 0; axis < command.count; ++axis) {
      if (!command.has(axis)) continue;
      const double to = command.target[static_cast<std::size_t>(axis)];
      if (to < 0 || to > kLongest)
        return refuse({"TABLE", "the table is 0.5 m long", "keep x and y between 0 and 500 mm"});
      place_[axis] = to;
    }
    std::printf("line %d: x = %.1f mm, y = %.1f mm\n", line, place_[0] * 1000, place_[1] * 1000);
    return lang::Reply::Done;
  }

  lang::Reply print(int /*line*/, std::string_view text) override {
    std::printf("%.*s\n", static_cast<int>(text.size()), text.data());
    return lang::Reply::Done;
  }

 private:
  static constexpr double kLongest = 0.5;  // m
  double place_[2] = {0, 0};               // m
};

/// 0 if the program ran to its end.
int run(const lang::Chunk& program) {
  Table table;
  lang::Vm vm(program, table);
  // Each call executes at most 1000 instructions, so a host can do other things in between.
  lang::Vm::State state = vm.run(1000);
  while (state == lang::Vm::State::Running || state == lang::Vm::State::Waiting ||
         state == lang::Vm::State::NextCycle) {
    state = vm.run(1000);
  }
  if (state == lang::Vm::State::Done) return 0;
  const lang::RuntimeError& error = vm.error();
  std::printf("line %u: %s\nhelp: %s\n", error.place.line, error.message.c_str(),
              error.help.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: interpreter FILE.rob\n";
    return 2;
  }
  std::ifstream file(argv[1]);
  if (!file) {
    std::cerr << argv[1] << ": cannot be read\n";
    return 2;
  }
  std::stringstream source;
  source << file.rdbuf();

  lang::RobotSignature robot;
  robot.name = "table";
  robot.coordinates = {{"x", lang::kLength}, {"y", lang::kLength}};
  robot.axes = robot.coordinates;
  const lang::Compilation compiled = lang::compile(source.str(), robot);
  std::cerr << lang::diagnose(compiled.diagnostics, argv[1], source.str());
  return compiled.chunk ? run(*compiled.chunk) : 1;
}

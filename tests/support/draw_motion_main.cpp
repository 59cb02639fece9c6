/// draw_motion FOLDER [ROB EXAMPLES]: the drawings of docs/motion.md, as FOLDER/motion_*.svg; with
/// the program `rob` and the folder of its examples also those of its traces.

#include <exception>
#include <stdexcept>
#include <string>

#include "tests/support/motion_drawing.h"
#include "tests/support/svg.h"

int main(int argc, char** argv) {
  using namespace rob::test;
  if (argc != 2 && argc != 4) {
    fmt::print(stderr, "usage: draw_motion FOLDER [ROB EXAMPLES]\n");
    return 64;
  }
  try {
    const auto save = [&](const char* name, const Drawing& drawing) {
      const std::string file = fmt::format("{}/motion_{}.svg", argv[1], name);
      if (!save_svg(file, drawing.width, drawing.height, drawing.content))
        throw std::runtime_error("cannot write " + file);
    };
    save("corner", corner_drawing());
    save("speed", speed_drawing());
    save("mean", mean_drawing());
    if (argc == 2) return 0;
    save("triangle", triangle_drawing(argv[2]));
    save("capping", capping_drawing(argv[2], argv[3]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "draw_motion: {}\n", error.what());
    return 70;
  }
}

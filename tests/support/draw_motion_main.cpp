/// draw_motion FOLDER ROB: the drawings of docs/motion.md, as FOLDER/motion_*.svg; ROB is the
/// program whose traces they show.

#include <exception>

#include "tests/support/motion_drawing.h"
#include "tests/support/svg.h"

int main(int argc, char** argv) {
  using namespace rob::test;
  if (argc != 3) {
    fmt::print(stderr, "usage: draw_motion FOLDER ROB\n");
    return 64;
  }
  try {
    const std::pair<const char*, Drawing> drawings[] = {{"corner", corner_drawing()},
                                                        {"speed", speed_drawing()},
                                                        {"mean", mean_drawing()},
                                                        {"triangle", triangle_drawing(argv[2])}};
    for (const auto& [name, drawing] : drawings) {
      const std::string file = fmt::format("{}/motion_{}.svg", argv[1], name);
      if (save_svg(file, drawing.width, drawing.height, drawing.content)) continue;
      fmt::print(stderr, "draw_motion: cannot write {}\n", file);
      return 74;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "draw_motion: {}\n", error.what());
    return 70;
  }
}

// Two motions of the gantry, one reference for its axes a period. A program for a machine would
// wait for the next period before each update(), and give reference.q to the drives.

#include <rob/motion.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

namespace motion = rob::motion;

// Whoever takes memory is counted, so that this program can prove that update() takes none.
static long taken = 0;

void* operator new(std::size_t size) {
  ++taken;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++taken;
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* const memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

/// Axes 0 and 1, m; axis 2 stays.
static motion::MotionRequest move_to(double x, double y) {
  motion::MotionRequest request;
  request.given = 0b011;
  request.target = {x, y};
  return request;
}

static bool add(motion::Trajectory& trajectory, const motion::MotionRequest& request) {
  const auto refusal = trajectory.add(request);
  if (refusal)
    std::printf("refused: axis %d, %g is beyond %g\n", refusal->axis, refusal->value,
                refusal->limit);
  return !refusal;
}

static void show(const motion::JointReference& reference) {
  std::printf("%6.2f s   x %6.2f mm   y %6.2f mm\n", reference.time, 1000 * reference.q[0],
              1000 * reference.q[1]);
}

static int run() {
  const motion::RobotModel robot = motion::load_robot("gantry");
  motion::Trajectory trajectory(robot, motion::Law::LookAhead);
  if (!add(trajectory, move_to(0.1, 0))) return 1;
  if (!add(trajectory, move_to(0.1, 0.05))) return 1;
  add(trajectory, move_to(0.9, 0));  // out of reach: nothing is added
  trajectory.close();

  motion::JointReference reference;
  motion::Result result = motion::Result::Working;
  long taken_by_update = 0;
  for (int period = 0; result == motion::Result::Working; ++period) {
    trajectory.plan();  // here, or in another thread
    const long before = taken;
    result = trajectory.update(reference);
    taken_by_update += taken - before;
    if (period % 100 == 0) show(reference);
  }
  show(reference);
  std::printf("update() has taken memory %ld times\n", taken_by_update);
  return result == motion::Result::Finished && taken_by_update == 0 ? 0 : 1;
}

int main() {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

#include "runtime/cli/import_files.h"

#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"
#include "runtime/run/console.h"

namespace rob::runtime {

namespace {

constexpr std::size_t kMostUrdf = std::size_t{8} << 20U;  // bytes [choice] 50 × the longest

}  // namespace

ExitCode import_files(const ImportRequest& request) {
  const std::string urdf = read_file(request.urdf, kMostUrdf);
  const ImportedRobot robot = import_robot(urdf, request);
  save_file(request.robot, robot.text);
  put_result(robot.report);
  return ExitCode::Done;
}

}  // namespace rob::runtime

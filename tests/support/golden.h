#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lang/machine/point_table.h"
#include "lang/machine/robot_signature.h"

/// Golden programs: .rob files with the expectation in a comment on the line it is about.
///
///     MOVE(40,40,0)      // expect: move 40 40 0
///     MOVE(140,40        // expect error: ')' expected
///     VAR sin = 3        // expect warning: hides
///     PRINT 1 / n        // expect failure: division by zero
///     MOVE(9000,0,0)     // expect refusal: beyond
///
/// `expect:` names a call to the Machine, as PrintingMachine writes it, in full; the others a part
/// of a message. A comment that stands alone belongs to the line of code above it. Every message
/// must be expected and every expectation met. The calls of one line must come in the order of its
/// expectations, however often a loop passes the line; the final `end` need not be expected.
///
///     // given lift_up: OFF OFF ON     what reading a signal answers; the last stays
///     // given DIN[1]: ON              the same of a channel without a name
///     // given AIN[1]: 2.5V 3V         the same of an analog one
///     // given answer: 7mm             what the operator answers to the next ASK
///     // given later: 3                the first three calls are answered "later"
///     // given file tools: PROC a()    a line of tools.rob, which the program USEs; what is
///     expected
///                                      of it stands behind it on the same line
///
/// Refusals need the real planner, which is none of the language's business: they are handed on.
namespace rob::test {

struct Expectation {
  enum class Kind { Call, Error, Warning, Failure, Refusal };

  Kind kind = Kind::Call;
  int line = 0;
  std::string text;
};

/// What a golden program says about itself.
struct GoldenScript {
  std::vector<Expectation> expectations;
  lang::PointTable points;  ///< "// given point pick in pallet: 40 20 10", in mm
  std::map<std::string, std::vector<double>> signals;  ///< by name; 1 is ON, V
  std::vector<std::string> answers;                    ///< of the operator
  int later = 0;
  /// A file to USE, and for each of its lines the one of the golden program where it stands.
  struct File {
    std::string name;
    std::string text;
    std::vector<int> lines;
  };
  std::vector<File> files;
  std::vector<std::string> mistakes;  ///< comments that look like expectations and are none
};

GoldenScript read_golden(std::string_view source);

struct GoldenResult {
  std::vector<std::string> differences;  ///< empty if all is as expected
  std::vector<Expectation> refusals;     ///< still to be checked against the planner
};

/// Compiles and runs a golden program against a PrintingMachine.
GoldenResult check_golden(std::string_view source, const lang::RobotSignature& robot);

}  // namespace rob::test

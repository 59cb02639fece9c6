#include "runtime/files/kept_values.h"

#include <doctest/doctest.h>

#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "lang/values/number_text.h"
#include "lang/values/value_text.h"
#include "motion/robots/robot_library.h"
#include "runtime/files/files.h"
#include "runtime/run/foretell.h"
#include "runtime/run/load.h"
#include "runtime/run/run.h"
#include "tests/support/file_error.h"
#include "tests/support/scratch_folder.h"

namespace runtime = rob::runtime;
using rob::lang::Type;
using rob::runtime::KeptValues;
using rob::runtime::KeptVariable;
using rob::runtime::read_values;
using rob::runtime::WrittenValues;
using rob::test::message_of;
using rob::test::ScratchFolder;

namespace {

std::string content_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// "line:column code" of the first error; empty where there is none.
std::string first_error(const std::string& text, const Type& type) {
  const WrittenValues values = read_values(text, {{"x", type}});
  if (!values.diagnostics.has_errors()) return "";
  const rob::lang::Diagnostic& found = values.diagnostics.all().front();
  return std::to_string(found.place.line) + ":" + std::to_string(found.place.column);
}

/// A program that is run, and what it prints.
struct Kept {
  ScratchFolder folder;
  std::string program = folder.file("cell.rob");
  std::string values = runtime::values_file_of(program);
  rob::motion::RobotModel robot = rob::motion::embedded_robot("gantry");

  runtime::RunResult run(const std::string& text) const {
    const auto loaded = runtime::compile_program(program, text, robot, "");
    REQUIRE(loaded.runnable());
    runtime::RunOptions options;
    options.fast = true;
    return runtime::run(loaded, robot, options, {});
  }
};

}  // namespace

TEST_CASE("what is written of a value is read back to the same bits") {
  rob::lang::TypeTable types;
  const Type length = Type::real(rob::lang::kLength);
  const Type lengths = types.array(length, 3);
  const std::vector<rob::lang::Slot> numbers{{.real = 0.1 + 0.2}, {.real = -1e-9}, {.real = 7e20}};
  std::string text = "x = ";
  REQUIRE(rob::lang::append_part_text(text, lengths, numbers.data(), nullptr, 1000));
  const WrittenValues read = read_values(text + "\n", {{"x", lengths}});
  REQUIRE(read.saved.at(0));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    CHECK(read.saved[0]->numbers.at(i).real == numbers[i].real);

  const std::string hard = "a\"b\\c\n\t\x01\x7F\r // \u00e4";
  text = "x = ";
  REQUIRE(rob::lang::append_part_text(text, Type::string(), nullptr, &hard, 1000));
  CHECK(read_values(text, {{"X", Type::string()}}).saved.at(0)->texts.at(0) == hard);
}

TEST_CASE("a line that is not as it should be is told with its column") {
  CHECK(first_error("x = 3\n", Type::integer()).empty());
  CHECK(first_error("x = 3.5\n", Type::integer()) == "1:5");
  CHECK(first_error("y = 1\n x = 3mm\n", Type::integer()) == "2:6");
  CHECK(first_error("x = 3\n", Type::real(rob::lang::kLength)) == "1:5");
  CHECK(first_error("x = 3 4\n", Type::integer()) == "1:7");
  CHECK(first_error("x = ON\n", Type::boolean()) == "1:5");
  CHECK(first_error("x = a\n", Type::string()) == "1:5");
  CHECK(first_error("x 3\n", Type::integer()) == "1:3");
  CHECK(first_error("x = 1\nX = 2\n", Type::integer()) == "2:1");
  CHECK(first_error("3 = 1\n", Type::integer()) == "1:1");
  rob::lang::TypeTable types;
  const Type two = types.array(Type::integer(), 2);
  CHECK(first_error("x = [1, 2]\n", two).empty());
  CHECK(first_error("x = [1]\n", two) == "1:7");
  CHECK(first_error("x = [1, 2, 3]\n", two) == "1:10");
}

TEST_CASE("a variable goes on where the run before has left it; unknown ones are kept, sorted") {
  const Kept kept;
  const std::string text =
      "PERSIST VAR n = 10\nPERSIST VAR s = \"a\"\nPRINT n, s\nn = n + 1\n"
      "MOVE(10, 10, 0)\ns = s + \"b\"\n";
  CHECK(kept.run(text).output.front() == "10a");
  CHECK(content_of(kept.values) == "n = 11\ns = \"ab\"\n");
  std::ofstream(kept.values) << "z = 1mm\ns = \"ab\"\nn = 11\na.b = \"kept\"\n";
  CHECK(kept.run(text).output.front() == "11ab");
  CHECK(content_of(kept.values) == "a.b = \"kept\"\nn = 12\ns = \"abb\"\nz = 1mm\n");
}

TEST_CASE("an assignment counts when the motion before it is done, and is dropped with it") {
  const Kept kept;
  // The second target turns out to be out of reach: what comes after it is never executed.
  const auto failed = kept.run(
      "PERSIST VAR n = 0\nn = 1\nMOVE(10, 10, 0)\nn = 2\n"
      "MOVE(n * 9000mm, 0, 0)\nn = 3\n");
  CHECK(failed.exit_code == runtime::ExitCode::Fault);
  CHECK(content_of(kept.values) == "n = 2\n");
}

TEST_CASE("rob check begins with the saved values and writes none; a TEST with the initial ones") {
  const Kept kept;
  std::ofstream(kept.values) << "n = 5\n";
  const auto loaded = runtime::compile_program(
      kept.program, "PERSIST VAR n = 0\nMOVE(n * 10mm, 0, 0)\nn = 7\n", kept.robot, "");
  CHECK(runtime::foretell(loaded, kept.robot).final_joints.at(0) == doctest::Approx(50));
  CHECK(content_of(kept.values) == "n = 5\n");
}

TEST_CASE("two runs at a time, a bad line, and a folder that cannot be written refuse the start") {
  const Kept kept;
  const std::string text = "PERSIST VAR n = 0\nn = n + 1\n";
  {
    const runtime::ValuesLock other(kept.values);
    CHECK(message_of([&] { kept.run(text); }).find("is in use") != std::string::npos);
  }
  std::ofstream(kept.values) << "n = 1s\n";
  CHECK(message_of([&] { kept.run(text); }).find("cell.values:1:5: E370") != std::string::npos);
  CHECK(content_of(kept.values) == "n = 1s\n");
}

TEST_CASE("what a REF changes is kept while its routine runs") {
  const Kept kept;
  kept.run(
      "PERSIST VAR n = 0\nPROC count(REF k: INT)\nk = k + 1\nMOVE(10, 10, 0)\nk = k + 1\n"
      "MOVE(9000mm * k, 0, 0)\nENDPROC\ncount(n)\n");
  CHECK(content_of(kept.values) == "n = 2\n");
}

TEST_CASE("an array in memory and a name of an ENUM are kept, without any routine") {
  Kept kept;
  const std::string text =
      "ENUM colour: red, green\nPERSIST VAR sizes: ARRAY[2] OF LENGTH\n"
      "PERSIST VAR paint = colour.red\nsizes[2] += 1.5mm\npaint = colour.green\n";
  kept.run(text);
  CHECK(content_of(kept.values) == "paint = green\nsizes = [0mm, 1.5mm]\n");
  kept.run(text);
  CHECK(content_of(kept.values) == "paint = green\nsizes = [0mm, 3mm]\n");
  std::ofstream(kept.values) << "paint = pink\n";
  CHECK(message_of([&] { kept.run(text); }).find("cell.values:1:9: E370") != std::string::npos);
}

TEST_CASE("a LIST is kept with all its elements, whatever has changed it") {
  Kept kept;
  const std::string text =
      "RECORD bolt\nname: STRING\nsize: LENGTH\nENDRECORD\n"
      "PERSIST VAR l: LIST OF bolt\nPERSIST VAR n: LIST OF INT = [9]\nPRINT l, n\n"
      "APPEND(REF l, bolt(name: \"M\\\"6\", size: 2mm * (LEN(l) + 1)))\n"
      "APPEND(REF n, 3)\nSORT(REF n)\nMOVE(10, 10, 0)\n"
      "IF LEN(l) == 3 THEN\nREMOVE(REF l, 1)\nCLEAR(REF n)\nENDIF\n";
  CHECK(kept.run(text).output.front() == "[][9]");
  CHECK(content_of(kept.values) == "l = [bolt(name: \"M\\\"6\", size: 2mm)]\nn = [3, 9]\n");
  CHECK(kept.run(text).output.front() == "[bolt(name: \"M\\\"6\", size: 2mm)][3, 9]");
  CHECK(kept.run(text).exit_code == runtime::ExitCode::Done);
  CHECK(content_of(kept.values) ==
        "l = [bolt(name: \"M\\\"6\", size: 4mm), bolt(name: \"M\\\"6\", size: 6mm)]\nn = []\n");
  std::ofstream(kept.values) << "n = [1, 2mm]\n";
  CHECK(message_of([&] { kept.run(text); }).find("cell.values:1:9: E370") != std::string::npos);
  std::ofstream(kept.values) << "n = [1,]\n";
  CHECK(message_of([&] { kept.run(text); }).find("cell.values:1:8: E370") != std::string::npos);
  std::ofstream(kept.values) << "n = [1 2]\n";
  CHECK(message_of([&] { kept.run(text); }).find("cell.values:1:8: E370") != std::string::npos);
}

TEST_CASE("a LIST that is larger than 1 MiB as text is an error of the program") {
  Kept kept;
  const auto run = kept.run(
      "PERSIST VAR l: LIST OF INT\nFOR i = 1 TO 400000 DO\nAPPEND(REF l, 12)\nENDFOR\n"
      "MOVE(10, 10, 0)\n");
  CHECK(run.exit_code == runtime::ExitCode::Fault);
  REQUIRE(run.error);
  CHECK(run.error->message.find("more than 1 MiB") != std::string::npos);
  CHECK(content_of(kept.values).size() < rob::lang::kMostPersistent + 10);  // what fitted
}

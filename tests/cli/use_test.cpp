// Programs that USE other files, from outside: where they are looked for, and what is said of them.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::read_whole_file;
using rob::test::RobCommand;
using rob::test::run_process;

namespace {

/// A program with a folder `lib` beside it.
class Workshop {
 public:
  explicit Workshop(const std::string& text) : rob_(text) {
    std::filesystem::create_directory(rob_.file("lib"));
  }
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(rob_.file(name)) << text;
  }
  const RobCommand& rob() const { return rob_; }

 private:
  RobCommand rob_;
};

}  // namespace

TEST_CASE("a file is looked for beside the one that USEs it, then in lib beside the program") {
  const Workshop shop("USE tools\nUSE shared\nPRINT here(), there()\n");
  shop.file("tools.rob", "FUNC here(): STRING\n  RETURN \"beside \"\nENDFUNC\n");
  shop.file("lib/tools.rob", "FUNC here(): STRING\n  RETURN \"in lib \"\nENDFUNC\n");
  shop.file("lib/shared.rob", "USE tools\nFUNC there(): STRING\n  RETURN here()\nENDFUNC\n");
  const ProcessResult result = shop.rob()("run", {"--fast"});
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "beside in lib "));
}

TEST_CASE("a file that cannot be USEd is told with the reason, where it is USEd") {
  const Workshop shop("USE tool\nUSE lib\nUSE huge\n");
  shop.file("lib/tools.rob", "CONST a = 1\n");
  std::filesystem::create_directory(shop.rob().file("lib.rob"));
  shop.file("huge.rob", "");
  std::filesystem::resize_file(shop.rob().file("huge.rob"), std::size_t{65} << 20U);
  const ProcessResult result = shop.rob()("check");
  CHECK(result.exit_code == 65);
  CHECK(contains(result.err, "test.rob:1:5: error[E180]: there is no tool.rob in"));
  CHECK(contains(result.err, "help: did you mean tools?"));
  CHECK(contains(result.err, "test.rob:2:5: error[E180]: cannot read"));
  CHECK(contains(result.err, "it is a folder"));
  CHECK(contains(result.err, "at most 64 MiB are read"));
}

TEST_CASE("a program USEs 31 files and no more") {
  std::string program;
  for (int i = 1; i <= 32; ++i) program += "USE part" + std::to_string(i) + "\n";
  const Workshop shop(program);
  for (int i = 1; i <= 32; ++i) {
    shop.file("part" + std::to_string(i) + ".rob", "CONST n" + std::to_string(i) + " = 1\n");
  }
  const ProcessResult result = shop.rob()("check");
  CHECK(contains(result.err, "test.rob:32:5: error[E184]: too much is USEd: at most 31 files"));
  CHECK_FALSE(contains(result.err, "test.rob:31"));
}

TEST_CASE("a file under two names is one file") {
  const Workshop shop("USE tools\nUSE alias\nup()\nalias.up()\nPRINT tools.n\n");
  shop.file("tools.rob", "VAR n = 0\nPROC up()\n  n = n + 1\nENDPROC\n");
  std::filesystem::create_symlink("tools.rob", shop.rob().file("alias.rob"));
  const ProcessResult result = shop.rob()("run", {"--fast"});
  CHECK(contains(result.err, "E185"));  // both names give up(), plainly
  std::ofstream(shop.rob().program()) << "USE tools\nUSE alias\ntools.up()\nalias.up()\n"
                                         "PRINT \"n is \", tools.n\n";
  CHECK(contains(shop.rob()("run", {"--fast"}).out, "n is 2"));
}

TEST_CASE("messages, tables, JSON and trace tell the file of a line") {
  const Workshop shop("USE tools\nMOVE(10, 10, 0)\ngo(0)\n");
  shop.file("tools.rob", "PROC go(n: INT)\n  MOVE(100, 40, 0)\n  PRINT 1 / n\nENDPROC\n");
  const std::string tools = shop.rob().file("tools.rob");
  const std::string trace = shop.rob().file("trace.csv");
  const ProcessResult result = shop.rob()("run", {"--fast", "--json", "--trace", trace});
  CHECK(result.exit_code == 70);
  CHECK(contains(result.err, tools + ":3:11: error[E302]: division by zero\n    PRINT 1 / n\n"));
  CHECK(contains(result.err, "  in go, called in line 3\n"));
  const json report = json::parse(result.out);
  CHECK(report["lines"][0]["line"] == 2);
  CHECK_FALSE(report["lines"][0].contains("file"));
  CHECK(report["lines"][1]["line"] == 2);
  CHECK(report["lines"][1]["file"] == tools);
  CHECK(report["error"]["file"] == tools);
  CHECK(report["error"]["line"] == 3);
  CHECK(report["error"]["calls"][0]["line"] == 3);
  CHECK_FALSE(report["error"]["calls"][0].contains("file"));
  CHECK(contains(read_whole_file(trace), ",tools.rob:2,"));
}

TEST_CASE("each file is laid out and tested by itself") {
  const Workshop shop("use tools\nprint n\ntest \"of the program\"\nexpect n==1\nendtest\n");
  const std::string tools = "const n=1\ntest \"of the tools\"\nexpect n==2\nendtest\n";
  shop.file("tools.rob", tools);
  CHECK(shop.rob()("fmt").exit_code == 0);
  CHECK(contains(read_whole_file(shop.rob().program()), "USE tools\nPRINT n\n"));
  CHECK(read_whole_file(shop.rob().file("tools.rob")) == tools);
  const ProcessResult own = shop.rob()("test");
  CHECK(own.exit_code == 0);
  CHECK_FALSE(contains(own.out, "of the tools"));
  CHECK(run_process({ROB_BINARY, "test", shop.rob().file("tools.rob")}).exit_code == 65);
}

TEST_CASE("a trace does not overwrite a file that the program USEs") {
  const Workshop shop("USE tools\nPRINT n\n");
  shop.file("tools.rob", "CONST n = 1\n");
  const ProcessResult result =
      shop.rob()("run", {"--fast", "--trace", shop.rob().file("tools.rob")});
  CHECK(result.exit_code == 64);
  CHECK(read_whole_file(shop.rob().file("tools.rob")) == "CONST n = 1\n");
}

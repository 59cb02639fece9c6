#include "lang/format/formatter.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "lang/compile/compile.h"
#include "tests/support/gantry_signature.h"
#include "tests/support/process.h"
#include "tests/support/random_program.h"
#include "tests/support/same_code.h"

namespace fs = std::filesystem;
using namespace rob::lang;

namespace {

/// The layout of a text that has one; formatting it again must change nothing.
std::string laid_out(std::string_view source) {
  const Formatting once = format(source);
  for (const Diagnostic& found : once.diagnostics.all()) MESSAGE(render(found, "test", source));
  REQUIRE(once.text.has_value());
  const Formatting twice = format(*once.text);
  REQUIRE(twice.text.has_value());
  CHECK(*twice.text == *once.text);
  return *once.text;
}

void check_keeps_meaning(const std::string& source) {
  const RobotSignature robot = rob::test::gantry_signature();
  const Compilation before = compile(source, robot);
  const Formatting formatting = format(source);
  if (!formatting.text) {
    CHECK_FALSE(before.chunk.has_value());
    CHECK(formatting.diagnostics.has_errors());
    return;
  }
  const Compilation after = compile(laid_out(source), robot);
  REQUIRE(before.chunk.has_value() == after.chunk.has_value());
  if (before.chunk) CHECK(rob::test::same_code(*before.chunk, *after.chunk));
}

/// The same program written by somebody careless: blanks, capital letters and empty lines are
/// strewn in wherever they mean nothing.
std::string disturbed(const std::string& source, std::mt19937& random) {
  const auto chance = [&](unsigned percent) { return random() % 100 < percent; };
  std::string text;
  bool quoted = false;
  bool comment = false;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const char c = source[i];
    if (c == '"' && !comment && (i == 0 || source[i - 1] != '\\')) quoted = !quoted;
    if (!quoted && source.compare(i, 2, "//") == 0) comment = true;
    if (c == '\r') continue;
    if (c == '\n') {
      quoted = comment = false;
      text += chance(20) ? " \t\n\n \n" : chance(20) ? "\r\n" : "\n";
      if (chance(50)) text += std::string(random() % 7, ' ');
      continue;
    }
    const bool sign = !quoted && !comment && (c == '(' || c == ')' || c == ',' || c == '+');
    const bool plus_of_exponent = c == '+' && i > 0 && (source[i - 1] == 'e');
    if (sign && !plus_of_exponent && chance(40)) text += "  ";
    text += c;
    if (sign && c != '+' && chance(40)) text += '\t';
    if (c == ' ' && !quoted && !comment && chance(30)) text += ' ';
  }
  return text;
}

std::vector<fs::path> programs() {
  std::vector<fs::path> found;
  for (const char* folder : {"/examples", "/tests/programs", "/tests/fuzz/seeds"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(std::string(ROB_SOURCE_DIR) + folder)) {
      if (entry.path().extension() == ".rob") found.push_back(entry.path());
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

TEST_CASE("keywords become capital, names are spelled as declared, blanks are set") {
  CHECK(laid_out("var  Speed=20mm/s\nmove( 1,2 ,  3 )at SPEED over  2s\nprint\"v \",speed*2\n") ==
        "VAR Speed = 20mm/s\nMOVE(1, 2, 3) AT Speed OVER 2s\nPRINT \"v \", Speed * 2\n");
  CHECK(laid_out("VAR a = min(2,-3)+ - 4^ -2\nPRINT(a)\nIF not(a>1)then stop\n") ==
        "VAR a = MIN(2, -3) + -4 ^ -2\nPRINT (a)\nIF NOT (a > 1) THEN STOP\n");
  CHECK(laid_out("var X:length\nMOVE( ,x:1mm)\n") == "VAR X: LENGTH\nMOVE(, x: 1mm)\n");
  CHECK(laid_out("MOVE(140,,)\n") == "MOVE(140, , )\n");
}

TEST_CASE("a routine that is called like a word of a place is spelled as declared") {
  CHECK(
      laid_out(
          "proc Path(n:INT)\nendproc\nPATH (1)\nif TRUE then path(2)\npath at 50% do\nendpath\n") ==
      "PROC Path(n: INT)\nENDPROC\nPath(1)\nIF TRUE THEN Path(2)\nPATH AT 50% DO\nENDPATH\n");
}

TEST_CASE("the names of an ENUM stay as they are written, reserved words too") {
  CHECK(laid_out("enum Mode:off,On , Auto\nvar m=mode.OFF\nprint m,mode.auto") ==
        "ENUM Mode: off, On, Auto\nVAR m = Mode.off\nPRINT m, Mode.Auto\n");
}

TEST_CASE("a unit stays as it is written, whatever else its letters could mean") {
  CHECK(laid_out("var s: [ in ]\nVAR v:[N * m / s^2]\nvar f: [1 / s]\n") ==
        "VAR s: [in]\nVAR v: [N*m/s^2]\nVAR f: [1/s]\n");
  CHECK(laid_out("VAR s = 2s\nPRINT 50mm/s, 50mm /s, 2mm ^2\n") ==
        "VAR s = 2s\nPRINT 50mm/s, 50mm / s, 2mm ^ 2\n");
}

TEST_CASE("a block is two blanks deeper; its branches stand with its beginning") {
  CHECK(
      laid_out("VAR n=1\nif n==1 then\nmove(1,2,3)\nelsif n==2 then\nstop\nelse\nfor i=1 to 2 do\n"
               "print i\nendfor\nendif\nEND\n") ==
      "VAR n = 1\nIF n == 1 THEN\n  MOVE(1, 2, 3)\nELSIF n == 2 THEN\n  STOP\nELSE\n"
      "  FOR i = 1 TO 2 DO\n    PRINT i\n  ENDFOR\nENDIF\nEND\n");
}

TEST_CASE("comments are kept: alone as deep as the code, behind code two blanks off") {
  CHECK(laid_out("//a\nWHILE TRUE DO\n//b  \nSTOP//c\nENDWHILE // d") ==
        "//a\nWHILE TRUE DO\n  //b\n  STOP  //c\nENDWHILE  // d\n");
}

TEST_CASE("comments that stand below each other still do") {
  CHECK(laid_out("MOVE(1,2,3)   // one\nSTOP          // two\nSTOP // three\n") ==
        "MOVE(1, 2, 3)  // one\nSTOP           // two\nSTOP  // three\n");
}

TEST_CASE("one empty line is kept between others, none at the beginning and the end") {
  CHECK(laid_out("\r\n\n STOP\t\r\n\n\n\nSTOP\n\n\n") == "STOP\n\nSTOP\n");
  CHECK(laid_out("").empty());
  CHECK(laid_out("\n  \n").empty());
  CHECK(laid_out("\xEF\xBB\xBFSTOP") == "STOP\n");
}

TEST_CASE("a line within brackets is a level deeper, its end where the statement began") {
  CHECK(laid_out("IF TRUE THEN\nMOVE(1,\n2, // y\n3\n)\nPRINT MIN(1,(2\n+3))\nENDIF\n") ==
        "IF TRUE THEN\n  MOVE(1,\n    2,  // y\n    3\n  )\n  PRINT MIN(1, (2\n      + 3))\n"
        "ENDIF\n");
}

TEST_CASE("statements that this version cannot run are laid out") {
  CHECK(laid_out("signal wire:speed=aout[1]scale 0mm/s to 300mm/s safe 0mm/s\n") ==
        "SIGNAL wire: SPEED = AOUT[1] SCALE 0mm/s TO 300mm/s SAFE 0mm/s\n");
  CHECK(laid_out("proc go( ref a,b:array[3]of[in]=[1in,2in],P:pose in world)\n"
                 "movel by(0mm,0mm,-a)at live here.z*2 until FORCE.z>3N\nendproc\n") ==
        "PROC go(REF a, b: ARRAY[3] OF [in] = [1in, 2in], P: POSE IN world)\n"
        "  MOVEL BY (0mm, 0mm, -a) AT LIVE HERE.z * 2 UNTIL force.z > 3N\nENDPROC\n");
  CHECK(
      laid_out(
          "when door:raise \"open\"\npath at 8mm/s do\nafter 2mm lead 1s:torch=on\nendpath\n") ==
      "WHEN door : RAISE \"open\"\nPATH AT 8mm/s DO\n  AFTER 2mm LEAD 1s : torch = ON\nENDPATH\n");
  CHECK(laid_out("record Part\nWIDTH,h:length\nendrecord\nselect 3\ncase 1,2:\nstop\nelse\nhalt\n"
                 "endselect\n") ==
        "RECORD Part\n  WIDTH, h: LENGTH\nENDRECORD\nSELECT 3\nCASE 1, 2:\n  STOP\nELSE\n  HALT\n"
        "ENDSELECT\n");
  CHECK(laid_out("units in,deg\nmove joint 6 to -2rad\njog tool (1mm/s, , )for 2s\n") ==
        "UNITS in, deg\nMOVE JOINT 6 TO -2rad\nJOG TOOL (1mm/s, , ) FOR 2s\n");
}

TEST_CASE("BY and JOINT after MOVE are names where a value goes on") {
  CHECK(laid_out("move by -step\nmove joint -2 to 1rad\n") ==
        "MOVE BY -step\nMOVE JOINT -2 TO 1rad\n");
  CHECK(laid_out("move by\nmove by + step\nmovel joint*2\n") ==
        "MOVE by\nMOVE by + step\nMOVEL joint * 2\n");
}

TEST_CASE("NEAR and FREE are clauses behind a target, and names elsewhere") {
  const std::string names = "VAR near = JOINTS()\nVAR free = POSE(1mm, 2mm, 0mm)\n";
  CHECK(laid_out(names + "move free near near free spin\n") ==
        names + "MOVE free NEAR near FREE SPIN\n");
  CHECK(laid_out(names + "movel FREE free c at 5mm/s\n") == names + "MOVEL free FREE c AT 5mm/s\n");
  CHECK(laid_out(names + "PRINT NEAR\n") == names + "PRINT near\n");
}

TEST_CASE("what lies around motions is laid out like clauses and blocks") {
  CHECK(
      laid_out(
          "press z -10N limit 5mm/s in tool do\nmovel by(1mm, ,0deg)in Pallet with cup\n"
          "endpress\nwith cup in Pallet do\noverride 30%\nload 2kg cog (0mm,0mm,5mm)\nendwith\n") ==
      "PRESS Z -10N LIMIT 5mm/s IN TOOL DO\n  MOVEL BY (1mm, , 0deg) IN Pallet WITH cup\n"
      "ENDPRESS\nWITH cup IN Pallet DO\n  OVERRIDE 30%\n  LOAD 2kg COG (0mm, 0mm, 5mm)\nENDWITH\n");
  CHECK(laid_out("path at 8mm/s do\nmovec via(1,2,3)to q\nmoves via a,b+v to(1, ,2)\n"
                 "before 2mm:torch=on\nspiral from r turns n/2\nendpath\n") ==
        "PATH AT 8mm/s DO\n  MOVEC VIA (1, 2, 3) TO q\n  MOVES VIA a, b + v TO (1, , 2)\n"
        "  BEFORE 2mm : torch = ON\n  SPIRAL FROM r TURNS n / 2\nENDPATH\n");
}

TEST_CASE("a program with errors has no layout, and its errors are told") {
  const Formatting formatting = format("STOP\nMOVE(1,\nPRINT \"open\n");
  CHECK_FALSE(formatting.text.has_value());
  CHECK(formatting.diagnostics.error_count() >= 2);
  CHECK_FALSE(format(std::string_view("STOP\0", 5)).text.has_value());
}

TEST_CASE("blocks that are skipped as not in this version cannot make the layout explode") {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "LOOP\n";
  for (int i = 0; i < 2000; ++i) text += "ENDLOOP\n";
  const Formatting formatting = format(text);
  if (formatting.text) CHECK(formatting.text->size() < 4000 * 410);
}

TEST_CASE("every program of the tests and examples means the same afterwards") {
  for (const fs::path& path : programs()) {
    CAPTURE(path.string());
    check_keeps_meaning(rob::test::read_whole_file(path));
  }
}

TEST_CASE("however carelessly a program is written, its layout is the same") {
  std::mt19937 random(40);
  for (const fs::path& path : programs()) {
    const std::string source = rob::test::read_whole_file(path);
    const Formatting tidy = format(source);
    // Comments behind code are set by where they stand, which the disturbance changes.
    if (!tidy.text || source.find("//") != std::string::npos) continue;
    const std::string untidy = disturbed(source, random);
    CAPTURE(path.string());
    CAPTURE(untidy);
    check_keeps_meaning(untidy);
    std::string lines = *tidy.text;
    std::string others = laid_out(untidy);
    for (std::string* each : {&lines, &others}) {
      while (each->find("\n\n") != std::string::npos) each->erase(each->find("\n\n"), 1);
    }
    CHECK(lines == others);
  }
}

TEST_CASE("random programs, carelessly written, mean the same in their layout") {
  std::mt19937 random(41);
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    const std::string source = rob::test::random_gantry_program(seed).text;
    const std::string untidy = disturbed(source, random);
    CAPTURE(untidy);
    REQUIRE(format(untidy).text.has_value());
    check_keeps_meaning(untidy);
  }
}

TEST_CASE("what a program says of contacts is laid out") {
  CHECK(
      laid_out("obstacle box=box(pose(1mm,2mm,3mm),4mm,5mm,6mm)\n"
               "tool pen=POSE(0mm,0mm,9mm)mass 1kg shape capsule((0mm,0mm,0mm),(0mm,0mm,9mm),2mm),"
               "Capsule((0mm,0mm,0mm),(0mm,0mm,9mm),2mm)\n"
               "allow gripper,Box do\nmove(1,2,3)\nendallow\nvar allow=1\nallow=2\n") ==
      "OBSTACLE box = BOX(POSE(1mm, 2mm, 3mm), 4mm, 5mm, 6mm)\n"
      "TOOL pen = POSE(0mm, 0mm, 9mm) MASS 1kg SHAPE CAPSULE((0mm, 0mm, 0mm), (0mm, 0mm, 9mm), "
      "2mm), CAPSULE((0mm, 0mm, 0mm), (0mm, 0mm, 9mm), 2mm)\n"
      "ALLOW gripper, box DO\n  MOVE(1, 2, 3)\nENDALLOW\nVAR allow = 1\nallow = 2\n");
}

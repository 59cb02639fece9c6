#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <sstream>
#include <string>

#include "lang/compile/compile.h"
#include "tests/fuzz/promises.h"
#include "tests/support/gantry_signature.h"
#include "tests/support/grammar_program.h"

/// libFuzzer target behind the parser: the bytes decide which sentences of docs/rob.ebnf a program
/// is made of. It compiles, so that each input reaches checker, compiler and Vm, and is run.
namespace {

using rob::test::Decisions;
using rob::test::Grammar;

class Bytes final : public Decisions {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::size_t below(std::size_t count) override {
    if (at_ == bytes_.size()) return count - 1;  // what may be left out is
    return bytes_[at_++] % count;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

Grammar grammar() {
  std::ifstream file(ROB_SOURCE_DIR "/docs/rob.ebnf", std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return Grammar(text.str());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int kTries = 20;
  static const rob::lang::RobotSignature robot = rob::test::gantry_signature();
  static const Grammar rules = grammar();
  Bytes decisions({data, size});
  int kept = 0;
  const std::string program = rob::test::compiling_program(rules, decisions, robot, kTries, kept);
  const rob::lang::Compilation compilation = rob::lang::compile(program, robot);
  rob::fuzz::promise(compilation.chunk.has_value());
  rob::fuzz::run(*compilation.chunk, robot, std::nullopt);
  for (std::size_t i = 0; i < compilation.chunk->tests.size(); ++i) {
    rob::fuzz::run(*compilation.chunk, robot, i);
  }
  return 0;
}

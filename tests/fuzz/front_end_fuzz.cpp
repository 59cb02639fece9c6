#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lang/compile/compile.h"
#include "lang/syntax/parser.h"
#include "tests/fuzz/promises.h"
#include "tests/support/gantry_signature.h"

/// libFuzzer target: whatever bytes a file holds, it is compiled or refused with messages that
/// can be shown, and a program that compiles runs against the printing machine for a while.
/// A crash, a sanitizer's finding, or a broken promise below (abort) is a failure.
namespace {

using namespace rob::lang;
using rob::fuzz::promise;
using rob::fuzz::run;

bool shows_well(const std::string& text) {
  return std::ranges::all_of(
      text, [](char c) { return c == '\n' || static_cast<unsigned char>(c) >= 0x20; });
}

void check_messages(const Compilation& compilation, std::string_view source) {
  const Diagnostics& diagnostics = compilation.diagnostics;
  promise(compilation.chunk.has_value() == !diagnostics.has_errors());
  promise(diagnostics.all().size() <= Diagnostics::kMost);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const std::string text = render(diagnostic, "fuzz.rob", source, compilation.used);
    promise(shows_well(text));
    promise(diagnostic.place.file > 0 || text.starts_with("fuzz.rob"));
    promise(diagnostic.place.file <= compilation.used.size());
    promise(!diagnostic.message.empty() && diagnostic.message.find('\n') == std::string::npos);
    promise(shows_well(diagnostic.message) && shows_well(diagnostic.help));
  }
}

/// The input itself: behind a line "//@tools" begins tools.rob.
class InputFiles final : public Sources {
 public:
  explicit InputFiles(std::string_view input) : input_(input) {}
  const SourceFile& program() const override { return program_; }
  std::variant<SourceFile, NoSource> find(std::string_view name,
                                          const std::string& /*by*/) const override {
    if (name == program_.identity) return program_;
    const std::string mark = "\n//@" + std::string(name) + "\n";
    const std::size_t at = input_.find(mark);
    if (at == std::string_view::npos) return NoSource{"there is no such file", ""};
    const std::string_view text = input_.substr(at + mark.size());
    return SourceFile{std::string(name) + ".rob", std::string(name),
                      std::string(text.substr(0, text.find("\n//@")))};
  }

 private:
  std::string_view input_;
  SourceFile program_{"fuzz.rob", "fuzz", ""};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const RobotSignature robot = rob::test::gantry_signature();
  const std::string_view source(reinterpret_cast<const char*>(data), size);
  const InputFiles files(source);
  const Compilation compilation =
      compile(source.substr(0, source.find("\n//@")), robot, {}, {}, &files);
  check_messages(compilation, source.substr(0, source.find("\n//@")));
  if (!compilation.chunk) return 0;
  run(*compilation.chunk, robot, std::nullopt);
  if (!compilation.chunk->tests.empty()) run(*compilation.chunk, robot, 0);
  return 0;
}

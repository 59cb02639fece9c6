#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lang/compile/compile.h"
#include "lang/format/formatter.h"
#include "tests/support/gantry_signature.h"
#include "tests/support/same_code.h"

/// libFuzzer target: whatever bytes a file holds, it gets a layout or is left alone with a reason;
/// the layout is final, and the program means what it meant.
namespace {

using namespace rob::lang;

void promise(bool kept) {
  if (!kept) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const RobotSignature robot = rob::test::gantry_signature();
  const std::string_view source(reinterpret_cast<const char*>(data), size);
  const Formatting once = format(source);
  promise(once.text.has_value() != once.diagnostics.has_errors());
  const Compilation before = compile(source, robot);
  promise(once.text.has_value() || !before.chunk.has_value());
  if (!once.text) return 0;
  const Formatting twice = format(*once.text);
  promise(twice.text == once.text);
  const Compilation after = compile(*once.text, robot);
  promise(before.chunk.has_value() == after.chunk.has_value());
  promise(!before.chunk || rob::test::same_code(*before.chunk, *after.chunk));
  return 0;
}

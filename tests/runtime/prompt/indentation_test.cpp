#include "runtime/prompt/indentation.h"

#include <doctest/doctest.h>

using rob::runtime::indent_after;
using rob::runtime::laid_out;

TEST_CASE("a line is indented as the one before, and deeper behind one that opens a block") {
  CHECK(indent_after("LOOP") == "  ");
  CHECK(indent_after("LOOP\n    MOVE(1, 2, 3)") == "    ");
  CHECK(indent_after("IF a THEN\n  b = 1\nELSE // not") == "  ");
  CHECK(indent_after("SELECT n\nCASE 1:") == "  ");
  CHECK(indent_after("LOOP\n  FOR i = 1 TO 3 DO") == "    ");
}

TEST_CASE("the end of a block stands further left, and blanks that are typed count alone") {
  CHECK(laid_out("    ENDFOR", "    ") == "  ENDFOR");
  CHECK(laid_out("  else", "  ") == "else");
  CHECK(laid_out("      PRINT 1", "    ") == "  PRINT 1");
  CHECK(laid_out("    ENDFOR", "  ") == "  ENDFOR");
  CHECK(laid_out("PRINT 1", "  ") == "PRINT 1");  // the blanks were deleted
  CHECK(laid_out("  ENDING = 3", "  ") == "  ENDING = 3");
}

#include "tests/support/trace_file.h"

#include <doctest/doctest.h>

#include <string>

using rob::test::AxisValues;
using rob::test::parse_trace;
using rob::test::TraceError;
using rob::test::TraceFile;

namespace {

const std::string kHeader =
    "t,line,piece,sigma,rate,state,override,limit,late_us,q1,q2,qd1,qd2,qdd1,qdd2,a1,a2,"
    "x,y,z,a,b,c,drive1,drive2\n";
const std::string kRow =
    "0.01,7,2,-1.365,1,1,0.5,3,12.5,1,2,3,4,5,6,1.5,2.5,10,20,30,40,50,60,-0.25,1e-3\n";

}  // namespace

TEST_CASE("a trace of two axes is read cell by cell") {
  const TraceFile trace = parse_trace(kHeader + kRow);
  CHECK(trace.axes == 2);
  REQUIRE(trace.rows.size() == 1);
  CHECK(trace.rows[0].t == 0.01);
  CHECK(trace.rows[0].line == 7);
  CHECK(trace.rows[0].sigma == -1.365);
  CHECK(trace.rows[0].rate == 1);
  CHECK(trace.rows[0].state == 1);
  CHECK(trace.rows[0].override_share == 0.5);
  CHECK(trace.rows[0].late_us == 12.5);
  CHECK(trace.rows[0].q == AxisValues{1, 2});
  CHECK(trace.rows[0].qd == AxisValues{3, 4});
  CHECK(trace.rows[0].qdd == AxisValues{5, 6});
  CHECK(trace.rows[0].measured == AxisValues{1.5, 2.5});
  CHECK(trace.rows[0].pose[0] == 10);
  CHECK(trace.rows[0].pose[5] == 60);
  CHECK(trace.rows[0].drive == AxisValues{-0.25, 0.001});
}

TEST_CASE("a trace with a strange header, a short row, a word or a NaN is refused") {
  CHECK_THROWS_AS(parse_trace(""), TraceError);
  CHECK_THROWS_AS(parse_trace("t,line\n"), TraceError);
  CHECK_THROWS_AS(parse_trace(kHeader + "0.01,7\n"), TraceError);
  std::string swapped = kHeader;
  swapped.replace(swapped.find("qd1,qd2"), 7, "qd2,qd1");
  CHECK_THROWS_AS(parse_trace(swapped + kRow), TraceError);
  for (const char* cell : {"nan", "inf", "one", "", " 1", "1x"}) {
    std::string row = kRow;
    row.replace(row.find("12.5"), 4, cell);
    CHECK_THROWS_AS(parse_trace(kHeader + row), TraceError);
  }
}

TEST_CASE("a trace whose last row was cut off is refused") {
  CHECK_THROWS_AS(parse_trace(kHeader + kRow.substr(0, kRow.size() - 1)), TraceError);
}

#include "lang/values/units.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace rob::lang;

namespace {

double quantity(std::string_view number, std::string_view unit) {
  return quantity_of(number, find_unit(unit).value()).value();
}

double si(std::string_view number, std::string_view unit) {
  return to_si(quantity(number, unit), find_unit(unit)->dimension);
}

}  // namespace

TEST_CASE("every unit of the language has its dimension and its size in SI") {
  struct Row {
    const char* unit;
    Dimension dimension;
    double one;
  };
  const double pi = 3.14159265358979323846;
  for (const Row& row :
       {Row{"um", kLength, 1e-6}, {"mm", kLength, 1e-3},   {"cm", kLength, 1e-2},
        {"m", kLength, 1},        {"in", kLength, 0.0254}, {"deg", kAngle, pi / 180},
        {"rad", kAngle, 1},       {"rev", kAngle, 2 * pi}, {"rpm", kAngularSpeed, 2 * pi / 60},
        {"us", kTime, 1e-6},      {"ms", kTime, 1e-3},     {"s", kTime, 1},
        {"min", kTime, 60},       {"h", kTime, 3600},      {"N", kForce, 1},
        {"kN", kForce, 1e3},      {"Nm", kTorque, 1},      {"g", kMass, 1e-3},
        {"kg", kMass, 1},         {"Hz", kFrequency, 1},   {"V", kVoltage, 1},
        {"%", kNone, 0.01}}) {
    CAPTURE(row.unit);
    const auto unit = find_unit(row.unit);
    REQUIRE(unit);
    CHECK(unit->dimension == row.dimension);
    CHECK(si("1", row.unit) == doctest::Approx(row.one).epsilon(1e-15));
    CHECK(std::ranges::count(unit_names(), std::string_view(row.unit)) == 1);
  }
  CHECK(unit_names().size() == 22);
}

TEST_CASE("units are multiplied, divided and raised to powers") {
  CHECK(find_unit("mm/s")->dimension == kSpeed);
  CHECK(find_unit("m/s^2")->dimension == kAcceleration);
  CHECK(find_unit("N*m")->dimension == find_unit("Nm")->dimension);
  CHECK(find_unit("kg*m/s^2")->dimension == kForce);
  CHECK(find_unit("1/s")->dimension == kFrequency);
  CHECK(find_unit("s^-1")->dimension == kFrequency);
  CHECK(find_unit("1/mm*mm")->dimension == kNone);
  CHECK(si("50", "mm/s") == 0.05);
  CHECK(si("2", "mm^2") == 2e-6);
  CHECK(quantity("2", "m^2") == 2e6);
  CHECK(si("30", "N/mm") == 30000);
  CHECK(si("3", "1/ms") == 3000);
  CHECK(si("6", "m/min") == doctest::Approx(0.1));
  CHECK(si("60", "rev/min") == si("60", "rpm"));
}

TEST_CASE("units are case-sensitive and have no blanks") {
  for (const char* none : {"MM", "Mm", "S", "nm", "", " mm", "mm ", "mm / s", "mm/", "mm^", "mm^0",
                           "mm^2.5", "/s", "1", "1/", "2/s", "mm//s", "mm*3"}) {
    CAPTURE(none);
    CHECK_FALSE(find_unit(none));
  }
}

TEST_CASE("the longest unit behind a number is taken, and it ends at the border of a word") {
  const auto length = [](std::string_view text) {
    const auto match = match_unit(text);
    return match ? static_cast<int>(match->length) : -1;
  };
  CHECK(length("mm/s, 3") == 4);
  CHECK(length("mm / s") == 2);    // divides by the variable s
  CHECK(length("mm/speed") == 2);  // divides by the variable speed
  CHECK(length("m/s^2)") == 5);
  CHECK(length("mm^2.5") == 2);  // the power of a length, not a unit
  CHECK(length("mm*2") == 2);
  CHECK(length("Nm") == 2);
  CHECK(length("N*m*x") == 3);
  CHECK(length("%") == 1);
  CHECK(length("%x") == -1);
  CHECK(length("mmm") == -1);
  CHECK(length("mm2") == -1);
  CHECK(length("mm_") == -1);
}

TEST_CASE("an absurd power is no unit, whatever its length") {
  std::string text = "mm";
  for (int i = 0; i < 1000; ++i) text += "*mm";
  const auto match = match_unit(text);
  REQUIRE(match);
  CHECK(match->unit.dimension.length == 127);
  CHECK_FALSE(find_unit(text));
  CHECK_FALSE(find_unit("rev^99/rad^99*rev^99"));
  CHECK_FALSE(find_unit("mm^100"));
}

TEST_CASE("a literal in a power-of-ten unit is the double nearest to its decimal value") {
  CHECK(si("9", "mm") == 0.009);  // 9 * 0.001 is the next double
  CHECK(si("0.1", "mm") == 0.0001);
  CHECK(si("123.456", "mm") == 0.123456);
  CHECK(quantity("35", "um") == 35e-3);
  CHECK(si("1.375", "s") == 1.375);
  CHECK(si("7", "ms") == 0.007);
  CHECK(si("1e3", "mm") == 1);
  CHECK(si("2.5E-1", "mm") == 0.00025);
  CHECK(si("15", "%") == 0.15);
  CHECK(si("180", "deg") == 3.14159265358979323846);
}

TEST_CASE("a literal is the double nearest to its value in mm or deg") {
  CHECK(quantity("0.0163", "m") == 16.3);
  CHECK(quantity("3", "in") == 76.2);  // 3 * 25.4 is the double before
  CHECK(quantity("0.7", "in") == 17.78);
  CHECK(quantity("0.1", "rev") == 36);
  CHECK(quantity("1", "rad") == doctest::Approx(57.29577951308232).epsilon(1e-16));
  CHECK(quantity("300", "mm/min") == 5);
  CHECK(quantity("1.5", "h") == 5400);
  CHECK(quantity("5", "N") == 5000);  // kg*mm/s^2
  CHECK(quantity("0.07", "Nm") == 70000);
  // Millionths of an inch, against whole numbers of tenths of a nanometre.
  for (int millionths = 1; millionths < 3'000'000; millionths += 997) {
    const std::string text = std::to_string(millionths) + "e-6";
    CHECK(quantity(text, "in") == static_cast<double>(millionths * 254LL) / 1e7);
  }
}

TEST_CASE("a quantity goes to SI and comes back with the digits that were written") {
  for (int i = -20000; i < 20000; i += 3) {
    const double thousandths = i / 1000.0;
    CHECK(from_si(to_si(thousandths, kLength), kLength) == thousandths);
    CHECK(from_si(to_si(thousandths, kAngle), kAngle) == thousandths);
    CHECK(from_si(to_si(thousandths, kForce), kForce) == thousandths);
    CHECK(from_si(to_si(thousandths, kAngularSpeed), kAngularSpeed) == thousandths);
  }
  CHECK(to_si(1000, kLength) == 1);
  CHECK(to_si(2e6, Dimension{.length = 2}) == 2);
  CHECK(to_si(2e-3, Dimension{.length = -1}) == 2);
  CHECK(from_si(1e300, kTime) == 1e300);
}

TEST_CASE("a number beyond a double is refused, one below it is zero") {
  const Unit none;
  CHECK_FALSE(quantity_of("1e400", none));
  CHECK_FALSE(quantity_of("1e308", *find_unit("kN")));
  CHECK_FALSE(quantity_of("1e308", *find_unit("min")));
  CHECK_FALSE(quantity_of("1e99999999999999999999", none));
  CHECK(quantity_of("1e308", *find_unit("um")) == 1e305);
  CHECK(quantity_of("1e309", *find_unit("um")) == 1e306);
  CHECK(quantity_of("1e-400", none) == 0);
  CHECK(quantity_of("1e-99999999999999999999", none) == 0);
  CHECK(quantity_of("0e99999999999999999999", none) == 0);
  CHECK(quantity_of("4.9406564584124654e-324", none) == 4.9406564584124654e-324);
  CHECK(quantity_of("0." + std::string(500, '0') + "1e501", none) == 1);
  CHECK(quantity_of("1" + std::string(500, '0') + "e-500", none) == 1);
}

TEST_CASE("a dimension names the unit in which its values are written") {
  CHECK(unit_text(kLength) == "mm");
  CHECK(unit_text(kSpeed) == "mm/s");
  CHECK(unit_text(kAcceleration) == "mm/s^2");
  CHECK(unit_text(kAngle) == "deg");
  CHECK(unit_text(kAngularSpeed) == "deg/s");
  CHECK(unit_text({.time = -2, .angle = 1}) == "deg/s^2");
  CHECK(unit_text(kTime) == "s");
  CHECK(unit_text(kForce) == "N");
  CHECK(unit_text(kTorque) == "Nm");
  CHECK(unit_text({.mass = 1, .time = -2}) == "N/mm");
  CHECK(unit_text(kMass) == "kg");
  CHECK(unit_text(kFrequency) == "Hz");
  CHECK(unit_text(kVoltage) == "V");
  CHECK(unit_text(kNone).empty());
  CHECK(unit_text({.length = 1, .mass = 1}) == "kg*mm");
  CHECK(unit_text({.length = 2}) == "mm^2");
  CHECK(unit_text({.length = -1}) == "mm^-1");
  CHECK(unit_text({.length = -1, .mass = 1, .time = -1}) == "kg/mm/s");
}

TEST_CASE("the written unit of every dimension is read back as that dimension") {
  for (int length = -3; length <= 3; ++length) {
    for (int mass = -2; mass <= 2; ++mass) {
      for (int time = -3; time <= 3; ++time) {
        for (int angle = -2; angle <= 2; ++angle) {
          const Dimension d{.length = static_cast<std::int8_t>(length),
                            .mass = static_cast<std::int8_t>(mass),
                            .time = static_cast<std::int8_t>(time),
                            .angle = static_cast<std::int8_t>(angle),
                            .voltage = static_cast<std::int8_t>(length - mass)};
          if (d.none()) continue;
          const auto unit = find_unit(unit_text(d));
          REQUIRE_MESSAGE(unit, unit_text(d));
          CHECK(unit->dimension == d);
        }
      }
    }
  }
}

#include "lang/values/builtins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lang/text/ascii.h"
#include "lang/values/pose_functions.h"
#include "lang/values/text_functions.h"

namespace rob::lang {
namespace {

using arithmetic::store_finite;
using arithmetic::to_integer;
using Error = ArithmeticError;
using Arguments = std::span<const Slot>;

Error absolute_int(Arguments a, Slot& r) {
  if (a[0].integer < 0) return arithmetic::negate(a[0].integer, r.integer);
  r.integer = a[0].integer;
  return Error::None;
}
Error absolute_real(Arguments a, Slot& r) { return store_finite(std::fabs(a[0].real), r.real); }

Error sign_int(Arguments a, Slot& r) {
  r.integer = (a[0].integer > 0) - (a[0].integer < 0);
  return Error::None;
}
Error sign_real(Arguments a, Slot& r) {
  r.integer = (a[0].real > 0) - (a[0].real < 0);
  return Error::None;
}

Error least_int(Arguments a, Slot& r) {
  r = *std::ranges::min_element(a, {}, &Slot::integer);
  return Error::None;
}
Error least_real(Arguments a, Slot& r) {
  r = *std::ranges::min_element(a, {}, &Slot::real);
  return Error::None;
}
Error greatest_int(Arguments a, Slot& r) {
  r = *std::ranges::max_element(a, {}, &Slot::integer);
  return Error::None;
}
Error greatest_real(Arguments a, Slot& r) {
  r = *std::ranges::max_element(a, {}, &Slot::real);
  return Error::None;
}

Error clamp_int(Arguments a, Slot& r) {
  if (a[1].integer > a[2].integer) return Error::ClampReversed;
  r.integer = std::clamp(a[0].integer, a[1].integer, a[2].integer);
  return Error::None;
}
Error clamp_real(Arguments a, Slot& r) {
  if (a[1].real > a[2].real) return Error::ClampReversed;
  r.real = std::clamp(a[0].real, a[1].real, a[2].real);
  return Error::None;
}

Error square_root(Arguments a, Slot& r) {
  if (a[0].real < 0) return Error::NegativeRoot;
  return store_finite(std::sqrt(a[0].real), r.real);
}
Error hypotenuse(Arguments a, Slot& r) {
  return store_finite(std::hypot(a[0].real, a[1].real), r.real);
}
/// Angles are in deg. With the few bits more of a long double SIN(30deg) is 0.5, and
/// ATAN2(1, 1) 45deg.
constexpr long double kDegree = std::numbers::pi_v<long double> / 180;

/// Computed where the function is steep and symmetric, within 45 degrees of a multiple of 90, so
/// that COS(90deg) is 0.
struct QuarterTurns {
  long double rest = 0;  ///< rad
  unsigned quarter = 0;  ///< 0 to 3
};
QuarterTurns quarter_turns(double degrees) {
  int quarters = 0;
  const double rest = std::remquo(degrees, 90.0, &quarters);
  return {static_cast<long double>(rest) * kDegree, static_cast<unsigned>(quarters) & 3U};
}
double sine_of(QuarterTurns angle) {
  const long double size = (angle.quarter & 1U) != 0 ? std::cos(angle.rest) : std::sin(angle.rest);
  return static_cast<double>((angle.quarter & 2U) != 0 ? -size : size);
}
Error sine(Arguments a, Slot& r) { return store_finite(sine_of(quarter_turns(a[0].real)), r.real); }
Error cosine(Arguments a, Slot& r) {
  QuarterTurns angle = quarter_turns(a[0].real);
  angle.quarter = (angle.quarter + 1) & 3U;
  return store_finite(sine_of(angle), r.real);
}
Error tangent(Arguments a, Slot& r) {
  const QuarterTurns angle = quarter_turns(a[0].real);
  const long double slope = std::tan(angle.rest);
  const bool turned = (angle.quarter & 1U) != 0;
  if (turned && slope == 0) return Error::NotFinite;
  return store_finite(static_cast<double>(turned ? -1 / slope : slope), r.real);
}
Error store_angle(long double radians, Slot& r) {
  return store_finite(static_cast<double>(radians / kDegree), r.real);
}
long double wide(const Slot& slot) { return slot.real; }
Error arc_sine(Arguments a, Slot& r) {
  if (std::fabs(a[0].real) > 1) return Error::ArcOutOfRange;
  return store_angle(std::asin(wide(a[0])), r);
}
Error arc_cosine(Arguments a, Slot& r) {
  if (std::fabs(a[0].real) > 1) return Error::ArcOutOfRange;
  return store_angle(std::acos(wide(a[0])), r);
}
Error arc_tangent(Arguments a, Slot& r) { return store_angle(std::atan(wide(a[0])), r); }
/// (0, 0) has no direction; std::atan2 and the language answer 0.
Error arc_tangent2(Arguments a, Slot& r) {
  return store_angle(std::atan2(wide(a[0]), wide(a[1])), r);
}
Error exponential(Arguments a, Slot& r) { return store_finite(std::exp(a[0].real), r.real); }
Error natural_logarithm(Arguments a, Slot& r) {
  if (a[0].real <= 0) return Error::LogarithmOfNonPositive;
  return store_finite(std::log(a[0].real), r.real);
}
Error decimal_logarithm(Arguments a, Slot& r) {
  if (a[0].real <= 0) return Error::LogarithmOfNonPositive;
  return store_finite(std::log10(a[0].real), r.real);
}

using Rounding = double (*)(double);

template <Rounding kRound>
Error whole(Arguments a, Slot& r) {
  return to_integer(kRound(a[0].real), r.integer);
}
/// A step as a fraction of whole numbers, so that multiples of it are the doubles nearest to their
/// decimals: 0.25 is 25 / 100. The step itself over 1 where it has too many decimals.
struct Fraction {
  double above = 1;
  double below = 1;
};
Fraction fraction_of(double step) {
  constexpr double kMostBelow = 1e9;  // [choice] finer than anything is made
  for (double below = 1; below <= kMostBelow; below *= 10) {
    const double above = std::round(step * below);
    if (above / below == step && std::fabs(above) < 0x1p53) return {above, below};
  }
  return {step, 1};
}
template <Rounding kRound>
Error multiple(Arguments a, Slot& r) {
  if (a[1].real == 0) return Error::DivisionByZero;
  const Fraction step = fraction_of(a[1].real);
  double steps = a[0].real * step.below / step.above;
  // A value that was written as a whole number of steps is one.
  if (const double whole = std::round(steps); whole * step.above / step.below == a[0].real) {
    steps = whole;
  }
  return store_finite(kRound(steps) * step.above / step.below, r.real);
}
constexpr BuiltinFunction floor_whole = whole<std::floor>;
constexpr BuiltinFunction floor_step = multiple<std::floor>;
constexpr BuiltinFunction ceil_whole = whole<std::ceil>;
constexpr BuiltinFunction ceil_step = multiple<std::ceil>;
constexpr BuiltinFunction round_whole = whole<std::round>;
constexpr BuiltinFunction round_step = multiple<std::round>;
constexpr BuiltinFunction trunc_whole = whole<std::trunc>;
constexpr BuiltinFunction trunc_step = multiple<std::trunc>;

Error same_real(Arguments a, Slot& r) {
  r = a[0];
  return Error::None;
}
/// Into (-180deg, 180deg].
Error wrap(Arguments a, Slot& r) {
  const double turned = std::remainder(a[0].real, 360.0);
  return store_finite(turned <= -180 ? 180 : turned, r.real);
}

/// "SII:S" taken apart.
constexpr Builtin on_texts(std::string_view name, std::string_view signature,
                           TextFunction function) {
  const std::size_t count = signature.find(':');
  return {.name = name,
          .least = count,
          .most = count,
          .rule = BuiltinRule::Texts,
          .signature = {signature.substr(0, count), signature[count + 1]},
          .text = function};
}

using pose_functions::seen_from;

/// `least`: of the arguments, where the last ones can be left out.
constexpr Builtin on_places(std::string_view name, std::string_view signature,
                            BuiltinFunction function, std::size_t least = kMostArguments) {
  Builtin builtin = on_texts(name, signature, nullptr);
  builtin.least = std::min(least, builtin.most);
  builtin.rule = BuiltinRule::Places;
  builtin.real = function;
  return builtin;
}

/// Three numbers in a row are a VEC already.
Error vector_of(Arguments /*a*/, Slot& /*r*/) { return Error::None; }
Error dot(Arguments a, Slot& r) {
  return store_finite(a[0].real * a[3].real + a[1].real * a[4].real + a[2].real * a[5].real,
                      r.real);
}
Error store_vector(double x, double y, double z, Slot& first) {
  Slot* const r = &first;
  for (const Error error :
       {store_finite(x, r[0].real), store_finite(y, r[1].real), store_finite(z, r[2].real)}) {
    if (error != Error::None) return error;
  }
  return Error::None;
}
Error cross(Arguments a, Slot& r) {
  return store_vector(a[1].real * a[5].real - a[2].real * a[4].real,
                      a[2].real * a[3].real - a[0].real * a[5].real,
                      a[0].real * a[4].real - a[1].real * a[3].real, r);
}
Error norm(Arguments a, Slot& r) {
  return store_finite(std::hypot(a[0].real, a[1].real, a[2].real), r.real);
}
/// Divided by its greatest component first: the norm of a very short VEC would lose its digits.
Error direction(Arguments a, Slot& r) {
  const double greatest =
      std::max({std::fabs(a[0].real), std::fabs(a[1].real), std::fabs(a[2].real)});
  if (greatest == 0) return Error::ZeroVector;
  const double x = a[0].real / greatest;
  const double y = a[1].real / greatest;
  const double z = a[2].real / greatest;
  const double length = std::hypot(x, y, z);
  return store_vector(x / length, y / length, z / length, r);
}
Error distance(Arguments a, Slot& r) {
  return store_finite(
      std::hypot(a[0].real - a[3].real, a[1].real - a[4].real, a[2].real - a[5].real), r.real);
}

constexpr std::array kBuiltins = std::to_array<Builtin>({
#define ROB_BUILTIN(name, least, most, rule, integer, real) \
  {#name, least, most, BuiltinRule::rule, integer, real, {}, nullptr},
#define ROB_TEXT_BUILTIN(name, signature, function) \
  on_texts(#name, signature, text_functions::function),
#define ROB_PLACE_BUILTIN(name, signature, function) \
  on_places(#name, signature, pose_functions::function),
#define ROB_PLACES_BUILTIN(name, least, signature, function) \
  on_places(#name, signature, pose_functions::function, least),
#include "lang/values/builtins.def"
});

}  // namespace

std::span<const Builtin> builtins() { return kBuiltins; }

const Builtin* find_builtin(std::string_view name, std::size_t arguments) {
  const std::string key = to_upper(name);
  const Builtin* first = nullptr;
  for (const Builtin& builtin : kBuiltins) {
    if (builtin.name != key) continue;
    if (arguments >= builtin.least && arguments <= builtin.most) return &builtin;
    if (first == nullptr) first = &builtin;
  }
  return first;
}

bool is_common_name(std::string_view name) {
  static constexpr std::array<std::string_view, 10> kNames{
      "APPEND", "CLEAR", "JOIN", "ORD", "REMOVE", "SORT", "SPLIT", "SUM", "TOOL4", "TOOLMISS"};
  return std::ranges::any_of(kNames, [&](std::string_view each) { return same_word(each, name); });
}

std::vector<std::string_view> builtin_names() {
  std::vector<std::string_view> names;
  for (const Builtin& builtin : kBuiltins) {
    if (names.empty() || names.back() != builtin.name) names.push_back(builtin.name);
  }
  return names;
}

}  // namespace rob::lang

#include "lang/syntax/named_types.h"

#include <algorithm>
#include <array>

#include "lang/text/ascii.h"

namespace rob::lang {

namespace {

constexpr auto real(Dimension dimension) { return Type{Type::Kind::Real, dimension}; }

constexpr auto kTypes = std::to_array<NamedType>({
    {"BOOL", {Type::Kind::Bool, {}}},
    {"INT", {Type::Kind::Int, {}}},
    {"REAL", real(kNone)},
    {"STRING", {Type::Kind::String, {}}},
    {"LENGTH", real(kLength)},
    {"ANGLE", real(kAngle)},
    {"TIME", real(kTime)},
    {"SPEED", real(kSpeed)},
    {"ANGULAR_SPEED", real(kAngularSpeed)},
    {"ACCELERATION", real(kAcceleration)},
    {"FORCE", real(kForce)},
    {"TORQUE", real(kTorque)},
    {"MASS", real(kMass)},
    {"FREQUENCY", real(kFrequency)},
    {"VOLTAGE", real(kVoltage)},
    {"VEC", {Type::Kind::Vec, kLength}},
    {"POSE", {Type::Kind::Pose}},
    {"JOINTS", {Type::Kind::Joints}},
    {"WRENCH", {Type::Kind::Wrench}},
    {"FRAME", {Type::Kind::Frame}},
    {"TOOL", {Type::Kind::Tool}},
});

}  // namespace

std::span<const NamedType> named_types() { return kTypes; }

const NamedType* named_type(std::string_view word) {
  const auto* const found = std::ranges::find_if(
      kTypes, [&](const NamedType& type) { return same_word(type.name, word); });
  return found == kTypes.end() ? nullptr : found;
}

}  // namespace rob::lang

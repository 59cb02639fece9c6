#include "lang/values/csv.h"

#include <string_view>

#include "lang/text/utf8.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_slots.h"
#include "lang/values/value_text.h"

namespace rob::lang {
namespace {

/// Whether a field would be read as something else without quotes. An empty line is no line.
bool needs_quotes(std::string_view text) {
  if (text.empty() || text.front() == ' ' || text.back() == ' ') return true;
  return text.find_first_of(",\"\r\n\t") != std::string_view::npos ||
         text.starts_with(kByteOrderMark);
}

/// Writes one field after the other, from slots that follow one another.
class CsvWriter {
 public:
  CsvWriter(std::string& out, const Slot* numbers, const std::string* texts, std::size_t most)
      : out_(out), numbers_(numbers), texts_(texts), most_(most) {}

  bool value(const Type& type) {
    switch (type.kind) {
      case Type::Kind::String:
        return text(*texts_++);
      case Type::Kind::Vec:
        return row(Type::real(type.dimension), 3);
      case Type::Kind::Pose:
      case Type::Kind::Frame:
        return pose(kPoseSlots);
      case Type::Kind::Tool:
        return pose(kToolSlots);
      case Type::Kind::Wrench:
        return value(Type::vec(kForce)) && value(Type::vec(kTorque));
      case Type::Kind::Joints:
        for (const Dimension axis : type.detail->axes)
          if (!value(Type::real(axis))) return false;
        return true;
      case Type::Kind::Array:
        return row(type.detail->element, type.detail->length);
      case Type::Kind::Enum: {
        const auto name = static_cast<std::size_t>((numbers_++)->integer);
        return text(type.detail->names.at(name));
      }
      case Type::Kind::Record:
        for (const TypeDetail::Field& field : type.detail->fields)
          if (!value(field.type)) return false;
        return true;
      default:
        return begin() && append_value_text(out_, type, numbers_++, nullptr, most_);
    }
  }

 private:
  bool put(std::string_view more) {
    if (out_.size() + more.size() > most_) return false;
    out_ += more;
    return true;
  }
  /// The next field.
  bool begin() {
    const bool first = first_;
    first_ = false;
    return first || put(",");
  }
  bool row(const Type& type, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i)
      if (!value(type)) return false;
    return true;
  }
  bool pose(int slots) {
    const FixedAngles angles = pose_math::to_fixed(load_pose(numbers_).rotation);
    bool fits = row(Type::real(kLength), 3);
    for (const double angle : {angles.a, angles.b, angles.c})
      fits = fits && begin() && put(si_text(angle, kAngle));
    numbers_ += slots - 3;
    return fits;
  }
  bool text(std::string_view text) {
    if (!begin()) return false;
    if (!needs_quotes(text)) return put(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return put(quoted + "\"");
  }

  std::string& out_;
  const Slot* numbers_;
  const std::string* texts_;
  std::size_t most_;
  bool first_ = true;
};

}  // namespace

bool append_csv(std::string& out, const Type& type, const Slot* numbers, const std::string* texts,
                std::size_t most) {
  return CsvWriter(out, numbers, texts, most).value(type);
}

}  // namespace rob::lang

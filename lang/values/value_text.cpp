#include "lang/values/value_text.h"

#include <string_view>

#include <fmt/format.h>

#include "lang/values/number_text.h"
#include "lang/values/pose_slots.h"

namespace rob::lang {
namespace {

/// Writes one value after the other, from slots that follow one another.
class Writer {
 public:
  Writer(std::string& out, const Slot* numbers, const std::string* texts, std::size_t most,
         EnumNames names = EnumNames::WithType)
      : out_(out), numbers_(numbers), texts_(texts), most_(most), names_(names) {}

  bool value(const Type& type) {
    switch (type.kind) {
      case Type::Kind::Bool:
        return put((numbers_++)->integer != 0 ? "TRUE" : "FALSE");
      case Type::Kind::Int:
        return put(std::to_string((numbers_++)->integer));
      case Type::Kind::Real:
        return put(number_text((numbers_++)->real, type.dimension));
      case Type::Kind::Enum:
        return enumerator(*type.detail, (numbers_++)->integer);
      case Type::Kind::String:
        return quoted(*texts_++);
      case Type::Kind::Vec:
        return put("(") && row(Type::real(type.dimension), 3) && put(")");
      case Type::Kind::Pose:
      case Type::Kind::Frame:
        return pose();
      case Type::Kind::Tool: {
        const bool fits = pose();
        numbers_ += kToolSlots - kPoseSlots;
        return fits;
      }
      case Type::Kind::Wrench:
        return put("WRENCH(") && value(Type::vec(kForce)) && put(", ") &&
               value(Type::vec(kTorque)) && put(")");
      case Type::Kind::Joints:
        return put("JOINTS(") && joints(type.detail->axes) && put(")");
      case Type::Kind::Array:
        return elements(type.detail->element, type.detail->length);
      case Type::Kind::Record:
        return record(*type.detail);
      default:
        return true;
    }
  }

  bool elements(const Type& type, std::int64_t count) {
    return put("[") && row(type, count) && put("]");
  }

 private:
  bool put(std::string_view more) {
    if (out_.size() + more.size() > most_) return false;
    out_ += more;
    return true;
  }

  bool enumerator(const TypeDetail& detail, std::int64_t value) {
    const bool alone = names_ == EnumNames::Alone;
    return put(alone ? detail.names.at(static_cast<std::size_t>(value)) : enum_text(detail, value));
  }

  bool row(const Type& type, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
      if (!put(i == 0 ? "" : ", ") || !value(type)) return false;
    }
    return true;
  }

  bool joints(const std::vector<Dimension>& axes) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (!put(i == 0 ? "" : ", ") || !value(Type::real(axes[i]))) return false;
    }
    return true;
  }

  bool record(const TypeDetail& detail) {
    if (!put(detail.name) || !put("(")) return false;
    std::string_view separator;
    for (const TypeDetail::Field& field : detail.fields) {
      if (!put(separator) || !put(field.name) || !put(": ") || !value(field.type)) return false;
      separator = ", ";
    }
    return put(")");
  }

  bool pose() {
    const FixedAngles angles = pose_math::to_fixed(load_pose(numbers_).rotation);
    bool fits = put("POSE(") && row(Type::real(kLength), 3);
    for (const double angle : {angles.a, angles.b, angles.c}) {
      fits = fits && put(", ") && put(si_text(angle, kAngle));
    }
    numbers_ += kPoseSlots - 3;
    return fits && put(")");
  }

  bool quoted(std::string_view text) {
    if (!put("\"")) return false;
    for (const char c : text) {
      if (!put(escaped(c))) return false;
    }
    return put("\"");
  }

  static std::string escaped(char c) {
    switch (c) {
      case '"':
        return "\\\"";
      case '\\':
        return "\\\\";
      case '\n':
        return "\\n";
      case '\t':
        return "\\t";
      default:  // others that no line can hold
        if (c == '\x7F' || (c >= '\0' && c < ' ')) return fmt::format("\\u{{{:X}}}", c);
        return {c};
    }
  }

  std::string& out_;
  const Slot* numbers_;
  const std::string* texts_;
  std::size_t most_;
  EnumNames names_;
};

}  // namespace

std::string text_of(bool value) { return value ? "TRUE" : "FALSE"; }

std::string enum_text(const TypeDetail& enumeration, std::int64_t value) {
  return enumeration.name + "." + enumeration.names[static_cast<std::size_t>(value)];
}

bool append_part_text(std::string& out, const Type& type, const Slot* numbers,
                      const std::string* texts, std::size_t most, EnumNames names) {
  return Writer(out, numbers, texts, most, names).value(type);
}

bool append_row_text(std::string& out, const Type& element, std::size_t count, const Slot* numbers,
                     const std::string* texts, std::size_t most, EnumNames names) {
  return Writer(out, numbers, texts, most, names)
      .elements(element, static_cast<std::int64_t>(count));
}

bool append_value_text(std::string& out, const Type& type, const Slot* numbers,
                       const std::string* texts, std::size_t most) {
  if (!type.is(Type::Kind::String)) return Writer(out, numbers, texts, most).value(type);
  if (out.size() + texts->size() > most) return false;
  out += *texts;
  return true;
}

}  // namespace rob::lang

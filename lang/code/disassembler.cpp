#include "lang/code/disassembler.h"

#include <algorithm>
#include <bit>
#include <string_view>

#include <fmt/core.h>

#include "lang/values/builtins.h"
#include "lang/values/number_text.h"
#include "lang/values/types.h"

namespace rob::lang {
namespace {

/// One instruction's text: operands, and remarks on what they mean.
class Line {
 public:
  Line(const Chunk& chunk, std::size_t offset) : chunk_(chunk), offset_(offset) {
    unsigned field = 0;
    for (const char kind : info(instruction().opcode()).operands) {
      operand(kind, field);
      ++field;
    }
  }

  /// Words that the instruction takes.
  std::size_t words() const { return words_; }
  std::string text() const {
    std::string line = fmt::format("{:<18} {}", info(instruction().opcode()).name, operands_);
    while (line.back() == ' ') line.pop_back();
    if (!remarks_.empty()) line = fmt::format("{:<38} // {}", line, remarks_);
    return line + '\n';
  }

 private:
  Instruction instruction() const { return chunk_.code[offset_]; }
  std::uint32_t next_word() { return chunk_.code[offset_ + words_++].word; }
  unsigned byte(unsigned field) const { return instruction().word >> (8 * (field + 1)) & 0xff; }

  void operand(char kind, unsigned field);
  void add(std::string_view letter, std::size_t number) {
    operands_ += fmt::format("{}{} ", letter, number);
  }
  void remark(std::string_view text) {
    if (!remarks_.empty()) remarks_ += ", ";
    remarks_ += text;
  }
  void add_register(bool text, unsigned index);
  void add_constant(std::size_t index);
  void add_move(std::size_t index);
  void add_components(const MoveForm& form);
  void add_watch(std::size_t index);
  bool in_watch() const;

  const Chunk& chunk_;
  std::size_t offset_;
  std::size_t words_ = 1;
  std::string operands_;
  std::string remarks_;
};

void Line::operand(char kind, unsigned field) {
  switch (kind) {
    case 'r':
      return add_register(false, byte(field));
    case 's':
      return add_register(true, byte(field));
    case 'b':
      operands_ += byte(field) != 0 ? "TRUE " : "FALSE ";
      return;
    case 'q':
      operands_ += fmt::format("{} ", name_of(static_cast<Reading>(byte(field))));
      return;
    case 'n':
      add("", byte(field));
      return;
    case 'd':
      add("d", byte(field));
      return remark(in_words(chunk_.dimensions[byte(field)]));
    case 'f':
      add("f", byte(field));
      return remark(builtins()[byte(field)].name);
    case 'i':
      operands_ += fmt::format("{} ", instruction().signed_x());
      return;
    case 'k':
      return add_constant(instruction().x());
    case 'c':
      return add_constant(byte(field));
    case 'g':
      add("g", instruction().x());
      return remark(chunk_.signals[instruction().x()]);
    case 'w':
      return add_watch(instruction().x());
    case 'm':
      return add_move(instruction().x());
    case 'j':
      // As an offset: that is what can be found in the listing.
      operands_ +=
          fmt::format("-> {}", static_cast<std::int64_t>(offset_) + 1 + instruction().distance());
      return;
    case 'G':
    case 'H':
      add(kind == 'G' ? "r" : "s", instruction().x());
      return remark("of the top level");
    case 'P':
      return add_register(false, next_word());
    case 'R': {
      const std::uint32_t routine = next_word();
      add("p", routine);
      return remark(chunk_.routines[routine].name);
    }
    case 'K':
      return add_constant(next_word());
    case 'T': {
      const std::uint32_t text = next_word();
      add("t", text);
      return remark(fmt::format("\"{}\"", chunk_.texts[text]));
    }
    case 'L':
    case 'W':
      return add(kind == 'L' ? "of " : "+", next_word());
    case 'N':
      return add("", next_word());
    case 'D':
      return add_components(chunk_.moves[instruction().x()]);
    case 'V':
      return remark(in_words(chunk_.types[next_word()]));
    default:  // 'J': the jump that follows is listed on a line of its own
      return;
  }
}

void Line::add_register(bool text, unsigned index) {
  add(text ? "s" : "r", index);
  if (in_watch()) return;
  for (const NamedRegister& name : chunk_.names) {
    if (name.index == index && name.text == text && offset_ >= name.from && offset_ < name.to) {
      operands_.pop_back();
      operands_ += fmt::format("({}) ", name.name);
      return;
    }
  }
}

/// The registers of a watch are its own.
bool Line::in_watch() const {
  return std::ranges::any_of(chunk_.watches, [&](const WatchForm& watch) {
    return offset_ >= watch.entry && offset_ < watch.end;
  });
}

void Line::add_watch(std::size_t index) {
  add("w", index);
  remark(fmt::format("code from {} on", chunk_.watches[index].entry));
}

void Line::add_constant(std::size_t index) {
  add("k", index);
  const Slot value = chunk_.constants[index];
  const Type& type = chunk_.constant_types[index];
  if (type.kind == Type::Kind::Bool) return remark(value.integer != 0 ? "TRUE" : "FALSE");
  remark(type.kind == Type::Kind::Int ? std::to_string(value.integer)
                                      : number_text(value.real, type.dimension));
}

void Line::add_move(std::size_t index) {
  const MoveForm& form = chunk_.moves[index];
  add("m", index);
  if (form.kind != MotionKind::Joint) remark(std::string(word_of(form.kind)));
  if (form.means == MoveCommand::Target::Axes) remark("JOINT");
  if (form.means == MoveCommand::Target::Pose) remark("POSE");
  if (form.in_frame) remark("IN the frame");
  if (form.kind == MotionKind::Jog) {
    remark(std::string(kJogWords[static_cast<std::size_t>(form.jog)]));
  }
  if (form.relative) remark("BY");
  std::string target = "(";
  for (int i = 0; i < form.count && !form.computed_axis; ++i) {
    if (i > 0) target += ", ";
    target += (form.given >> i & 1) != 0 ? "given" : "-";
  }
  remark(form.computed_axis ? "(axis, given)" : target + ")");
  if (form.pace != MoveCommand::Pace::Unspecified) remark("AT");
  if (form.over) remark("OVER");
  if (form.accel != MoveCommand::Bound::Unspecified) remark("ACCEL");
  if (form.jerk != MoveCommand::Bound::Unspecified) remark("JERK");
  if (form.zone != MoveCommand::Zone::Unspecified) remark(form.zone_angle ? "ZONE, angle" : "ZONE");
  if (form.lasts) remark("FOR");
  if (form.fine) remark(form.fine_within ? "FINE, distance" : "FINE");
  if (form.euler) remark("EULER");
  if (form.free != FreeTurn::None) {
    remark(fmt::format("FREE {}", kFreeWords[static_cast<std::size_t>(form.free) - 1]));
  }
  if (form.near > 0) remark("NEAR");
  if (form.profile != Profile::Unspecified) remark("PROFILE");
}

void Line::add_components(const MoveForm& form) {
  std::string values;
  for (int i = plain_values(form); i > 0; --i, words_ += 2) {
    values += fmt::format("{}{}", values.empty() ? "" : " ",
                          number_text(real_at(&chunk_.code[offset_ + words_]), kNone));
  }
  remark(fmt::format("SI: {}", values));
}

/// "5", or "2:5" of the second file that is USEd.
std::string line_text(const Place& place) {
  return place.file == 0 ? std::to_string(place.line)
                         : fmt::format("{}:{}", place.file, place.line);
}

}  // namespace

std::string disassemble(const Chunk& chunk) {
  std::string listing;
  int last_line = 0;
  for (std::size_t offset = 0; offset < chunk.code.size();) {
    const auto begins = [&](const RoutineCode& routine) { return routine.entry == offset; };
    if (const auto routine = std::ranges::find_if(chunk.routines, begins);
        routine != chunk.routines.end()) {
      listing += fmt::format("{}\n", routine->name);
    }
    const Line line(chunk, offset);
    const int source = line_tag(chunk.places[offset]);
    listing += fmt::format("{:>6} {:>5}  ", offset,
                           source == last_line ? std::string() : line_text(chunk.places[offset]));
    listing += line.text();
    last_line = source;
    offset += line.words();
  }
  return listing;
}

}  // namespace rob::lang

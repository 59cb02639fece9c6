#include "runtime/command/file_desk.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "lang/text/codes.h"

namespace rob::runtime {

using lang::Reply;

namespace {

Words no_files() {
  return {std::string(lang::code::kMachineWithout), "there are no files here",
          "run the program with rob run"};
}

}  // namespace

std::optional<Words> objection_to_line(DataFiles* files, std::string_view file,
                                       std::string_view text) {
  if (files == nullptr) return no_files();
  if (text.size() > DataFiles::kLongestLine)
    return Words{std::string(lang::code::kFileFailed),
                 fmt::format("a line of {} bytes is too long for a file", text.size()),
                 fmt::format("it has {} bytes at most", DataFiles::kLongestLine)};
  return files->admit(std::string(file));
}

Note note_of(std::size_t variable, std::string_view value) {
  Note note{Note::Kind::Persist, std::string(value)};
  note.variable = variable;
  return note;
}

Reply FileDesk::write(int line, std::string_view file, std::string_view text) {
  if (effects_.full()) return Reply::Later;
  if (auto why = objection_to_line(files_, file, text)) return links_.refuse(std::move(*why));
  Note note{Note::Kind::Write, std::string(text)};
  note.file = file;
  return effects_.note(line, std::move(note));
}

Reply FileDesk::persist(int line, std::size_t variable, std::string_view value) {
  if (queue_.full()) return Reply::Later;
  const Reply reply = queue_.push({.tag = static_cast<motion::Tag>(line),
                                   .kind = motion::Effect::Kind::Note,
                                   .id = links_.log.keep(note_of(variable, value))});
  if (reply == Reply::Done) links_.log.queued_effect();
  return reply;
}

Reply FileDesk::read(int line, std::string_view file, std::string& text) {
  if (files_ == nullptr) return links_.refuse(no_files());
  double now = 0;
  if (waits_.stand(line, now) != Reply::Done || !progress_.settled()) return Reply::Later;
  if (links_.buffer.full() || !files_->reported()) return Reply::Later;
  std::optional<Words> why;
  auto read = files_->read(std::string(file), why);
  waits_.waited(line);
  if (why) return links_.refuse(std::move(*why));
  text = std::move(*read);
  return Reply::Done;
}

/// In a corner what was written before may act later; at standstill it has acted.
Reply FileDesk::exists(std::string_view file, bool& value) {
  if (!progress_.observable()) return Reply::Later;
  value = false;
  if (files_ == nullptr) return Reply::Done;
  if (progress_.stands() && !files_->reported()) return Reply::Later;
  value = files_->exists(std::string(file));
  return Reply::Done;
}

}  // namespace rob::runtime

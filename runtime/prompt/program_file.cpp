#include "runtime/prompt/program_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "lang/text/source_text.h"
#include "runtime/files/atomic_file.h"
#include "runtime/files/files.h"

namespace rob::runtime {

namespace {

bool is_there(const std::string& file) {
  std::error_code ignored;  // what cannot be looked at is refused when it is written
  return std::filesystem::exists(file, ignored);
}

}  // namespace

std::string ProgramFile::load(const std::string& file) {
  content_ = read_file(file, lang::kMaxSourceBytes);
  name_ = file;
  return content_;
}

void ProgramFile::refuse_overwriting(const std::string& file) const {
  if (!is_there(file)) return;
  if (file != name_)
    throw FileError(
        fmt::format("'{0}' is there already; :save! {0} replaces it, its content goes into the"
                    " archive",
                    file));
  if (read_file(file, lang::kMaxSourceBytes) != content_)
    throw FileError(fmt::format(
        "'{0}' has been changed by another program; :save! {0} replaces it all the same", file));
}

/// The version before is safe when the new one takes its place.
void ProgramFile::save(const std::string& file, std::string_view text, bool replace) {
  if (!replace) refuse_overwriting(file);
  archive_.keep(file);
  save_file(file, text);
  name_ = file;
  content_ = text;
}

void ProgramFile::close() {
  name_.clear();
  content_.clear();
}

}  // namespace rob::runtime

#include "runtime/run/program_stores.h"

#include <utility>

#include "runtime/run/run_parts.h"

namespace rob::runtime {

ProgramStores::ProgramStores(const LoadedProgram& program, const std::string& data, bool real)
    : files_(data_folder_of(program, data), DataFiles::Keeps::OnDisk, !real),
      devices_(program.compilation.chunk->devices) {
  if (real) devices_.connect();
  if (program.compilation.chunk->persists.empty()) return;
  values_ = std::make_unique<KeptValues>(values_file_of(program.file), kept_variables(program),
                                         KeptValues::For::Run);
  warnings_ = values_->warnings();
}

void ProgramStores::take(const Note& note, double time) {
  hand_over(note, time, files_, devices_);
  if (note.kind == Note::Kind::Persist && values_) values_->set(note.variable, note.text);
}

std::vector<std::string> ProgramStores::take_events(TextDevices::Telling telling) {
  std::vector<std::string> events = std::exchange(warnings_, {});
  for (std::string& event : devices_.take_events(telling)) events.push_back(std::move(event));
  return events;
}

std::vector<std::string> ProgramStores::finish() {
  std::vector<std::string> failures;
  if (auto why = files_.finish()) failures.push_back(std::move(why->message));
  if (!values_) return failures;
  if (std::string why = values_->finish(); !why.empty()) failures.push_back(std::move(why));
  return failures;
}

}  // namespace rob::runtime

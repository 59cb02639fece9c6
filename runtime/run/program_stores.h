#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/devices/text_devices.h"
#include "runtime/files/data_files.h"
#include "runtime/files/kept_values.h"
#include "runtime/run/load.h"

namespace rob::runtime {

/// All that a run of a program has outside of the robot: its files, its devices, and its PERSIST
/// variables, locked. The thread that reports calls everything.
class ProgramStores {
 public:
  /// `data`: where its files are; empty: beside it. `real`: its devices are connected, too. Throws
  /// FileError, motion::DriverError.
  ProgramStores(const LoadedProgram& program, const std::string& data, bool real);

  DataFiles& files() { return files_; }
  TextDevices& devices() { return devices_; }
  /// The values that earlier runs have left; null where no variable is kept.
  const lang::SavedValues* saved() const { return values_ ? &values_->saved() : nullptr; }

  /// Something that the program has written, sent or kept, when its turn has come; s of the run.
  void take(const Note& note, double time);
  /// All that had come up to now has been taken.
  void drained() { files_.drained(); }
  /// For people: what is in vain in a file of values, and what devices have sent in vain.
  std::vector<std::string> take_events(TextDevices::Telling telling = TextDevices::Telling::Seldom);
  /// The run is over. Says what could not be kept, each in a line.
  std::vector<std::string> finish();

 private:
  DataFiles files_;
  TextDevices devices_;
  std::unique_ptr<KeptValues> values_;
  std::vector<std::string> warnings_;
};

}  // namespace rob::runtime

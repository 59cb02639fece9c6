#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lang/compile/compile.h"
#include "lang/compile/entries.h"
#include "motion/robots/robot_model.h"
#include "runtime/files/signal_script.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// A program that has been read and compiled for a robot; `compilation` has all its errors.
/// `robot` is under the law that the program runs under.
struct LoadedProgram {
  std::string file;
  std::string source;  ///< empty while it is put away
  motion::RobotModel robot;
  lang::Compilation compilation;
  std::vector<motion::Obstacle> obstacles{};  ///< that it declares; `robot` has them, too
  std::optional<std::uint64_t> put_away{};    ///< the hash of the text that is

  bool runnable() const { return compilation.chunk.has_value(); }
};

/// Gives the memory of a long text back once the program is compiled: only messages need it.
void put_source_away(LoadedProgram& program);
/// The text for messages that show these lines, counted from 1. Where it is put away it is read
/// anew, the other lines empty; and nothing if its file is not what it was any more.
std::string source_lines(const LoadedProgram& program, const std::set<std::uint32_t>& shown);

/// The names of the files that it USEs, by lang::Place::file from 1.
std::vector<std::string> used_names(const LoadedProgram& program);
/// Gives a problem the names of the files that it refers to.
void place_in(const LoadedProgram& program, Problem& problem);

/// A robot by its name, or by its file if that ends in ".toml". Throws motion::RobotFileError for
/// an unknown name or a faulty file, FileError for one that cannot be read. `cell`: a file of what
/// stands around it; empty: none.
motion::RobotModel load_robot(const std::string& name_or_file, const std::string& cell = "");

/// Reads (`file` may be kStandardInput) and compiles for the robot that is asked for (a name, a
/// file, or empty), or that ROBOT in the program names, or the gantry. Where two differ that is an
/// error of the program. Throws as load_robot() does for what is asked for. `law`: under which it
/// runs, whatever LAW in the program and the robot file say; of these two LAW counts.
LoadedProgram load_program(const std::string& file, const std::string& asked,
                           std::optional<motion::Law> law = {}, const std::string& cell = "");

/// The same from text: `file` is for messages, and says where the files are that it USEs.
/// `points_file`: where its points are; empty for a program without any.
LoadedProgram compile_program(std::string file, std::string source, const std::string& asked,
                              const std::string& points_file = "",
                              std::optional<motion::Law> law = {}, const std::string& cell = "");

/// Compiles for this robot, whatever the text says; checks the targets that are known beforehand
/// against the robot, so that nothing moves if one of them cannot be reached. `from`: as of
/// lang::compile().
LoadedProgram compile_program(std::string file, std::string source, const motion::RobotModel& robot,
                              const std::string& points_file = "",
                              std::optional<motion::Law> law = {}, std::uint32_t from = 0);

/// The same of an entry of a prompt, which runs under the law of its robot; `signature`: that of
/// the robot, which takes longer to make than most entries to compile.
LoadedProgram compile_entry(const lang::Entries& entries, std::string entry,
                            const motion::RobotModel& robot, const lang::RobotSignature& signature,
                            const std::string& points_file, const lang::Sources& sources,
                            lang::Entries::Knowing knowing, lang::Entries::As as);

/// Refuses a program that needs points which nobody has taught: for what moves or tests.
void refuse_missing_points(LoadedProgram& program);

/// Refuses a program for an arm that asks for what the arm's law of motion has not: for what moves,
/// foretells or tests. (Other robots refuse it when the program is compiled.)
void refuse_what_an_arm_cannot(LoadedProgram& program);

/// The signal script of a program; `file` empty: one without rules. Throws FileError.
SignalScript load_signal_script(const std::string& file, const LoadedProgram& program);

}  // namespace rob::runtime

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lang/vm/task_memory.h"
#include "lang/vm/vm.h"
#include "runtime/command/task_machine.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// The TASKs of a program: those that run, what they share with it, and what of the program is on
/// its way to them in motion order. The program's thread calls everything.
///
/// START and new values of globals travel as effects (Effect::Kind::Report): keep() gives them
/// a number, motion hands it back when their turn has come, take_due() carries them out.
class BackgroundTasks {
 public:
  /// Instructions that a TASK is given in a cycle.
  static constexpr std::int64_t kInstructions = 10'000;
  /// The bytes that LISTs on their way may take. [choice] as much as those of the program; when it
  /// is reached, the program waits.
  static constexpr std::size_t kMostOfLists = lang::kMostListBytes;

  using Code = std::shared_ptr<const lang::Chunk>;

  /// `seed`: of RANDOM; each TASK draws numbers of its own.
  BackgroundTasks(const lang::Chunk& chunk, const TaskSide& side, std::uint64_t seed);
  /// For the entries of a prompt, of which go_on_with() gives one after another.
  BackgroundTasks(const TaskSide& side, std::uint64_t seed);
  /// TASKs are those of this entry from here on. One that runs goes on, unless the entry declares
  /// it anew, or what it uses: then take_outdated() names it.
  void go_on_with(Code entry);
  std::vector<std::string> take_outdated() { return std::exchange(outdated_, {}); }

  /// START of a TASK, by its number in the code of the program or the entry.
  struct Start {
    std::uint32_t task;
    lang::Place place;
    Code code{};
  };
  template <typename Value>
  struct Store {
    std::size_t first;
    std::vector<Value> values;
  };
  /// A LIST, by the place of its slot, with all its elements.
  struct StoreList {
    std::size_t home;
    lang::Slots size;
    std::size_t count;
    std::vector<lang::Slot> numbers;
    std::vector<std::string> texts;
  };
  using Due = std::variant<Start, Store<lang::Slot>, Store<std::string>, StoreList>;
  std::uint32_t keep(Due due);
  bool was_started(std::uint32_t task) const { return started_.contains(identity(task)); }
  /// Whether it runs, or its START is on its way.
  bool busy(std::uint32_t task) const;
  lang::Refusal runs_already(std::uint32_t task) const;
  /// Whether motion can be given a further one.
  bool full() const {
    return kept_.size() >= Channels::kReports || bytes_of_lists_ >= kMostOfLists;
  }

  /// Carries out what is due.
  void take_due();
  lang::TaskMemory& memory() { return memory_; }
  /// One cycle of each that runs, in the order of their START.
  void run_cycle();
  void stop() { running_.clear(); }
  /// Whether the program has any.
  bool any() const { return !code_->tasks.empty() || !running_.empty(); }
  /// The error that has ended one of them; it is returned once.
  std::optional<lang::RuntimeError> take_error();

 private:
  struct Running {
    Code code;
    std::uint32_t task;
    std::size_t stack;  ///< its number in the memory
    int line;           ///< of its START
    std::unique_ptr<TaskMachine> machine;
    std::unique_ptr<lang::Vm> vm;
  };

  /// A TASK is known by its place, also where entries have it in codes of their own.
  static int identity(const lang::Chunk& code, std::uint32_t task) {
    return lang::line_tag(code.tasks[task].place);
  }
  int identity(std::uint32_t task) const { return identity(*code_, task); }
  bool declared_anew(const lang::Chunk& code, std::uint32_t task) const;
  void end_outdated(const lang::TaskCode& task);
  std::size_t free_stack() const;
  void carry_out(const Start& start);
  template <typename Value>
  void carry_out(const Store<Value>& store) {
    memory_.store(store.first, std::span<const Value>(store.values));
  }
  void carry_out(const StoreList& store);
  void fail(lang::RuntimeError error);

  Code code_;
  const TaskSide side_;
  Channels& channels_;
  std::uint64_t seed_;
  lang::TaskMemory memory_;
  std::vector<Running> running_;  ///< in the order of their START
  std::map<std::uint32_t, Due> kept_;
  std::size_t bytes_of_lists_ = 0;
  std::uint32_t next_ = 0;
  std::set<int> started_;              ///< identities
  std::vector<std::string> outdated_;  ///< names of those that have ended for that
  std::optional<lang::RuntimeError> error_;
};

}  // namespace rob::runtime

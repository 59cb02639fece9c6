#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
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
  /// What LISTs on their way may take, in bytes. [choice] as much as those of the program; when it
  /// is reached, the program waits.
  static constexpr std::size_t kMostOfLists = lang::kMostListBytes;

  /// `seed`: of RANDOM; each TASK draws numbers of its own.
  BackgroundTasks(const lang::Chunk& chunk, const TaskSide& side, std::uint64_t seed);

  /// START of a TASK, by its number.
  struct Start {
    std::uint32_t task;
    lang::Place place;
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
  bool was_started(std::uint32_t task) const { return started_.contains(task); }
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
  bool any() const { return !chunk_.tasks.empty(); }
  /// The error that has ended one of them; it is returned once.
  std::optional<lang::RuntimeError> take_error();

 private:
  struct Running {
    std::uint32_t task;
    int line;  ///< of its START
    std::unique_ptr<TaskMachine> machine;
    std::unique_ptr<lang::Vm> vm;
  };

  void carry_out(const Start& start);
  template <typename Value>
  void carry_out(const Store<Value>& store) {
    memory_.store(store.first, std::span<const Value>(store.values));
  }
  void carry_out(const StoreList& store);
  void fail(lang::RuntimeError error);

  const lang::Chunk& chunk_;
  const TaskSide side_;
  Channels& channels_;
  std::uint64_t seed_;
  lang::TaskMemory memory_;
  std::vector<Running> running_;  ///< in the order of their START
  std::map<std::uint32_t, Due> kept_;
  std::size_t bytes_of_lists_ = 0;
  std::uint32_t next_ = 0;
  std::set<std::uint32_t> started_;
  std::optional<lang::RuntimeError> error_;
};

}  // namespace rob::runtime

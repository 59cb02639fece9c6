// Holds that each channel between the tasks of a run has one writer: only so does no tick wait for
// another, and no value is lost because two write it at a time.

#include "tests/support/channel_writers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/source_files.h"

using rob::test::channel_writers;
using rob::test::ChannelWriters;
using rob::test::SourceFile;

namespace {

using Tasks = std::set<std::string>;

/// The task in whose thread a module writes channels, by the longest part of its path that is
/// listed. What is set up before the tasks begin may be written by others later.
const std::map<std::string, std::string, std::less<>>& tasks_of_modules() {
  static const std::map<std::string, std::string, std::less<>> tasks = {
      {"runtime/tick/", "motion"},
      {"runtime/tick/servo_task", "servo"},
      {"runtime/command/", "program"},
      {"runtime/run/controller", "set-up"},
      {"runtime/run/foretell", "set-up"},
      {"runtime/run/test_runner", "set-up"},
      {"runtime/run/run", "set-up"},
      {"runtime/run/run_parts", "set-up"},
      {"runtime/run/run_stepped", "program"},  // one thread for all, which lets the program write
      {"runtime/prompt/", "main"},
  };
  return tasks;
}

/// The channels that still have two writers. None may be added.
const std::map<std::string, Tasks>& still_shared() {
  static const std::map<std::string, Tasks> shared = {
      {"analog_inputs.cells_", {"motion", "servo"}}, {"inputs", {"motion", "servo"}},
      {"press.over", {"motion", "program"}},         {"press.state", {"motion", "program"}},
      {"stop_requested", {"main", "program"}},       {"way_back.under_way", {"main", "motion"}},
  };
  return shared;
}

/// StopRequests: any thread may ask a robot to stop, and nobody takes that back.
bool may_be_shared(std::string_view channel) { return channel.starts_with("stop."); }

const ChannelWriters& writers() {
  static const ChannelWriters found =
      channel_writers(rob::test::sources_in({"runtime"}), "Channels");
  return found;
}

/// Empty if it is not known.
std::string task_of(const std::string& module) {
  std::string task;
  std::size_t longest = 0;
  for (const auto& [part, its_task] : tasks_of_modules()) {
    if (part.size() > longest && module.starts_with(part)) {
      task = its_task;
      longest = part.size();
    }
  }
  return task;
}

Tasks tasks_of(const std::set<std::string>& modules) {
  Tasks tasks;
  for (const std::string& module : modules) {
    const std::string task = task_of(module);
    CHECK_MESSAGE(!task.empty(), "which task is it in which " << module << " writes a channel?");
    if (!task.empty() && task != "set-up") tasks.insert(task);
  }
  return tasks;
}

std::string in_one_line(const Tasks& tasks) {
  std::string line;
  for (const std::string& task : tasks) line += " " + task;
  return line;
}

/// "motion" of "///< motion → servo", by the member that the comment is about.
std::map<std::string, std::string> promised_writers(const std::string& header) {
  static const std::regex member(R"((\w+)(\{.*\})?;\s*///<\s*(\w+) → \w+)");
  std::map<std::string, std::string> promised;
  std::istringstream lines(header);
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, found, member)) promised[found[1]] = found[3];
  }
  return promised;
}

std::string header_of_channels() {
  for (const SourceFile& file : rob::test::sources_in({"runtime"})) {
    if (file.path.ends_with("/channels.h")) return file.text;
  }
  throw std::runtime_error("there is no channels.h");
}

/// The writers of a Root, by one line of a function that gets it.
ChannelWriters writers_by(const std::string& line) {
  const std::string root = R"(
    struct Part { std::atomic<int> x{0}; int y = 0; };
    class Desk {
     public:
      void give(int n) { n_.store(n); note(); }
      void note() { ++told_; }
      int take() { return n_.exchange(0); }
      int look() const { return n_.load() + told_; }
      void forget();
     private:
      std::atomic<int> n_{0};
      int told_ = 0;
    };
    struct Root {
      std::atomic<int> a{0};
      motion::SpscRing<Part> ring{16};
      Part first, second;
      Desk desk;
      Part* other = nullptr;
    };)";
  return channel_writers({{"root.h", root}, {"it.cpp", "void f(Root& root) { " + line + " }"}},
                         "Root");
}

std::set<std::string> written_by(const std::string& line) {
  std::set<std::string> written;
  for (const auto& [channel, modules] : writers_by(line)) {
    if (modules == std::set<std::string>{"it"}) written.insert(channel);
  }
  return written;
}

}  // namespace

TEST_CASE("each channel is written by one task") {
  CHECK(writers().size() > 40);
  for (const auto& written : writers()) {
    const std::string& channel = written.first;
    if (may_be_shared(channel)) continue;
    const Tasks tasks = tasks_of(written.second);
    const auto listed = still_shared().find(channel);
    if (listed == still_shared().end()) {
      CHECK_MESSAGE(tasks.size() <= 1, channel << " is written by" << in_one_line(tasks));
    } else {
      CHECK_MESSAGE(tasks == listed->second,
                    "mend the list: " << channel << " is written by" << in_one_line(tasks));
    }
  }
  for (const auto& shared : still_shared()) {
    CHECK_MESSAGE(writers().contains(shared.first), "there is no channel " << shared.first);
  }
}

TEST_CASE("each channel is written by the task that its comment names") {
  const std::map<std::string, std::string> promised = promised_writers(header_of_channels());
  CHECK(promised.size() > 10);
  for (const auto& promise : promised) {
    const std::string& channel = promise.first;
    const std::string& task = promise.second;
    const auto found = writers().find(channel);
    if (found == writers().end() || still_shared().contains(channel)) continue;
    CHECK_MESSAGE(tasks_of(found->second) == Tasks{task}, channel << " is not written by " << task);
  }
}

TEST_CASE("what writes a channel is found") {
  CHECK(written_by("root.a.store(1);") == std::set<std::string>{"a"});
  CHECK(written_by("root.a = 1;") == std::set<std::string>{"a"});
  CHECK(written_by("*root.ring.slot() = {}; root.ring.push();") == std::set<std::string>{"ring"});
  CHECK(written_by("root.second.y += 2;") == std::set<std::string>{"second.y"});
  CHECK(written_by("++root.first.y;") == std::set<std::string>{"first.y"});
  CHECK(written_by("root.other->x.store(1);").empty());  // not held
  CHECK(written_by("root.first = {};") == std::set<std::string>{"first.x", "first.y"});
}

TEST_CASE("what reads or takes from a channel does not write it") {
  CHECK(written_by("return root.a.load() + root.first.y;").empty());
  CHECK(written_by("if (root.first.y == 2 && root.second.x <= 3) return;").empty());
  CHECK(written_by("Part part; root.ring.take(part); root.ring.pop();").empty());
  CHECK(written_by("if (root.a.exchange(0) != 0) root.desk.take();").empty());
}

TEST_CASE("a call writes what the method and those that it calls write") {
  CHECK(written_by("root.desk.give(1);") == std::set<std::string>{"desk.n_", "desk.told_"});
  CHECK(written_by("root.desk.note();") == std::set<std::string>{"desk.told_"});
  CHECK(written_by("return root.desk.look();").empty());
  CHECK_THROWS_AS(written_by("root.desk.forget();"), std::runtime_error);  // it has no body there
}

TEST_CASE("a channel is found under other names") {
  CHECK(written_by("Part& part = root.second; part.x.store(1);") ==
        std::set<std::string>{"second.x"});
  CHECK(written_by("auto& x = this->of(1).root.first.x; x.fetch_add(1);") ==
        std::set<std::string>{"first.x"});
  // By its class alone it may be each of them.
  CHECK(written_by("struct A { Part& part; }; a.part.y = 1;") ==
        std::set<std::string>{"first.y", "second.y"});
  CHECK(written_by("} Root& root(); void g() { x->root().desk.note();") ==
        std::set<std::string>{"desk.told_"});
}

TEST_CASE("every channel has an entry, and the root must be one class") {
  CHECK(writers_by("").size() == 9);
  CHECK_THROWS_AS(channel_writers({{"a.h", "struct A {};"}}, "Root"), std::runtime_error);
  CHECK_THROWS_AS(channel_writers({{"a.h", "struct A {};"}, {"b.h", "struct A {};"}}, "A"),
                  std::runtime_error);
}

TEST_CASE("the promised writer is read out of a comment") {
  CHECK(promised_writers("  std::atomic<int> a{0};  ///< motion → servo: so\n"
                         "  B b;  ///< any thread → c\n  C c;\n  D d;  ///< main → motion\n") ==
        std::map<std::string, std::string>{{"a", "motion"}, {"d", "main"}});
}

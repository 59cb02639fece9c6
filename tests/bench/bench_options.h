#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace rob::bench {

/// The options of a benchmark. Each `add` names an option and the variable that takes its value;
/// what the variable holds before is the default, which --help shows. One file includes CLI11,
/// which takes long to compile.
class BenchOptions {
 public:
  explicit BenchOptions(const std::string& title);
  ~BenchOptions();

  void add(const std::string& name, std::string& value, const std::string& help = "");
  void add(const std::string& name, int& value, const std::string& help = "");
  void add(const std::string& name, int& value, int least, int most, const std::string& help = "");
  void add(const std::string& name, std::uint64_t& value, const std::string& help = "");
  void add(const std::string& name, double& value, const std::string& help = "");
  void add(const std::string& name, double& value, double least, double most,
           const std::string& help = "");
  void add_flag(const std::string& name, bool& value, const std::string& help);

  /// The exit code with which the program ends at once: after --help, or after a mistake, which
  /// it has printed.
  std::optional<int> parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace rob::bench

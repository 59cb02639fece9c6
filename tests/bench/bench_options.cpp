#include "tests/bench/bench_options.h"

#include <CLI/CLI.hpp>

namespace rob::bench {

BenchOptions::BenchOptions(const std::string& title) : app_(std::make_unique<CLI::App>(title)) {}

BenchOptions::~BenchOptions() = default;

void BenchOptions::add(const std::string& name, std::string& value, const std::string& help) {
  app_->add_option(name, value, help)->capture_default_str();
}

void BenchOptions::add(const std::string& name, int& value, const std::string& help) {
  app_->add_option(name, value, help)->capture_default_str();
}

void BenchOptions::add(const std::string& name, int& value, int least, int most,
                       const std::string& help) {
  app_->add_option(name, value, help)->check(CLI::Range(least, most))->capture_default_str();
}

void BenchOptions::add(const std::string& name, std::uint64_t& value, const std::string& help) {
  app_->add_option(name, value, help)->capture_default_str();
}

void BenchOptions::add(const std::string& name, double& value, const std::string& help) {
  app_->add_option(name, value, help)->capture_default_str();
}

void BenchOptions::add(const std::string& name, double& value, double least, double most,
                       const std::string& help) {
  app_->add_option(name, value, help)->check(CLI::Range(least, most))->capture_default_str();
}

void BenchOptions::add_flag(const std::string& name, bool& value, const std::string& help) {
  app_->add_flag(name, value, help);
}

std::optional<int> BenchOptions::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return app_->exit(error);
  }
}

}  // namespace rob::bench

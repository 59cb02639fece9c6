#include "tests/support/include_circles.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace rob::test {

namespace {

using Included = std::map<std::string, std::set<std::string>>;

Included modules_of(const std::vector<SourceFile>& files) {
  Included modules;
  for (const SourceFile& file : files) {
    std::set<std::string>& included = modules[module_of(file.path)];
    for (const Include& include : includes_of(file.text)) {
      if (!include.angled) included.insert(module_of(include.path));
    }
  }
  return modules;
}

/// Tarjan's search for strongly connected components.
class CircleSearch {
 public:
  explicit CircleSearch(const Included& modules) : modules_(modules) {}

  std::vector<std::vector<std::string>> all() {
    for (const auto& [module, included] : modules_) {
      if (!states_.contains(module)) visit(module);
    }
    std::ranges::sort(found_);
    return std::move(found_);
  }

 private:
  struct State {
    std::size_t number = 0;    ///< in the order of the visits
    std::size_t earliest = 0;  ///< module in reach that is still open
    bool open = true;          ///< its component is not complete
  };

  State& visit(const std::string& module) {
    const std::size_t number = states_.size();
    State& state = states_[module];
    state = {number, number, true};
    open_.push_back(module);
    if (const auto found = modules_.find(module); found != modules_.end()) {
      for (const std::string& included : found->second) {
        const auto known = states_.find(included);
        const State& other = known == states_.end() ? visit(included) : known->second;
        if (other.open) state.earliest = std::min(state.earliest, other.earliest);
      }
    }
    if (state.earliest == state.number) close(module);
    return state;
  }
  void close(const std::string& first) {
    const auto begin = std::ranges::find(open_, first);
    std::vector<std::string> component(begin, open_.end());
    open_.erase(begin, open_.end());
    for (const std::string& module : component) states_[module].open = false;
    if (component.size() < 2) return;
    std::ranges::sort(component);
    found_.push_back(component);
  }

  const Included& modules_;
  std::map<std::string, State> states_;
  std::vector<std::string> open_;
  std::vector<std::vector<std::string>> found_;
};

}  // namespace

std::string module_of(std::string_view path) {
  const std::size_t folder = path.rfind('/');
  const std::size_t dot = path.rfind('.');
  const bool named =
      dot != std::string_view::npos && (folder == std::string_view::npos || dot > folder);
  return std::string(named ? path.substr(0, dot) : path);
}

std::vector<std::vector<std::string>> include_circles(const std::vector<SourceFile>& files) {
  return CircleSearch(modules_of(files)).all();
}

}  // namespace rob::test

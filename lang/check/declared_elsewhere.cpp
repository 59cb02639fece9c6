#include "lang/check/declared_elsewhere.h"

#include "lang/text/ascii.h"

namespace rob::lang {
namespace {

using Found = std::optional<Place>;

Found search(const Block& block, const std::string& key);

struct Search {
  const std::string& key;

  Found operator()(const Declaration& declaration) const {
    for (const Declaration::Declared& declared : declaration.names) {
      if (to_upper(declared.name) == key) return declared.place;
    }
    return std::nullopt;
  }
  Found operator()(const PointDeclaration& points) const {
    for (const PointDeclaration::Point& point : points.points) {
      if (to_upper(point.declared.name) == key) return point.declared.place;
    }
    return std::nullopt;
  }
  Found operator()(const SignalDeclaration& signal) const {
    return to_upper(signal.name) == key ? Found(signal.name_place) : std::nullopt;
  }
  Found operator()(const RecordDeclaration& record) const {
    return to_upper(record.declared.name) == key ? Found(record.declared.place) : std::nullopt;
  }
  Found operator()(const If& conditional) const {
    for (const If::Branch& branch : conditional.branches) {
      if (const Found found = search(branch.body, key)) return found;
    }
    return search(conditional.otherwise, key);
  }
  Found operator()(const While& loop) const { return search(loop.body, key); }
  Found operator()(const For& loop) const {
    if (to_upper(loop.variable) == key) return loop.variable_place;
    return search(loop.body, key);
  }
  Found operator()(const With& with) const { return search(with.body, key); }
  Found operator()(const Press& press) const { return search(press.body, key); }
  Found operator()(const Loop& loop) const { return search(loop.body, key); }
  Found operator()(const Select& select) const {
    for (const Select::Case& one : select.cases) {
      if (const Found found = search(one.body, key)) return found;
    }
    return search(select.otherwise, key);
  }
  Found operator()(const Try& guarded) const {
    if (to_upper(guarded.why.name) == key) return guarded.why.place;
    if (const Found found = search(guarded.body, key)) return found;
    return search(guarded.rescue, key);
  }
  template <typename Other>
  Found operator()(const Other&) const {
    return std::nullopt;
  }
};

Found search(const Block& block, const std::string& key) {
  for (const Statement& statement : block) {
    if (const Found found = std::visit(Search{key}, statement.node)) return found;
  }
  return std::nullopt;
}

/// The top level of a file: where it is USEd first. Null if it declares nothing there.
const Block* top_level_of(std::uint32_t file, const Block& statements) {
  for (const Statement& statement : statements) {
    const Use* const use = std::get_if<Use>(&statement.node);
    if (use == nullptr) continue;
    if (use->file == file && !use->declarations.empty()) return &use->declarations;
    if (const Block* const found = top_level_of(file, use->declarations)) return found;
  }
  return nullptr;
}

}  // namespace

std::optional<Place> find_declaration(const Program& program, std::string_view name,
                                      std::uint32_t file) {
  const std::string key = to_upper(name);
  const Block* const top_level =
      file == 0 ? &program.statements : top_level_of(file, program.statements);
  if (top_level != nullptr) {
    if (const Found found = search(*top_level, key)) return found;
  }
  for (const Routine& routine : program.routines) {
    if (routine.place.file != file) continue;
    for (const Routine::Parameters& group : routine.parameters) {
      for (const Declaration::Declared& declared : group.names) {
        if (to_upper(declared.name) == key) return declared.place;
      }
    }
    if (const Found found = search(routine.body, key)) return found;
  }
  return std::nullopt;
}

}  // namespace rob::lang

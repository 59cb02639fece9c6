#include "lang/declared_elsewhere.h"

#include "lang/ascii.h"

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

}  // namespace

std::optional<Place> find_declaration(const Program& program, std::string_view name) {
  const std::string key = to_upper(name);
  if (const Found found = search(program.statements, key)) return found;
  for (const Routine& routine : program.routines) {
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

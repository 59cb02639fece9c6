#include "runtime/prompt/workshop.h"

#include "runtime/prompt/declared_points.h"

namespace rob::runtime {

void Workshop::record(const std::string& entry, const std::vector<lang::DeclaredName>& named,
                      std::uint32_t line) {
  std::string points;
  for (const lang::DeclaredName& name : named) {
    if (name.kind != lang::DeclaredName::Kind::Point) continue;
    if (!program.declares_point(name.name) && !declares_point(entry, name.name))
      points += "POINT " + name.name + "\n";
  }
  program.record(points + entry, line);
}

}  // namespace rob::runtime

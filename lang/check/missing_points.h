#pragma once

#include <map>
#include <vector>

#include "lang/check/symbols.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// A declared point that has no value before the program runs, and is used all the same.
struct MissingPoint {
  std::string name;
  Place place;  ///< of its declaration
};

/// Finds the points that are used although neither the points file nor the program gives them a
/// value. A TEACH at the top level, outside of all blocks, does so for the lines behind it; what
/// routines do may come earlier.
class MissingPoints {
 public:
  void declare(const Symbol& point) { states_[&point]; }
  void teach(const Symbol& point, bool surely);
  void use(const Symbol& point);
  /// From here on come the routines.
  void enter_routines() { in_routines_ = true; }
  /// All of them, in the order of their declarations.
  std::vector<MissingPoint> found() const;

 private:
  struct State {
    bool surely = false;  ///< taught before what comes now
    bool taught = false;  ///< somewhere
    bool needed = false;  ///< used before it is surely taught
  };
  std::map<const Symbol*, State> states_;
  bool in_routines_ = false;
};

}  // namespace rob::lang

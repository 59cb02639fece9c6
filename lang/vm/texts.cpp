#include "lang/vm/texts.h"

namespace rob::lang {

bool append(std::string& text, std::string_view more) {
  if (text.size() + more.size() > kMostText) return false;
  text += more;
  return true;
}

bool join(std::string& target, const std::string& left, const std::string& right) {
  if (left.size() + right.size() > kMostText) return false;
  if (&target == &left) {
    target += right;
  } else {
    target = left + right;
  }
  return true;
}

}  // namespace rob::lang

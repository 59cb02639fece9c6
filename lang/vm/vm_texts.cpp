#include <string_view>

#include "lang/vm/vm.h"

/// The part of Vm that joins texts.
namespace rob::lang {

bool Vm::append(std::uint8_t target, std::string_view more) {
  if (texts_[target].size() + more.size() > kMostText) return false;
  texts_[target] += more;
  return true;
}

bool Vm::join(std::uint8_t target, std::uint8_t left, std::uint8_t right) {
  if (texts_[left].size() + texts_[right].size() > kMostText) return false;
  if (target == left) {
    texts_[target] += texts_[right];
  } else {
    texts_[target] = texts_[left] + texts_[right];
  }
  return true;
}

}  // namespace rob::lang

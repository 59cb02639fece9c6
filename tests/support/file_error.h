#pragma once

#include <string>

#include "runtime/files/files.h"

namespace rob::test {

/// The message of the FileError that a call throws, or "no error".
std::string message_of(auto&& call) {
  try {
    call();
  } catch (const runtime::FileError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace rob::test

#pragma once

#include <stdexcept>

namespace rob::motion {

/// A robot file that is wrong. what() is "file:line:column: what is wrong, and the remedy".
class RobotFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A robot file that cannot be read. what() says why, and the remedy.
class RobotFileUnreadable : public RobotFileError {
 public:
  using RobotFileError::RobotFileError;
};

}  // namespace rob::motion

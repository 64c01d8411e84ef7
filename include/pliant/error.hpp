#pragma once

#include <stdexcept>

namespace pliant {

/// What a user gave is wrong: a case, a name, a file that is not there. The text says where, what
/// is wrong, and what to do, one line for each problem.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A simulation could not continue: a value is no longer finite, a step is out of bounds, a file
/// could not be written. The text says when, where, and what to do.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pliant

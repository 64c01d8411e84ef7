#pragma once

#include <stdexcept>

namespace pliant {

/// The user's input is wrong: a case, a name, or a file that does not exist. The text says where,
/// what is wrong, and what to do, one line for each problem.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A simulation cannot continue: a value is no longer finite, a step is out of bounds, or a file
/// cannot be written. The text says when, where, and what to do.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pliant

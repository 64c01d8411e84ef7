#pragma once

#include <pliant/error.hpp>

#include <new>
#include <stdexcept>

#include "engine/method/step_failure.hpp"
#include "engine/output/error.hpp"

namespace pliant {

/// Calls `f` and translates its exceptions into the public types.
template <class F>
auto translated(F&& f) {
  try {
    return f();
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  } catch (const StepFailure& error) {
    throw RunError(error.what());
  } catch (const OutputError& error) {
    throw RunError(error.what());
  } catch (const std::bad_alloc&) {
    throw RunError("out of memory; use a coarser spacing (discretisation.spacing)");
  }
}

}  // namespace pliant

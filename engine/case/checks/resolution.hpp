#pragma once

#include <string>
#include <string_view>

#include "engine/case/case.hpp"

namespace pliant {

/// What the errors of a body depend on: the spacing of its particles, or the size of its elements
/// where a method takes the nodes of its mesh as they are.
struct Resolution {
  double size = 0;           ///< [m]
  bool of_elements = false;  ///< else of particles

  /// As in "4 spacings wide".
  std::string_view units() const { return of_elements ? "elements" : "spacings"; }

  /// What makes an error smaller: resolution of `enough` [m], as in "use a finer spacing (...)".
  std::string remedy(double enough) const;
};

/// The size of elements is the edge of the cubes of six tetrahedra that have as many elements as
/// the mesh of the body.
Resolution resolution_of(const Case& a_case, const BodyCase& body);

}  // namespace pliant

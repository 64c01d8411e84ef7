#include "engine/simulation/methods.hpp"

#include "engine/finite_elements/method.hpp"
#include "engine/point_based/method.hpp"
#include "engine/remeshed/method.hpp"
#include "engine/sph/method.hpp"
#include "engine/total_lagrangian/method.hpp"

namespace pliant {

const MethodRegistry& methods() {
  static const MethodRegistry registry({remeshed::method(), total_lagrangian::method(),
                                        point_based::method(), finite_elements::method(),
                                        sph::method()});
  return registry;
}

Case read_case(const std::filesystem::path& path, std::span<const std::string> settings) {
  return read_case(path, settings, methods().rules());
}

}  // namespace pliant

#include "engine/method/hyperelastic.hpp"

#include <cstddef>

#include "kernels/energy.hpp"
#include "kernels/first_piola.hpp"

namespace pliant {

namespace {

using Pack = xsimd::batch<double, xsimd::sse2>;
using FullTensor = std::array<double, 9>;  // row by row

kernels::ElasticLaw law_of(kernels::Model model) {
  switch (model) {
    case kernels::Model::neo_hookean:
      return kernels::ElasticLaw::neo_hookean;
    case kernels::Model::st_venant_kirchhoff:
      return kernels::ElasticLaw::st_venant_kirchhoff;
    default:
      return kernels::ElasticLaw::reduced_polynomial;
  }
}

template <kernels::ElasticLaw law>
FullTensor piola_of(const kernels::HyperelasticMaterial<double>& material, const FullTensor& f) {
  Pack packed[9], cof[9], p[9];
  for (int c = 0; c < 9; ++c) packed[c] = Pack(f[c]);
  kernels::cofactor(packed, cof);
  kernels::first_piola<law, Pack, 3>(material, packed, cof, p);
  FullTensor result;
  for (int c = 0; c < 9; ++c) result[c] = p[c].get(0);
  return result;
}

FullTensor piola(const kernels::HyperelasticMaterial<double>& material, const FullTensor& f) {
  using enum kernels::ElasticLaw;
  switch (material.law) {
    case neo_hookean:
      return piola_of<neo_hookean>(material, f);
    case st_venant_kirchhoff:
      return piola_of<st_venant_kirchhoff>(material, f);
    default:
      return piola_of<reduced_polynomial>(material, f);
  }
}

double determinant_of(const FullTensor& f) {
  return f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) +
         f[2] * (f[3] * f[7] - f[4] * f[6]);
}

/// The 3D tensor of `f`; F_33 = 1 in plane strain.
template <int D>
FullTensor in_3d(const std::array<double, D * D>& f) {
  FullTensor full = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) full[3 * i + j] = f[D * i + j];
  }
  return full;
}

}  // namespace

kernels::HyperelasticMaterial<double> hyperelastic_material(const BodyCase& body) {
  kernels::Material<double> m = body.material;
  if (!kernels::carries_deformation(m.model)) m.model = kernels::Model::neo_hookean;
  return {law_of(m.model), m.density, m.shear_modulus, kernels::lame_modulus(m), m};
}

double long_term_share(const std::vector<kernels::PronyTerm<double>>& prony) {
  double share = 1;
  for (const kernels::PronyTerm<double>& term : prony) share -= term.ratio;
  return share;
}

template <int D>
ElasticStress<D> elastic_stress(const kernels::HyperelasticMaterial<double>& material,
                                const std::array<double, D * D>& gradient) {
  const FullTensor f = in_3d<D>(gradient), p = piola(material, f);
  ElasticStress<D> found;
  const double jacobian = found.volume_ratio = determinant_of(f);
  double trace = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      double sigma = 0;
      for (int k = 0; k < 3; ++k) sigma += p[3 * i + k] * f[3 * j + k] / jacobian;
      if (i == j) trace += sigma;
      if (j < D) found.stress[kernels::symmetric_index<D>(i, j)] = sigma;
    }
  }
  found.pressure = -trace / 3;
  return found;
}

template <int D>
double elastic_energy(const kernels::HyperelasticMaterial<double>& material,
                      const std::array<double, D * D>& f) {
  return kernels::hyperelastic_energy<double, D>(material.polynomial, f.data());
}

template ElasticStress<2> elastic_stress(const kernels::HyperelasticMaterial<double>&,
                                         const std::array<double, 4>&);
template ElasticStress<3> elastic_stress(const kernels::HyperelasticMaterial<double>&,
                                         const std::array<double, 9>&);
template double elastic_energy<2>(const kernels::HyperelasticMaterial<double>&,
                                  const std::array<double, 4>&);
template double elastic_energy<3>(const kernels::HyperelasticMaterial<double>&,
                                  const std::array<double, 9>&);

}  // namespace pliant

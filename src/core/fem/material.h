#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace gnathion {

/// Isotropic, homogeneous Hookean tissue (paper, 4.3.3: after Shlivko et al. 2013).
struct ElasticMaterial {
  double young_MPa = 1;   ///< Young's modulus E, > 0
  double poisson = 0.46;  ///< Poisson's ratio ν, 0 <= ν < 0.5

  /// First Lamé constant λ = νE/((1+ν)(1−2ν)), MPa (paper, section 3).
  double lame_lambda() const { return poisson * young_MPa / ((1 + poisson) * (1 - 2 * poisson)); }
  /// Shear modulus μ = E/(2(1+ν)), MPa.
  double shear_modulus() const { return young_MPa / (2 * (1 + poisson)); }
  /// Bulk modulus κ = λ + 2μ/3, MPa.
  double bulk_modulus() const { return lame_lambda() + shear_modulus() * 2 / 3; }

  bool operator==(const ElasticMaterial&) const = default;
};

/// Throws Error(case_file) with the key's name unless E > 0 and 0 <= ν < 0.5, both finite.
void validate(const ElasticMaterial& material);

/// What each tet of a mesh is made of.
struct TissueMaterials {
  std::vector<ElasticMaterial> kinds;  ///< at least one
  std::vector<unsigned char> of_tet;   ///< one index into kinds a tet; empty: all are kinds[0]

  TissueMaterials(const ElasticMaterial& one = {}) : kinds{one} {}
  TissueMaterials(std::vector<ElasticMaterial> several, std::vector<unsigned char> kind_of_tet)
      : kinds(std::move(several)), of_tet(std::move(kind_of_tet)) {}
  const ElasticMaterial& operator[](std::ptrdiff_t tet) const {
    return of_tet.empty() ? kinds[0] : kinds[of_tet[static_cast<std::size_t>(tet)]];
  }
};

/// Throws as above for any of the kinds, and Error(numeric) when a tet's kind is not among them or
/// their number is not `tet_count`.
void validate(const TissueMaterials& materials, std::ptrdiff_t tet_count);

}  // namespace gnathion

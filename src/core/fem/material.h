#pragma once

namespace gnathion {

/// Isotropic, homogeneous Hookean tissue (paper, 4.3.3: after Shlivko et al. 2013).
struct ElasticMaterial {
  double young_MPa = 1;   ///< Young's modulus E, > 0
  double poisson = 0.46;  ///< Poisson's ratio ν, 0 <= ν < 0.5

  /// First Lamé constant λ = νE/((1+ν)(1−2ν)), MPa (paper, section 3).
  double lame_lambda() const { return poisson * young_MPa / ((1 + poisson) * (1 - 2 * poisson)); }
  /// Shear modulus μ = E/(2(1+ν)), MPa.
  double shear_modulus() const { return young_MPa / (2 * (1 + poisson)); }
};

/// Throws Error(case_file) with the key's name unless E > 0 and 0 <= ν < 0.5, both finite.
void validate(const ElasticMaterial& material);

}  // namespace gnathion

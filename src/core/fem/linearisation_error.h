#pragma once

#include "fem/static_solver.h"

namespace gnathion {

/// The part of the neo-Hookean answer that is quadratic in the load, n×3, mm: what the linear
/// answer `u` (n×3, mm, of `linear`) misses first,
///   e = −(QᵀKQ)⁻¹ Qᵀ f₂,  f₂ = lim (f_int(s u) − s K u)/s²  for s → 0,
/// one force and one back-solve. s is finite, small enough for strains of 1e-3, so it
/// exists where the linear answer itself is turned inside out. The whole step −(QᵀKQ)⁻¹ Qᵀ
/// f_int(u), s = 1, exaggerates the error several times from a few mm on. Throws Error(numeric)
/// when u is not finite.
Points second_order_correction(const StaticSolver& linear, const Points& u);

/// How far the linear answer is from the neo-Hookean one, at each node, mm, without solving for
/// that: the length of the second-order correction. Throws as that.
Eigen::VectorXd linearisation_error(const StaticSolver& linear, const Points& u);

}  // namespace gnathion

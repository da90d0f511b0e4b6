#pragma once

#include "fem/neo_hookean.h"
#include "fem/static_solver.h"

namespace gnathion {

/// How far a linear solution is from the neo-Hookean one, estimated without solving for it: one
/// correction with the linear factor, −(QᵀKQ)⁻¹ Qᵀ f_int(u). Where u turns tissue inside out, f_int
/// is taken at a part s of u that does not, and the correction scaled by 1/s², since linearisation
/// errs in the second order of the motion. n×3, mm; docs/evidence.md has its effectivity.
/// `u`: n×3, mm, a solution of `linear` without forces. Throws Error(numeric) when u is not finite.
Points linearisation_error(const StaticSolver& linear, const Points& u);

}  // namespace gnathion

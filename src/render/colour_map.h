#pragma once

#include <Eigen/Core>

#include <vtkSmartPointer.h>

class vtkLookupTable;

namespace gnathion {

/// Colour of a value that was not measured (not a number): a neutral grey, RGB 0..1.
inline const Eigen::Vector3d unmeasured_colour{0.62, 0.62, 0.62};

/// RGB (0..1) of a position on the diverging map: −1 blue (hollow), 0 near white, +1 red (bulge);
/// outside, the colour of the nearer end. Blue against red, equally dark at equal distance from
/// zero, stays apart for the common colour-vision deficiencies (Moreland 2009, "Diverging color
/// maps for scientific visualization": straight through CIELAB's Msh form).
Eigen::Vector3d diverging_colour(double position);

/// The map over [−half_range, half_range] mm. \pre half_range > 0.
vtkSmartPointer<vtkLookupTable> diverging_table(double half_range);

/// A round number of mm (1, 2, 3, 4, 5, 6, 8 or 10 times a power of ten) that at least 99 % of the
/// finite |values| above 0.05 mm do not exceed, at least 0.1; 1 when there are none. A few outliers
/// thus do not wash the map out, and a large face at rest around a small change does not cut it.
double round_half_range(const Eigen::VectorXd& values);

}  // namespace gnathion

#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "tissue/intermediate_mesh.h"
#include "tissue/layers.h"
#include "tissue/soft_tissue_mesh.h"

namespace gnathion {

/// Algorithm 1 of the paper (4.1.3) with its points and order:
///   P_{i+M} = J_i − d n(J_i),  P_{i+2M} = centre(F_i) − d_c n(F_i).
/// The paper does not give d_c; its figure has the centre point within the layer. Nothing is
/// mended: where the surface is concave, elements invert.
/// `depth`: d > 0, mm; `centre_fraction`: d_c/d, above 0, at most 1.
SoftTissueMesh st_generator_paper(const IntermediateMesh& region, double depth,
                                  double centre_fraction = 0.5);

struct RobustGeneratorOptions {
  double focal_part = 0.6;  ///< of the depth where neighbouring offset lines meet
  double steepest = 1.0;    ///< change of depth per mm along the surface
  double shrink = 0.85;     ///< factor on the depth, one round, where tissue does not fit
  int mending_rounds = 40;
  double smallest_volume_ratio = 0.02;  ///< of a tet, against the volume it has on a flat patch
  LayerOptions layers = kOneLayer;
};

/// Unit directions into the tissue at each vertex: −n(J_i), smoothed over the surface along about
/// `length` mm (the depth to be meshed: over less, the directions of a fold cross within the
/// tissue), and turned back where smoothing would leave the half space behind a triangle of the
/// vertex. M×3.
Points offset_directions(const IntermediateMesh& region, double length);

/// The robust generator: the paper's elements, but the inner vertex of J_i lies `depth[i]` along
/// `directions` (so that it can lie on the bone), and the centre point is a weighted mean of the
/// three inner vertices, which keeps the tissue's volume. Where elements would be inverted or too
/// flat, inner and centre points move (untangle); where the inner surface would cross itself or the
/// skin anywhere, or elements stay faulty, depths shrink, until nothing does:
/// `SoftTissueMesh::depth` says what was used. Then thick tissue is divided into layers.
/// directions: M×3; depth: M, mm, > 0.
/// Throws Error(anatomy) naming the place when the surface is folded so that no depth helps,
/// or crosses itself.
SoftTissueMesh st_generator(const IntermediateMesh& region, const Points& directions,
                            const Eigen::VectorXd& depth,
                            const RobustGeneratorOptions& options = {});

}  // namespace gnathion

#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "geometry/rigid_motion.h"
#include "phantom/face_paint.h"
#include "phantom/head_phantom.h"

namespace gnathion {

/// The face as a structured grid on the skin, ear to ear and from hairline to below the chin, of
/// which an oval is kept: squares inside, triangles along the rim.
struct PhantomPhotograph {
  int columns = 0;  ///< of the whole grid
  int rows = 0;
  Points grid;  ///< rows·columns×3, LPS mm, column fastest, right to left, bottom to top

  std::vector<int> kept;                ///< rows of `grid` that are vertices, ascending
  std::vector<std::vector<int>> faces;  ///< indices into `kept`, counter-clockwise from outside

  /// Texture coordinates (v up) of a grid point, within 0..1.
  Eigen::Vector2d texture_coordinate(int grid_index) const;
};

/// Deterministic.
PhantomPhotograph make_phantom_photograph(const HeadModel& head, const PhantomOptions& options,
                                          Progress& progress);

/// Writes face.obj, face.mtl and face.png into `folder` (which exists); the vertices are given in
/// the photograph's own frame. Errors: output.
void write_phantom_photograph(const PhantomPhotograph& photograph, const FacePaint& paint,
                              const Similarity& lps_from_photograph,
                              const std::filesystem::path& folder, const PhantomOptions& options,
                              Progress& progress);

}  // namespace gnathion

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh_types.h"

namespace gnathion {

/// A surface laid out flat in a picture, piece by piece: where each triangle's colours are.
struct SkinCharts {
  int width = 0, height = 0;  ///< of the picture, pixels
  double mm_per_pixel = 0;    ///< across a piece's direction; up to 2.2 times as much along a slope
  /// k×2, pixels, right and down, the middle of the upper left pixel is (0, 0).
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> places;
  Triangles corners;      ///< m×3 rows of `places`; −1: the triangle is not laid out
  Eigen::Vector2d plain;  ///< a place with nothing else within 12 pixels, for one colour
  /// Where the pieces are, pixels. Boxes do not overlap.
  struct Box {
    int x = 0, y = 0, width = 0, height = 0;
  };
  std::vector<Box> pieces;

  /// A triangle where a piece draws it: its own, and as a margin those that adjoin the piece.
  struct Drawn {
    int triangle;
    int piece;                              ///< beyond whose box nothing is drawn
    std::array<Eigen::Vector2d, 3> corner;  ///< pixels
  };
  std::vector<Drawn> drawn;  ///< margins first: what is drawn later lies on top
};

struct ChartOptions {
  double mm_per_pixel = 0.3;  ///< becomes more where the picture would be too large
  double margin_mm = 3;       ///< of a piece, drawn around it
  int largest_side = 8192;    ///< of the picture, pixels: what every graphics driver takes
};

/// Lays out the wanted triangles (m flags) without overlap: pieces that hang together and face
/// about the same of six directions are projected along it. No middle of a pixel lies in two
/// triangles of `corners`. surface: mm. Deterministic. Throws Error(cancelled).
SkinCharts lay_out(const TriangleMesh& surface, const std::vector<bool>& wanted,
                   const ChartOptions& options, Progress& progress);

/// Calls `fill(x, y, weights)` for each pixel whose middle lies in the triangle (its border
/// included), within a picture of this size. weights: of the three corners, sum 1.
template <typename Fill>
void for_each_pixel(const std::array<Eigen::Vector2d, 3>& corner, int width, int height,
                    const Fill& fill) {
  const Eigen::Vector2d &a = corner[0], &b = corner[1], &c = corner[2];
  const auto cross = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return p.x() * q.y() - p.y() * q.x();
  };
  const double area = cross(b - a, c - a);
  if (area == 0) return;
  const Eigen::Vector2d least = a.cwiseMin(b).cwiseMin(c), most = a.cwiseMax(b).cwiseMax(c);
  const int x_end = std::min(width - 1, static_cast<int>(std::floor(most.x())));
  const int y_end = std::min(height - 1, static_cast<int>(std::floor(most.y())));
  for (int y = std::max(0, static_cast<int>(std::ceil(least.y()))); y <= y_end; ++y) {
    for (int x = std::max(0, static_cast<int>(std::ceil(least.x()))); x <= x_end; ++x) {
      const Eigen::Vector2d p(x, y);
      const double u = cross(c - b, p - b) / area, v = cross(a - c, p - c) / area;
      if (u < 0 || v < 0 || u + v > 1) continue;
      fill(x, y, Eigen::Vector3d(u, v, 1 - u - v));
    }
  }
}

}  // namespace gnathion

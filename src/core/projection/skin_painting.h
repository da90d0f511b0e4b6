#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "projection/photo.h"
#include "projection/photo_camera.h"
#include "projection/skin_charts.h"
#include "scan_stream/scan_stream.h"

namespace gnathion {

/// A photograph and where it was taken from.
struct PlacedPhoto {
  std::string name;
  const Photo* photo = nullptr;  ///< must outlive the painting
  PhotoCamera camera;
  /// CameraFit::uncertainty_mm: so near the outline of what it sees a photograph may show what lies
  /// behind, and is not taken.
  double uncertainty_mm = 0;
};

struct PaintOptions {
  /// Of the picture that is painted. None: that of the finest photograph on the skin, 0.2 to 1 mm.
  std::optional<double> mm_per_pixel;
  double inpaint_mm = 10;  ///< how far from what a photograph shows the skin is made up
};

/// What one photograph gave.
struct PhotoShare {
  std::string name;
  double seen_cm2 = 0;                             ///< of the skin
  Eigen::Vector3d gain = Eigen::Vector3d::Ones();  ///< of red, green, blue, to match the first
};

/// The skin's colours, and where they come from.
struct PaintedSkin {
  SkinCharts charts;
  Photo picture;  ///< on the charts
  std::vector<PhotoShare> photos;
  double skin_cm2 = 0;       ///< all of it
  double seen_cm2 = 0;       ///< by any photograph
  double inpainted_cm2 = 0;  ///< near what is seen, made up from it; the rest has one colour
  Eigen::Vector3d plain = Eigen::Vector3d::Zero();  ///< that colour, sRGB 0..1: the seen median
  /// Mean difference of the channels (0..1) where two photographs show the same skin, after the
  /// gains; 0 where there is no such place.
  double disagreement = 0;
};

/// Paints the skin with one photograph or more, each from its camera. A place is taken from the
/// photographs that see it: not hidden by other skin, not at an outline, turned to the eye to 78
/// degrees. Their broad colours are blended by how squarely they see it, their
/// fine ones taken from the best (two bands, after Burt and Adelson 1983); before, each
/// photograph's channels are multiplied so that they match the first's. Where none
/// sees it, the broad colours go on over the skin and fade into one.
/// Throws Error(input) naming a photograph that sees nothing of the skin, Error(cancelled).
PaintedSkin paint_skin(std::span<const PlacedPhoto> photos, const SkinSight& skin,
                       const PaintOptions& options, Progress& progress);

/// The skin with its colours as a scan in LPS mm, its vertices in order; its picture
/// ("photograph.png") lies within, and says nothing but its pixels.
RawScan scan_of(const PaintedSkin& painted, const TriangleMesh& skin);

}  // namespace gnathion

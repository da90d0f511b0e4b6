#pragma once

#include <optional>

#include "registration/landmark_fit.h"
#include "registration/surface_fit.h"

namespace gnathion {

struct RegistrationOptions {
  /// Flags of the photograph's vertices that are trusted to be the same on both days: forehead,
  /// bridge of the nose. Only they decide the fit, and quality is that of them. Empty: all.
  std::vector<bool> stable;
  bool fit_scale = false;  ///< the scale, too; else it is the start's, or the unit's
  double trimmed = 0.2;    ///< of the pairs of points, the worst, left out: 0..0.6
  /// Landmarks picked on both. They do not pull at the surface fit: their residuals judge it.
  std::vector<LandmarkPair> landmarks;
  /// For the automatic start: millimetres in a unit of the photograph. None: mm, cm and m are tried
  /// where they make it as large as a head, and where none does the scale is searched for.
  std::optional<double> mm_per_unit;
};

/// How well a photograph lies on the skin. Distances are from its points to the nearest point of
/// the skin, of those points (of the stable vertices) that are nearer than 15 mm and face as the
/// skin does: mouth, hair and shoulders that are near count, so that nothing looks better than it
/// is.
struct RegistrationQuality {
  double rms_mm = 0, median_mm = 0, p95_mm = 0;  ///< of the absolute distances
  double near = 0;                               ///< share of the points that are so near, 0..1
  double agrees = 0;       ///< share of these that lie within 2 mm of the skin, the offset aside
  double matched_cm2 = 0;  ///< area of these
  double spread_mm = 0;    ///< standard deviation by the median, of the pairs that decided
  double offset_mm = 0;    ///< of the photograph above the CT's skin, found with the fit
  double grip = 0;         ///< SurfaceFit::grip
  int iterations = 0;
  bool converged = false;
  std::map<std::string, double> landmark_mm;  ///< residual of each of the options' landmarks
};

/// A reason not to take a registration as it is.
struct RegistrationDoubt {
  enum class Kind {
    nothing_found,     ///< no place to begin from
    not_converged,     ///< the fit had not come to rest
    too_little,        ///< too little of the photograph lies on the skin
    too_far,           ///< what lies on it does so too roughly
    slides,            ///< the shape does not hold it, as on a sphere
    moved_far,         ///< it came to rest farther from the start than a start may be off
    ambiguous,         ///< it fits elsewhere, or in another unit, nearly as well
    unit_unknown,      ///< the scale had to be searched for
    parts_differ,      ///< the lower face fits elsewhere than the upper: another expression
    landmarks_differ,  ///< the surface fits but the landmarks do not
  };
  Kind kind;
  std::string problem;  ///< what is wrong, for the user
  std::string remedy;   ///< what to do
};

/// Where a photograph belongs.
struct Registration {
  Similarity lps_from_photograph;
  RegistrationQuality quality;
  std::vector<RegistrationDoubt> doubts;

  /// Whether it may be used without a look at the doubts.
  bool trusted() const { return doubts.empty(); }
};

/// How well a photograph lies on the skin where it is, without moving it: distances, shares and
/// landmarks; spread about the median distance, the offset. grip, iterations and converged say
/// nothing. Throws Error(input) as register_photograph().
RegistrationQuality registration_quality(const TriangleMesh& photograph, const SkinTarget& skin,
                                         const Similarity& lps_from_photograph,
                                         const RegistrationOptions& options);

/// From a start that is right to about 20° and 15 mm (landmarks, or the place it has). Without a
/// stable region the upper face alone is fitted, too; where it comes to lie more than a millimetre
/// elsewhere, its place is taken and doubted. photograph:
/// own frame and unit, outward. A failure is told by doubts, never by a poor fit alone.
/// Throws Error(input): no triangles, a coordinate that is not finite, fewer than 50 stable
/// vertices, flags of another number of vertices, a start that is mirrored, sheared or without
/// scale. Throws Error(cancelled).
Registration register_photograph(const TriangleMesh& photograph, const SkinTarget& skin,
                                 const Similarity& start, const RegistrationOptions& options,
                                 Progress& progress);

/// From the shapes alone, whatever its turn and place (automatic_start.h). A scale that is neither
/// given nor a usual unit's is estimated, and doubted. Throws as above; Error(input) also for a
/// mm_per_unit that is not above 0.
Registration register_photograph(const TriangleMesh& photograph, const SkinTarget& skin,
                                 const RegistrationOptions& options, Progress& progress);

}  // namespace gnathion

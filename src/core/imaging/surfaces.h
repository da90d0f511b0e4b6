#pragma once

#include <optional>

#include "base/progress.h"
#include "geometry/mesh_types.h"
#include "imaging/ct_volume.h"

namespace gnathion {

struct BoneSurfaceOptions {
  double hu = 250;                         ///< the surface's level
  double minimum_component_volume = 1000;  ///< mm³; smaller pieces are specks and are dropped
  bool remove_support = true;              ///< drop what lies outside the head: head rest, couch
  std::optional<LpsBox> crop;              ///< look only here

  bool operator==(const BoneSurfaceOptions&) const = default;
};

/// The bone's surface by flying edges at full resolution: vertices in LPS mm, closed (also where
/// the volume ends), outward, without degenerate triangles, no vertex smoothed or moved.
/// Pieces (skull, mandible, a loose tooth) stay separate components of one mesh; hollows that are
/// wholly enclosed by bone are filled.
/// Throws Error(anatomy) when nothing reaches the level, Error(input) when the crop box misses.
TriangleMesh bone_surface(const CtVolume& volume, const BoneSurfaceOptions& options,
                          Progress& progress);

struct SkinSurfaceOptions {
  double hu = -300;              ///< the surface's level
  double edge_mm = 2.0;          ///< mean edge length aimed at
  bool remove_support = true;    ///< detach head rest and couch
  double opening_radius_mm = 6;  ///< parts thinner than twice this may be support
  double closing_radius_mm = 5;  ///< openings narrower than twice this (nostrils) are closed
  std::optional<LpsBox> crop;    ///< look only here

  bool operator==(const SkinSurfaceOptions&) const = default;
};

/// The head's outer skin: one closed, outward 2-manifold component in LPS mm with well-shaped
/// triangles of about edge_mm, each vertex on the level surface. Airways and cavities are filled,
/// nostrils closed; the head is the largest body that is left when thin parts (couch, head rest)
/// are set aside, and thin parts that belong to it (ears) are put back.
/// Throws Error(anatomy) when there is no skin at the level, Error(input) when the crop misses.
TriangleMesh skin_surface(const CtVolume& volume, const SkinSurfaceOptions& options,
                          Progress& progress);

}  // namespace gnathion

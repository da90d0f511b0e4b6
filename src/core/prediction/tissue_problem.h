#pragma once

#include "fem/static_solver.h"
#include "prediction/anatomy.h"
#include "tissue/bone_map.h"
#include "tissue/coarse_region.h"
#include "tissue/lip_slit.h"
#include "tissue/st_generator.h"
#include "tissue/tissue_from_ct.h"
#include "tissue/unfold.h"

namespace gnathion {

/// The soft tissue between the segments and the face, meshed and held: what the equations are
/// about.
struct TissueProblem {
  IntermediateMesh region;         ///< what is meshed: the face's own vertices, or a remesh of them
  std::vector<int> face_vertices;  ///< of the face: the region that was chosen
  SurfaceMap surface_map;          ///< W, |face| × |region|
  std::vector<SlitVertex> slit;    ///< the region's vertices that are doubled between the lips
  double remeshed_mm = 0;  ///< by which the face's vertices lie off a remesh, 95 %; 0: no remesh
  std::vector<BoneLink> links;  ///< the bone map
  std::vector<int> bone_below;  ///< M, as BoneBelow::bone
  SoftTissueMesh tissue;
  TissueMaterials materials;
  std::array<TissueFromCt::Share, 3> share{};  ///< of the tissue kinds, when they are from the CT
  Supports supports;                           ///< of the tissue's nodes
  std::vector<int> forced;    ///< surface nodes that the bone map links to the segment
  int attached_count = 0;     ///< inner nodes that follow a segment
  int on_skull_count = 0;     ///< inner nodes held by other bone
  int sliding_count = 0;      ///< inner nodes that slide over bone
  int released_count = 0;     ///< inner nodes on bone next to a cut, which does not hold them
  int unfolded_count = 0;     ///< vertices that were smoothed at folds before meshing
  double unfolded_mm = 0;     ///< by at most this
  double rim_to_segment = 0;  ///< mm, smallest distance from the rim to a moving bone
};

/// Chooses the region and meshes, maps and holds its tissue.
/// Throws Error(anatomy): as the region's choice, lip_path() and the generator; when no bone of the
/// segments lies under the region, so that nothing is driven; when the paper's generator inverts
/// elements; Error(case_file) when a vertex that is to slide is not of the face.
TissueProblem build_tissue(const Anatomy& anatomy, const RegionChoice& region,
                           const TissueModel& model, Progress& progress);

}  // namespace gnathion

#pragma once

#include <vector>

#include "geometry/mesh_types.h"
#include "imaging/voxel_grid.h"

namespace gnathion {

/// Sets voxels below the level to just above it until the boundary between inside and outside is
/// a 2-manifold: no two inside voxels meet only along an edge or at a corner. Returns how many.
int make_well_composed(std::vector<float>& field, const VoxelGrid& grid, float level);

/// The level surface of the field by naive surface nets (Gibson 1998): one vertex for each cell
/// that the surface crosses, one quad for each grid edge that it crosses, both in LPS mm; quads are
/// split along the diagonal with the larger smallest angle. Nearly square quads make better shaped
/// triangles than marching cubes. Outward, from high values to low; closed when the grid's border
/// is below the level; a 2-manifold when the field is well composed.
///
/// `sweeps` times each vertex slides towards its neighbours' centre and back onto the level.
TriangleMesh surface_nets(const std::vector<float>& field, const VoxelGrid& grid, float level,
                          int sweeps);

}  // namespace gnathion

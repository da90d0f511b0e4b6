#pragma once

#include "tissue/intermediate_mesh.h"
#include "tissue/soft_tissue_mesh.h"

namespace gnathion {

/// How thick tissue is divided. The layer at the skin has the thickness of the edges there, deeper
/// ones grow, since what is far below the skin shows less on it.
struct LayerOptions {
  double thickness_in_edges = 1;  ///< of the layer at the skin, in local mean edges; 0: one layer
  double growth = 1.5;            ///< thickness of a layer over that of the one above it, ≥ 1
  int most = 8;                   ///< layers at any vertex
};

/// The paper's single layer.
inline constexpr LayerOptions kOneLayer{0, 1, 1};

/// For every tet, the volume that it has about where the surface is flat, mm³: a third of the
/// thinnest layer and the smallest mean triangle at its vertices.
Eigen::VectorXd flat_volumes(const IntermediateMesh& region, const SoftTissueMesh& tissue);

/// Sets the mesh's columns and elements for these numbers of layers (M, ≥ 1): nodes between layers
/// are placed on the straight line from the surface vertex to its inner vertex, each layer `growth`
/// times as thick as the one above. The deepest layer is the paper's. The ones above are filled by
/// going down the three columns of each triangle, one node at a time, always the column whose next
/// node is the least deep (the lower vertex index where equal): one tet a step. That order is the
/// same seen from either side of an edge, so that neighbours fit together whatever their numbers of
/// layers. The surface, inner and centre nodes keep their places.
void set_layers(const IntermediateMesh& region, const std::vector<int>& layers, double growth,
                SoftTissueMesh& tissue);

/// Divides the tissue of a mesh of one layer: the number of layers at every vertex brings them
/// nearest to the wanted thickness, and neighbours differ by at most one. Where an element would
/// be inverted or too flat there are fewer, down to the one layer that was given.
/// `smallest_volume_ratio`: of a tet, against the volume it has on a flat patch.
void add_layers(const IntermediateMesh& region, const LayerOptions& options,
                double smallest_volume_ratio, SoftTissueMesh& tissue);

}  // namespace gnathion

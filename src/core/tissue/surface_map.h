#pragma once

#include <Eigen/SparseCore>

#include "tissue/intermediate_mesh.h"

namespace gnathion {

/// The surface map W (paper, 4.2.1): |face| × |intermediate|, so that displacements of the face are
/// W times those of the intermediate mesh.
using SurfaceMap = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// W by index: row face_vertex[i] has a one in column i. Rows of enclosed vertices (the inside of
/// the mouth) hold weights of the nearest six vertices of the region, by inverse squared distance,
/// sum 1. The other rows are empty. `face`: the rest positions of the whole face, n×3.
SurfaceMap index_map(const IntermediateMesh& region, const Points& face);

/// W from a coarser mesh of the same region: the row of each face vertex of `dense` holds the
/// weights of the point of `coarse` nearest to it, barycentric in that point's triangle:
/// non-negative, sum 1. Vertices on the held rim take the nearest point of the coarse held rim, so
/// that what is held there is still to the last digit. Enclosed vertices as index_map, of which
/// this is the general case: with coarse = dense it is the same. |face| × |coarse|;
/// dense.face_vertex says which rows.
SurfaceMap barycentric_map(const IntermediateMesh& dense, const IntermediateMesh& coarse,
                           const Points& face);

/// W ⊗ I₃ times a basis whose rows are 3i+axis (first |intermediate| points of it), for the rows of
/// W that are not empty: 3k×c. `rows` receives their k face vertices.
Eigen::MatrixXd compose(const SurfaceMap& W, const Eigen::MatrixXd& basis, std::vector<int>& rows);

}  // namespace gnathion

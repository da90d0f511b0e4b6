#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fem/supports.h"
#include "geometry/mesh_types.h"

namespace gnathion {

enum class ElementOrder : unsigned char {
  linear,     ///< four nodes, constant strain
  quadratic,  ///< ten nodes: also the middles of the edges, straight sides
};

/// e×4 or e×10 nodes of each element.
using ElementNodes = Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The nodes and elements on which a displacement field lives. A field on quadratic elements is one
/// on linear elements plus what the middles of the edges add, so the first nodes are the vertices
/// of the tetrahedral mesh in both.
struct ElementMesh {
  Points nodes;                   ///< n×3, mm, LPS: the mesh's vertices, then the middles of edges
  ElementNodes elements;          ///< corners as in the mesh, middles of edges 01 12 20 03 13 23
  Eigen::Index vertex_count = 0;  ///< of the tetrahedral mesh
  std::vector<std::array<int, 2>> edges;  ///< the ends of the edge of node vertex_count + i

  ElementMesh() = default;
  ElementMesh(const TetMesh& mesh, ElementOrder order = ElementOrder::linear);

  ElementOrder order() const {
    return elements.cols() == 4 ? ElementOrder::linear : ElementOrder::quadratic;
  }
  /// A field given at the vertices (vertex_count×3), linear between them, at all nodes (n×3).
  Points from_vertices(const Points& field) const;
};

/// Supports of all nodes from those of the vertices: the middle of an edge is held as both its ends
/// are. Where one end is attached and the other slides over the same bone it slides; a middle with
/// a free end, or with ends on different bones, is free.
Supports supports_of_nodes(const ElementMesh& elements, const Supports& of_vertices);

/// A point of numerical integration within an element of m nodes.
template <int m>
struct IntegrationPoint {
  Eigen::Matrix<double, m, 3> gradients;  ///< of the shape functions at rest, 1/mm, a row a node
  double volume = 0;                      ///< weight times the volume of the element, mm³
};

/// One point for linear elements, the four of second order for quadratic ones: exact for products
/// of two strains in straight-sided elements.
template <int m>
using IntegrationPoints = std::array<IntegrationPoint<m>, m == 4 ? 1 : 4>;

/// The integration points of one element. nodes: those of the ElementMesh; element: m node numbers.
template <int m>
IntegrationPoints<m> integration_points(const Points& nodes, const int* element);

/// The four gradients of a linear tet's shape functions (rows, 1/mm) and its volume (mm³).
struct LinearTet {
  Eigen::Matrix<double, 4, 3> gradients;
  double volume = 0;
};
LinearTet linear_tet(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d);

/// The tissue's mass at each node, t: the row sums of M for linear elements, M's diagonal scaled to
/// the element's mass (Hinton, Rock and Zienkiewicz 1976) for quadratic ones, whose row sums are
/// negative at corners. density: t/mm³.
Eigen::VectorXd lumped_mass(const ElementMesh& elements, double density);

}  // namespace gnathion

#include "fem/elements.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gnathion {
namespace {

/// The corners of a tet between which the middles lie.
constexpr std::array<std::array<int, 2>, 6> kTetEdges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// Barycentric coordinates of the four points of second order: a at one corner, b at the others.
constexpr double kNear = 0.5854101966249685, kFar = 0.1381966011250105;

}  // namespace

ElementMesh::ElementMesh(const TetMesh& mesh, ElementOrder order)
    : nodes(mesh.vertices), elements(mesh.tets), vertex_count(mesh.vertices.rows()) {
  if (order == ElementOrder::linear) return;
  struct Side {
    int a, b;
    std::int64_t place;  // 6 tet + edge
  };
  std::vector<Side> sides;
  sides.reserve(static_cast<std::size_t>(6 * mesh.tets.rows()));
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    for (int k = 0; k < 6; ++k) {
      const int a = mesh.tets(t, kTetEdges[k][0]), b = mesh.tets(t, kTetEdges[k][1]);
      sides.push_back({std::min(a, b), std::max(a, b), 6 * t + k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return std::tie(p.a, p.b, p.place) < std::tie(q.a, q.b, q.place);
  });
  elements.conservativeResize(Eigen::NoChange, 10);
  for (const Side& side : sides) {
    if (edges.empty() || edges.back() != std::array{side.a, side.b}) {
      edges.push_back({side.a, side.b});
    }
    elements(side.place / 6, 4 + side.place % 6) =
        static_cast<int>(vertex_count + std::ssize(edges)) - 1;
  }
  nodes = from_vertices(mesh.vertices);
}

Points ElementMesh::from_vertices(const Points& field) const {
  Points all(vertex_count + std::ssize(edges), 3);
  all.topRows(vertex_count) = field;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    all.row(vertex_count + static_cast<Eigen::Index>(i)) =
        (field.row(edges[i][0]) + field.row(edges[i][1])) / 2;
  }
  return all;
}

Supports supports_of_nodes(const ElementMesh& mesh, const Supports& of_vertices) {
  Supports supports = of_vertices;
  supports.reserve(static_cast<std::size_t>(mesh.nodes.rows()));
  for (const auto& [a, b] : mesh.edges) {
    supports.push_back(between(of_vertices[a], of_vertices[b]));
  }
  return supports;
}

template <>
IntegrationPoints<4> integration_points<4>(const Points& nodes, const int* element) {
  const LinearTet tet = linear_tet(nodes.row(element[0]), nodes.row(element[1]),
                                   nodes.row(element[2]), nodes.row(element[3]));
  return {{{tet.gradients, tet.volume}}};
}

template <>
IntegrationPoints<10> integration_points<10>(const Points& nodes, const int* element) {
  const LinearTet tet = linear_tet(nodes.row(element[0]), nodes.row(element[1]),
                                   nodes.row(element[2]), nodes.row(element[3]));
  IntegrationPoints<10> points;
  for (int q = 0; q < 4; ++q) {
    std::array<double, 4> at{kFar, kFar, kFar, kFar};
    at[q] = kNear;
    points[q].volume = tet.volume / 4;
    // N_a = (2 L_a − 1) L_a at corners, 4 L_a L_b at middles.
    for (int a = 0; a < 4; ++a) {
      points[q].gradients.row(a) = (4 * at[a] - 1) * tet.gradients.row(a);
    }
    for (int k = 0; k < 6; ++k) {
      const auto [a, b] = kTetEdges[k];
      points[q].gradients.row(4 + k) =
          4 * (at[a] * tet.gradients.row(b) + at[b] * tet.gradients.row(a));
    }
  }
  return points;
}

LinearTet linear_tet(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d) {
  const Eigen::Vector3d e1 = b - a, e2 = c - a, e3 = d - a;
  const Eigen::Vector3d n1 = e2.cross(e3), n2 = e3.cross(e1), n3 = e1.cross(e2);
  const double six_volumes = e1.dot(n1);
  LinearTet tet;
  tet.volume = six_volumes / 6;
  tet.gradients.row(1) = n1 / six_volumes;
  tet.gradients.row(2) = n2 / six_volumes;
  tet.gradients.row(3) = n3 / six_volumes;
  tet.gradients.row(0) = -(tet.gradients.row(1) + tet.gradients.row(2) + tet.gradients.row(3));
  return tet;
}

Eigen::VectorXd lumped_mass(const ElementMesh& mesh, double density) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(mesh.nodes.rows());
  for (const auto& nodes : mesh.elements.rowwise()) {
    const double whole = density * linear_tet(mesh.nodes.row(nodes[0]), mesh.nodes.row(nodes[1]),
                                              mesh.nodes.row(nodes[2]), mesh.nodes.row(nodes[3]))
                                       .volume;
    // ∫N² over the element is V/70 at corners and 8V/105 at middles; their sum is 18V/35.
    const double corner = nodes.size() == 4 ? 0.25 : 1.0 / 36;
    for (Eigen::Index k = 0; k < nodes.size(); ++k) {
      mass[nodes[k]] += whole * (k < 4 ? corner : 4.0 / 27);
    }
  }
  return mass;
}

}  // namespace gnathion

#include "fem/stiffness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "base/error.h"

namespace gnathion {
namespace {

/// The pattern of K: for every node, the nodes it shares a tet with, itself included, ascending.
void set_pattern(const TetMesh& mesh, StiffnessMatrix& K) {
  const auto n = static_cast<std::size_t>(mesh.vertices.rows());
  std::vector<int> first_tet(n + 1, 0);
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    for (int k = 0; k < 4; ++k) ++first_tet[mesh.tets(t, k) + 1];
  }
  for (std::size_t i = 0; i < n; ++i) first_tet[i + 1] += first_tet[i];
  std::vector<int> tets_of(static_cast<std::size_t>(first_tet[n]));
  std::vector<int> next(first_tet.begin(), first_tet.end() - 1);
  for (int t = 0; t < mesh.tets.rows(); ++t) {
    for (int k = 0; k < 4; ++k) tets_of[next[mesh.tets(t, k)]++] = t;
  }
  K.start.assign(1, 0);
  K.start.reserve(n + 1);
  K.column.reserve(n * 16);
  std::vector<int> seen_by(n, -1);
  for (int i = 0; i < static_cast<int>(n); ++i) {
    const std::size_t begin = K.column.size();
    for (int p = first_tet[i]; p < first_tet[i + 1]; ++p) {
      for (int k = 0; k < 4; ++k) {
        const int j = mesh.tets(tets_of[p], k);
        if (seen_by[j] == i) continue;
        seen_by[j] = i;
        K.column.push_back(j);
      }
    }
    std::sort(K.column.begin() + static_cast<std::ptrdiff_t>(begin), K.column.end());
    K.start.push_back(static_cast<int>(K.column.size()));
  }
}

}  // namespace

Points StiffnessMatrix::operator*(const Points& u) const {
  Points f = Points::Zero(u.rows(), 3);
  for (int i = 0; i < node_count(); ++i) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int p = start[i]; p < start[i + 1]; ++p) {
      sum += blocks[p] * u.row(column[p]).transpose();
    }
    f.row(i) = sum;
  }
  return f;
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

StiffnessMatrix stiffness_matrix(const TetMesh& mesh, const ElasticMaterial& material) {
  validate(material);
  const double lambda = material.lame_lambda();
  const double mu = material.shear_modulus();
  StiffnessMatrix K;
  set_pattern(mesh, K);
  K.blocks.assign(K.column.size(), Eigen::Matrix3d::Zero());
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    const auto nodes = mesh.tets.row(t);
    const LinearTet tet = linear_tet(mesh.vertices.row(nodes[0]), mesh.vertices.row(nodes[1]),
                                     mesh.vertices.row(nodes[2]), mesh.vertices.row(nodes[3]));
    if (!(tet.volume > 0)) {
      throw Error(ErrorKind::numeric, "tetrahedral mesh",
                  "tet " + std::to_string(t) + " is inverted or flat (volume " +
                      std::to_string(tet.volume) + " mm3)",
                  "use the robust generator, or a smaller depth");
    }
    for (int a = 0; a < 4; ++a) {
      const Eigen::Vector3d ga = tet.gradients.row(a);
      const auto row_begin = K.column.begin() + K.start[nodes[a]];
      const auto row_end = K.column.begin() + K.start[nodes[a] + 1];
      for (int b = 0; b < 4; ++b) {
        const Eigen::Vector3d gb = tet.gradients.row(b);
        const auto place = std::lower_bound(row_begin, row_end, nodes[b]) - K.column.begin();
        Eigen::Matrix3d& block = K.blocks[static_cast<std::size_t>(place)];
        block += tet.volume * (lambda * ga * gb.transpose() + mu * gb * ga.transpose());
        block.diagonal().array() += tet.volume * mu * ga.dot(gb);
      }
    }
  }
  return K;
}

}  // namespace gnathion

#pragma once

#include <algorithm>
#include <vector>

#include "fem/stiffness.h"

namespace gnathion::testing {

/// The stiffness of quadratic elements whose dilatation is integrated in full, not averaged: what
/// the program would have without its remedy against locking.
inline StiffnessMatrix full_quadratic_stiffness(const ElementMesh& mesh,
                                                const TissueMaterials& materials) {
  StiffnessMatrix K = empty_stiffness(mesh);
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    const int* element = mesh.elements.row(t).data();
    const double lambda = materials[t].lame_lambda(), mu = materials[t].shear_modulus();
    Eigen::Matrix<double, 30, 30> matrix = Eigen::Matrix<double, 30, 30>::Zero();
    for (const IntegrationPoint<10>& point : integration_points<10>(mesh.nodes, element)) {
      for (int a = 0; a < 10; ++a) {
        const Eigen::Vector3d ga = point.volume * point.gradients.row(a);
        for (int b = 0; b < 10; ++b) {
          const Eigen::Vector3d gb = point.gradients.row(b);
          auto block = matrix.block<3, 3>(3 * a, 3 * b);
          block += lambda * ga * gb.transpose() + mu * gb * ga.transpose();
          block.diagonal().array() += mu * ga.dot(gb);
        }
      }
    }
    K.add<10>(element, matrix);
  }
  return K;
}

/// The pattern of a matrix that couples the neighbours of each node with each other.
inline StiffnessMatrix second_neighbours(const StiffnessMatrix& first) {
  StiffnessMatrix K;
  K.start.assign(1, 0);
  std::vector<int> seen_by(static_cast<std::size_t>(first.node_count()), -1);
  for (int i = 0; i < first.node_count(); ++i) {
    for (int p = first.start[i]; p < first.start[i + 1]; ++p) {
      const int a = first.column[p];
      for (int q = first.start[a]; q < first.start[a + 1]; ++q) {
        if (seen_by[first.column[q]] == i) continue;
        seen_by[first.column[q]] = i;
        K.column.push_back(first.column[q]);
      }
    }
    std::sort(K.column.begin() + K.start.back(), K.column.end());
    K.start.push_back(static_cast<int>(K.column.size()));
  }
  K.blocks.assign(K.column.size(), Eigen::Matrix3d::Zero());
  return K;
}

inline Eigen::Matrix3d& block_of(StiffnessMatrix& K, int row, int column) {
  const auto begin = K.column.begin() + K.start[row], end = K.column.begin() + K.start[row + 1];
  return K
      .blocks[static_cast<std::size_t>(std::lower_bound(begin, end, column) - K.column.begin())];
}

/// The stiffness of linear tets of one material with the volumetric strain averaged at the nodes
/// (Bonet and Burton 1998): ½ κ Σ_a V_a θ_a², V_a θ_a = Σ V_e/4 div u over the tets of node a.
inline StiffnessMatrix nodal_averaged_stiffness(const ElementMesh& mesh,
                                                const ElasticMaterial& material) {
  const StiffnessMatrix first = empty_stiffness(mesh);
  StiffnessMatrix K = second_neighbours(first);
  StiffnessMatrix dilatation = first;  // row a: V_a ∂θ_a/∂u on the diagonals of its blocks
  Eigen::VectorXd volume = Eigen::VectorXd::Zero(mesh.nodes.rows());
  const double mu = material.shear_modulus();
  for (const auto nodes : mesh.elements.rowwise()) {
    const IntegrationPoint<4> point = integration_points<4>(mesh.nodes, nodes.data())[0];
    for (const int a : nodes) volume[a] += point.volume / 4;
    for (int a = 0; a < 4; ++a) {
      const Eigen::Vector3d ga = point.volume * point.gradients.row(a);
      for (int b = 0; b < 4; ++b) {
        const Eigen::Vector3d gb = point.gradients.row(b);
        Eigen::Matrix3d& block = block_of(K, nodes[a], nodes[b]);
        block += mu * gb * ga.transpose() - 2 * mu / 3 * ga * gb.transpose();
        block.diagonal().array() += mu * ga.dot(gb);
        block_of(dilatation, nodes[a], nodes[b]).diagonal() += point.volume / 4 * gb;
      }
    }
  }
  for (int a = 0; a < first.node_count(); ++a) {
    for (int p = first.start[a]; p < first.start[a + 1]; ++p) {
      const Eigen::Vector3d di = dilatation.blocks[p].diagonal();
      for (int q = first.start[a]; q < first.start[a + 1]; ++q) {
        block_of(K, first.column[p], first.column[q]) +=
            material.bulk_modulus() / volume[a] * di * dilatation.blocks[q].diagonal().transpose();
      }
    }
  }
  return K;
}

}  // namespace gnathion::testing

#include "fem/stiffness.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "fem/spd_factor.h"

namespace gnathion {
namespace {

template <int m>
using ElementMatrix = Eigen::Matrix<double, 3 * m, 3 * m>;

template <int m>
ElementMatrix<m> element_stiffness(const IntegrationPoints<m>& points,
                                   const ElasticMaterial& material) {
  const double mu = material.shear_modulus();
  ElementMatrix<m> matrix = ElementMatrix<m>::Zero();
  Eigen::Matrix<double, m, 3, Eigen::RowMajor> dilatation =
      Eigen::Matrix<double, m, 3, Eigen::RowMajor>::Zero();
  double volume = 0;
  for (const IntegrationPoint<m>& point : points) {
    volume += point.volume;
    dilatation += point.volume * point.gradients;
    for (int a = 0; a < m; ++a) {
      const Eigen::Vector3d ga = mu * point.volume * point.gradients.row(a);
      for (int b = 0; b < m; ++b) {
        const Eigen::Vector3d gb = point.gradients.row(b);
        auto block = matrix.template block<3, 3>(3 * a, 3 * b);
        block += gb * ga.transpose();
        block.diagonal().array() += ga.dot(gb);
      }
    }
  }
  const Eigen::Map<const Eigen::Matrix<double, 3 * m, 1>> d(dilatation.data());
  matrix.noalias() += (material.lame_lambda() / volume) * d * d.transpose();
  return matrix;
}

template <int m>
void add_elements(const ElementMesh& mesh, const TissueMaterials& materials, StiffnessMatrix& K) {
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    const int* element = mesh.elements.row(t).data();
    const IntegrationPoints<m> points = integration_points<m>(mesh.nodes, element);
    if (!(points[0].volume > 0)) {
      throw Error(ErrorKind::numeric, "tetrahedral mesh",
                  "tet " + std::to_string(t) + " is inverted or flat (volume " +
                      std::to_string(points[0].volume * points.size()) + " mm3)",
                  "use the robust generator, or a smaller depth");
    }
    K.add<m>(element, element_stiffness<m>(points, materials[t]));
  }
}

}  // namespace

StiffnessMatrix empty_stiffness(const ElementMesh& mesh) {
  const auto n = static_cast<std::size_t>(mesh.nodes.rows());
  const Eigen::Index m = mesh.elements.cols();
  std::vector<int> first_element(n + 1, 0);
  for (const int node : mesh.elements.reshaped<Eigen::RowMajor>()) ++first_element[node + 1];
  for (std::size_t i = 0; i < n; ++i) first_element[i + 1] += first_element[i];
  std::vector<int> elements_of(static_cast<std::size_t>(first_element[n]));
  std::vector<int> next(first_element.begin(), first_element.end() - 1);
  for (int t = 0; t < mesh.elements.rows(); ++t) {
    for (Eigen::Index k = 0; k < m; ++k) elements_of[next[mesh.elements(t, k)]++] = t;
  }
  StiffnessMatrix K;
  K.start.assign(1, 0);
  K.start.reserve(n + 1);
  K.column.reserve(n * 16);
  std::vector<int> seen_by(n, -1);
  for (int i = 0; i < static_cast<int>(n); ++i) {
    const std::size_t begin = K.column.size();
    for (int p = first_element[i]; p < first_element[i + 1]; ++p) {
      for (Eigen::Index k = 0; k < m; ++k) {
        const int j = mesh.elements(elements_of[p], k);
        if (seen_by[j] == i) continue;
        seen_by[j] = i;
        K.column.push_back(j);
      }
    }
    std::sort(K.column.begin() + static_cast<std::ptrdiff_t>(begin), K.column.end());
    K.start.push_back(static_cast<int>(K.column.size()));
  }
  K.blocks.assign(K.column.size(), Eigen::Matrix3d::Zero());
  return K;
}

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

template <int m>
void StiffnessMatrix::add(const int* element, const Eigen::Matrix<double, 3 * m, 3 * m>& matrix) {
  for (int a = 0; a < m; ++a) {
    const auto row_begin = column.begin() + start[element[a]];
    const auto row_end = column.begin() + start[element[a] + 1];
    for (int b = 0; b < m; ++b) {
      const auto place = std::lower_bound(row_begin, row_end, element[b]) - column.begin();
      blocks[static_cast<std::size_t>(place)] += matrix.template block<3, 3>(3 * a, 3 * b);
    }
  }
}
template void StiffnessMatrix::add<4>(const int*, const Eigen::Matrix<double, 12, 12>&);
template void StiffnessMatrix::add<10>(const int*, const Eigen::Matrix<double, 30, 30>&);

StiffnessMatrix stiffness_matrix(const ElementMesh& mesh, const TissueMaterials& materials) {
  validate(materials, mesh.elements.rows());
  StiffnessMatrix K = empty_stiffness(mesh);
  if (mesh.order() == ElementOrder::linear) {
    add_elements<4>(mesh, materials, K);
  } else {
    add_elements<10>(mesh, materials, K);
  }
  return K;
}

namespace {

/// For each node its place among those with a free part, −1 for the others.
std::vector<int> free_index(const StiffnessMatrix& K, const FreePart& free) {
  std::vector<int> index(static_cast<std::size_t>(K.node_count()), -1);
  for (std::size_t i = 0; i < free.nodes().size(); ++i) {
    index[free.nodes()[i]] = static_cast<int>(i);
  }
  return index;
}

}  // namespace

Eigen::SparseMatrix<double> free_stiffness(const StiffnessMatrix& K, const FreePart& free) {
  const std::vector<int> index = free_index(K, free);
  const std::vector<int>& first = free.first();
  Eigen::SparseMatrix<double> lower(free.size(), free.size());
  int* start = lower.outerIndexPtr();
  start[0] = 0;
  // Column first[i]+axis holds, of node i's own block, the rows from axis on, and all rows of the
  // blocks of later nodes.
  for (std::size_t i = 0; i < free.nodes().size(); ++i) {
    const int node = free.nodes()[i];
    int below = 0;
    for (int p = K.start[node]; p < K.start[node + 1]; ++p) {
      const int j = index[K.column[p]];
      if (j > static_cast<int>(i)) below += first[j + 1] - first[j];
    }
    for (int c = first[i]; c < first[i + 1]; ++c)
      start[c + 1] = start[c] + first[i + 1] - c + below;
  }
  lower.resizeNonZeros(start[free.size()]);
  for (std::size_t i = 0; i < free.nodes().size(); ++i) {
    const int node = free.nodes()[i];
    std::array<int, 3> next{};
    for (int c = first[i]; c < first[i + 1]; ++c) next[c - first[i]] = start[c];
    for (int p = K.start[node]; p < K.start[node + 1]; ++p) {
      const int j = index[K.column[p]];
      if (j < static_cast<int>(i)) continue;
      // Block (i, j) is the transpose of block (j, i).
      const auto block = (free.frame(i).transpose() * K.blocks[p] * free.frame(j)).eval();
      for (int a = 0; a < block.rows(); ++a) {
        for (int b = j == static_cast<int>(i) ? a : 0; b < block.cols(); ++b) {
          lower.innerIndexPtr()[next[a]] = first[j] + b;
          lower.valuePtr()[next[a]++] = block(a, b);
        }
      }
    }
  }
  return lower;
}

std::vector<int> elimination_order(const StiffnessMatrix& K, const FreePart& free) {
  const std::vector<int> index = free_index(K, free);
  std::vector<int> start(1, 0), column, order;
  for (const int node : free.nodes()) {
    for (int p = K.start[node]; p < K.start[node + 1]; ++p) {
      if (index[K.column[p]] != -1) column.push_back(index[K.column[p]]);
    }
    start.push_back(static_cast<int>(column.size()));
  }
  for (const int i : nested_dissection(start, column)) {
    for (int c = free.first()[i]; c < free.first()[i + 1]; ++c) order.push_back(c);
  }
  return order;
}

}  // namespace gnathion

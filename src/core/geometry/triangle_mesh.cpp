#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "base/error.h"

namespace gnathion {
namespace {

Eigen::Vector3d scaled_normal(const TriangleMesh& mesh, Eigen::Index f) {
  const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(f, 0));
  const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(f, 1));
  const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(f, 2));
  return (b - a).cross(c - a);
}

/// Disjoint sets with path halving.
class DisjointSets {
 public:
  explicit DisjointSets(Eigen::Index n) : parent_(static_cast<std::size_t>(n)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int i, int j) { parent_[find(i)] = find(j); }

 private:
  std::vector<int> parent_;
};

}  // namespace

Points triangle_normals(const TriangleMesh& mesh) {
  Points normals(mesh.triangles.rows(), 3);
  for (Eigen::Index f = 0; f < normals.rows(); ++f) {
    normals.row(f) = scaled_normal(mesh, f).stableNormalized();
  }
  return normals;
}

Points vertex_normals(const TriangleMesh& mesh) {
  Points normals = Points::Zero(mesh.vertices.rows(), 3);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::Vector3d n = scaled_normal(mesh, f).stableNormalized();
    for (int corner = 0; corner < 3; ++corner) {
      const int v = mesh.triangles(f, corner);
      const Eigen::Vector3d p = mesh.vertices.row(v);
      const Eigen::Vector3d q = mesh.vertices.row(mesh.triangles(f, (corner + 1) % 3));
      const Eigen::Vector3d r = mesh.vertices.row(mesh.triangles(f, (corner + 2) % 3));
      const Eigen::Vector3d e = q - p;
      const Eigen::Vector3d g = r - p;
      normals.row(v) += std::atan2(e.cross(g).norm(), e.dot(g)) * n.transpose();
    }
  }
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    normals.row(v) = normals.row(v).stableNormalized().eval();
  }
  return normals;
}

std::vector<Edge> edges_of(const TriangleMesh& mesh, const std::string& name) {
  std::vector<Edge> edges;
  edges.reserve(static_cast<std::size_t>(mesh.triangles.rows()) * 2);
  std::unordered_map<std::uint64_t, int> index_of;
  index_of.reserve(static_cast<std::size_t>(mesh.triangles.rows()) * 2);
  const auto key = [](int a, int b) {
    const auto low = static_cast<std::uint64_t>(std::min(a, b));
    return low << 32U | static_cast<std::uint64_t>(std::max(a, b));
  };
  for (int f = 0; f < mesh.triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int a = mesh.triangles(f, corner);
      const int b = mesh.triangles(f, (corner + 1) % 3);
      const auto [place, is_new] = index_of.try_emplace(key(a, b), static_cast<int>(edges.size()));
      if (is_new) {
        edges.push_back({a, b, f, -1});
        continue;
      }
      Edge& edge = edges[place->second];
      if (edge.right != -1 || edge.a == a) {
        throw Error(ErrorKind::anatomy, name,
                    "the surface is not an oriented two-manifold at the edge between vertices " +
                        std::to_string(a) + " and " + std::to_string(b),
                    "mend the mesh (remove doubled or flipped triangles) and load it again");
      }
      edge.right = f;
    }
  }
  return edges;
}

std::vector<bool> rim_vertices(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
  std::vector<bool> rim(static_cast<std::size_t>(mesh.vertices.rows()), false);
  for (const Edge& edge : edges) {
    if (edge.right == -1) rim[edge.a] = rim[edge.b] = true;
  }
  return rim;
}

std::vector<int> triangle_components(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.rows());
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    sets.join(mesh.triangles(f, 0), mesh.triangles(f, 1));
    sets.join(mesh.triangles(f, 1), mesh.triangles(f, 2));
  }
  std::vector<int> number(static_cast<std::size_t>(mesh.vertices.rows()), -1);
  std::vector<int> component(static_cast<std::size_t>(mesh.triangles.rows()));
  int count = 0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    int& of_root = number[sets.find(mesh.triangles(f, 0))];
    if (of_root == -1) of_root = count++;
    component[f] = of_root;
  }
  return component;
}

SubMesh sub_mesh(const TriangleMesh& mesh, const std::vector<bool>& keep) {
  SubMesh part;
  std::vector<int> new_index(static_cast<std::size_t>(mesh.vertices.rows()), -1);
  for (int f = 0; f < mesh.triangles.rows(); ++f) {
    if (!keep[f]) continue;
    part.parent_triangle.push_back(f);
    for (int corner = 0; corner < 3; ++corner) new_index[mesh.triangles(f, corner)] = 0;
  }
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    if (new_index[v] == -1) continue;
    new_index[v] = static_cast<int>(part.parent_vertex.size());
    part.parent_vertex.push_back(v);
  }
  part.mesh.vertices = mesh.vertices(part.parent_vertex, Eigen::all);
  part.mesh.triangles = mesh.triangles(part.parent_triangle, Eigen::all).unaryExpr([&](int v) {
    return new_index[v];
  });
  return part;
}

std::vector<std::vector<int>> vertex_neighbours(const TriangleMesh& mesh) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(mesh.vertices.rows()));
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int a = mesh.triangles(f, corner);
      const int b = mesh.triangles(f, (corner + 1) % 3);
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
  }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

double signed_volume(const TriangleMesh& mesh) {
  if (mesh.vertices.rows() == 0) return 0;
  // About the mesh's own middle: far from the origin the sum would cancel digits.
  const Eigen::RowVector3d middle = mesh.vertices.colwise().mean();
  double six_times = 0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(f, 0)) - middle;
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(f, 1)) - middle;
    const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(f, 2)) - middle;
    six_times += a.dot(b.cross(c));
  }
  return six_times / 6;
}

Eigen::Vector3d centre_of_volume(const TriangleMesh& mesh) {
  const Eigen::RowVector3d middle = mesh.vertices.colwise().mean();
  Eigen::RowVector3d moment = Eigen::RowVector3d::Zero();
  double six_times = 0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.triangles(f, 0)) - middle;
    const Eigen::RowVector3d b = mesh.vertices.row(mesh.triangles(f, 1)) - middle;
    const Eigen::RowVector3d c = mesh.vertices.row(mesh.triangles(f, 2)) - middle;
    const double volume = a.dot(b.cross(c));
    moment += volume * (a + b + c) / 4;
    six_times += volume;
  }
  return (middle + moment / six_times).transpose();
}

double surface_area(const TriangleMesh& mesh) {
  double twice = 0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) twice += scaled_normal(mesh, f).norm();
  return twice / 2;
}

double mean_edge_length(const TriangleMesh& mesh) {
  double sum = 0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      sum += (mesh.vertices.row(mesh.triangles(f, corner)) -
              mesh.vertices.row(mesh.triangles(f, (corner + 1) % 3)))
                 .norm();
    }
  }
  return mesh.triangles.rows() == 0 ? 0 : sum / static_cast<double>(3 * mesh.triangles.rows());
}

std::vector<bool> widened(const std::vector<bool>& flags,
                          const std::vector<std::vector<int>>& neighbours) {
  std::vector<bool> wide = flags;
  for (std::size_t v = 0; v < flags.size(); ++v) {
    if (!flags[v]) continue;
    for (const int w : neighbours[v]) wide[w] = true;
  }
  return wide;
}

}  // namespace gnathion

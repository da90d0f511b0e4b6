#include "tissue/hidden.h"

#include <cmath>
#include <numbers>

#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

constexpr int kDirections = 40;
constexpr double kReach = 60;   // mm: farther walls are another part of the body
constexpr double kStart = 0.2;  // mm: off the triangles of the vertex itself

/// Evenly spread directions around +z, up to 80° from it (a Fibonacci spiral).
std::vector<Eigen::Vector3d> directions_around_z() {
  std::vector<Eigen::Vector3d> directions;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  const double lowest = std::cos(80 * std::numbers::pi / 180);
  for (int k = 0; k < kDirections; ++k) {
    const double z = 1 - (1 - lowest) * (k + 0.5) / kDirections;
    const double r = std::sqrt(1 - z * z);
    directions.emplace_back(r * std::cos(turn * k), r * std::sin(turn * k), z);
  }
  return directions;
}

}  // namespace

PocketSearch::PocketSearch(const TriangleMesh& surface)
    : tree_(surface),
      places_(surface.vertices),
      normals_(vertex_normals(surface)),
      around_(directions_around_z()) {}

bool PocketSearch::is_hidden(int vertex) const {
  const Eigen::Vector3d n = normals_.row(vertex);
  const Eigen::Vector3d x = places_.row(vertex);
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), n);
  int open = 0;
  for (const Eigen::Vector3d& d : around_) {
    open += !tree_.first_hit(x + kStart * n, turn * d, kReach).has_value();
    if (10 * open > kDirections) return false;
  }
  return true;
}

std::vector<bool> hidden_vertices(const TriangleMesh& surface, const std::vector<bool>& asked) {
  const PocketSearch pockets(surface);
  std::vector<bool> hidden(asked.size(), false);
  for (std::size_t v = 0; v < asked.size(); ++v) {
    hidden[v] = asked[v] && pockets.is_hidden(static_cast<int>(v));
  }
  return hidden;
}

}  // namespace gnathion

#include "geometry/section_chains.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace gnathion {
namespace {

using EdgeKey = std::uint64_t;

/// A triangle's part of the section, between the edges where it begins and ends.
struct Piece {
  EdgeKey begin, end;
  bool taken = false;
};

EdgeKey key_of(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return (static_cast<EdgeKey>(low) << 32) | static_cast<EdgeKey>(high);
}

double length(const Points& chain) {
  const Eigen::Index n = chain.rows();
  return (chain.bottomRows(n - 1) - chain.topRows(n - 1)).rowwise().norm().sum();
}

class Section {
 public:
  Section(const TriangleMesh& mesh, const Eigen::Vector3d& origin, const Eigen::Vector3d& normal)
      : mesh_(mesh), height_((mesh.vertices.rowwise() - origin.transpose()) * normal) {
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) cut(t);
    for (std::size_t p = 0; p < pieces_.size(); ++p) starting_at_[pieces_[p].begin].push_back(p);
  }

  std::vector<Points> chains() {
    std::unordered_set<EdgeKey> ends;
    for (const Piece& piece : pieces_) ends.insert(piece.end);
    std::vector<Points> all;
    // Open chains from where they begin, then what is left: closed ones.
    for (const bool closed : {false, true}) {
      for (std::size_t p = 0; p < pieces_.size(); ++p) {
        if (pieces_[p].taken || (!closed && ends.count(pieces_[p].begin) > 0)) continue;
        all.push_back(chain_from(p));
      }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Points& a, const Points& b) { return length(a) > length(b); });
    return all;
  }

 private:
  void cut(Eigen::Index t) {
    Piece piece{};
    bool is_cut = false;
    for (int c = 0; c < 3; ++c) {
      const int a = mesh_.triangles(t, c), b = mesh_.triangles(t, (c + 1) % 3);
      const bool above_a = height_[a] >= 0, above_b = height_[b] >= 0;
      if (above_a == above_b) continue;
      is_cut = true;
      (above_a ? piece.begin : piece.end) = key_of(a, b);
    }
    if (is_cut) pieces_.push_back(piece);
  }

  Eigen::RowVector3d point_on(EdgeKey edge) const {
    const auto a = static_cast<Eigen::Index>(edge >> 32);
    const auto b = static_cast<Eigen::Index>(edge & 0xffffffffU);
    const double w = height_[a] / (height_[a] - height_[b]);
    return (1 - w) * mesh_.vertices.row(a) + w * mesh_.vertices.row(b);
  }

  /// A piece not yet taken that begins at `edge`, or none.
  const std::size_t* next_at(EdgeKey edge) const {
    const auto found = starting_at_.find(edge);
    if (found == starting_at_.end()) return nullptr;
    for (const std::size_t& candidate : found->second) {
      if (!pieces_[candidate].taken) return &candidate;
    }
    return nullptr;
  }

  Points chain_from(std::size_t first) {
    std::vector<EdgeKey> edges{pieces_[first].begin};
    for (const std::size_t* piece = &first; piece != nullptr; piece = next_at(edges.back())) {
      pieces_[*piece].taken = true;
      edges.push_back(pieces_[*piece].end);
    }
    Points points(static_cast<Eigen::Index>(edges.size()), 3);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      points.row(static_cast<Eigen::Index>(i)) = point_on(edges[i]);
    }
    return points;
  }

  const TriangleMesh& mesh_;
  Eigen::VectorXd height_;  ///< of the vertices over the plane
  std::vector<Piece> pieces_;
  std::unordered_map<EdgeKey, std::vector<std::size_t>> starting_at_;
};

}  // namespace

std::vector<Points> section_chains(const TriangleMesh& mesh, const Eigen::Vector3d& origin,
                                   const Eigen::Vector3d& normal) {
  return Section(mesh, origin, normal).chains();
}

}  // namespace gnathion

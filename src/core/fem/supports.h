#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "geometry/mesh_types.h"
#include "geometry/rigid_motion.h"

namespace gnathion {

/// What holds or moves a node (paper, 4.3.2; sliding is ours).
struct Support {
  enum Kind : unsigned char {
    free,      ///< moves as the elastic forces say
    fixed,     ///< does not move
    attached,  ///< moves with a bone segment
    sliding,   ///< follows bone along the bone's normal only: mucosa over teeth and gums
  };
  static constexpr int kUnmoved = -1;  ///< the body that is the skull: for sliding over it

  Kind kind = free;
  int body = 0;  ///< attached, sliding: which moving segment, or kUnmoved
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< sliding: of the bone, unit, LPS

  Support() = default;
  Support(Kind of_kind, int on_body = 0) : kind(of_kind), body(on_body) {}
  static Support slides(const Eigen::Vector3d& bone_normal, int on_body) {
    Support support(sliding, on_body);
    support.normal = bone_normal;
    return support;
  }
  /// Whether it is of this kind.
  bool operator==(Kind other) const { return kind == other; }
};

/// How a mesh of n nodes is held: one Support a node.
using Supports = std::vector<Support>;

/// The support of a point half way between two.
Support between(const Support& a, const Support& b);

/// Where the bones bring the nodes that are tied to them: (R−I) x + t at attached and sliding nodes
/// of body b with motions[b], zero elsewhere. nodes: n×3, mm, LPS. Returns n×3, mm; of a sliding
/// node only the component along its normal is prescribed.
Points bone_displacements(const Points& nodes, const Supports& supports,
                          std::span<const RigidMotion> motions);

/// What of the displacements u the supports prescribe: u at attached nodes, its component along the
/// normal at sliding ones, zero at the others. n×3.
Points prescribed_part(const Supports& supports, const Points& u);

/// The free part of the displacements of n nodes: u = u_prescribed + Q q, where q has three entries
/// for a free node, two (along the bone) for a sliding one, none for the others. Q's columns are
/// orthonormal.
class FreePart {
 public:
  FreePart() = default;
  explicit FreePart(const Supports& supports);

  Eigen::Index size() const { return first_.empty() ? 0 : first_.back(); }  ///< entries of q
  /// The mesh's index of each node with free entries, ascending, and the first of its entries; one
  /// more entry than nodes.
  const std::vector<int>& nodes() const { return nodes_; }
  const std::vector<int>& first() const { return first_; }

  /// Qᵀ f for each column. f: 3n×k, row 3i+axis. Returns size()×k.
  Eigen::MatrixXd gather(const Eigen::MatrixXd& f) const;
  Eigen::VectorXd gather(const Points& f) const;
  /// u += factor Q q for each column. q: size()×k, u: 3n×k.
  void add(const Eigen::MatrixXd& q, Eigen::MatrixXd& u) const;
  void add(const Eigen::VectorXd& q, double factor, Points& u) const;
  /// 3×k_i block of Q for the i-th node of nodes().
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> frame(std::size_t i) const;

 private:
  std::vector<int> nodes_;
  std::vector<int> first_;
  std::vector<Eigen::Matrix<double, 3, 2>> tangents_;  ///< of the sliding nodes
  std::vector<int> tangent_of_;  ///< nodes().size(): row of tangents_, −1 for free nodes
};

}  // namespace gnathion

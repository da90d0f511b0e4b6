#include "fem/supports.h"

#include <Eigen/Geometry>

namespace gnathion {
namespace {

/// The bone that a node is on; free nodes have none.
int bone_of(const Support& support) {
  return support == Support::fixed ? Support::kUnmoved : support.body;
}

}  // namespace

Support between(const Support& a, const Support& b) {
  if (a == Support::free || b == Support::free || bone_of(a) != bone_of(b)) return {};
  if (a == Support::sliding && b == Support::sliding) {
    const Eigen::Vector3d sum = a.normal.dot(b.normal) < 0 ? Eigen::Vector3d(a.normal - b.normal)
                                                           : Eigen::Vector3d(a.normal + b.normal);
    return Support::slides(sum.normalized(), a.body);
  }
  return a == Support::sliding ? a : b;
}

Points bone_displacements(const Points& nodes, const Supports& supports,
                          std::span<const RigidMotion> motions) {
  Points u = Points::Zero(nodes.rows(), 3);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const Support& support = supports[i];
    const bool tied = support == Support::attached || support == Support::sliding;
    if (!tied || support.body == Support::kUnmoved) continue;
    const RigidMotion& motion = motions[support.body];
    const auto row = static_cast<Eigen::Index>(i);
    const Eigen::Vector3d x = nodes.row(row);
    u.row(row) = motion.rotation * x + motion.translation - x;
  }
  return u;
}

Points prescribed_part(const Supports& supports, const Points& u) {
  Points part = Points::Zero(u.rows(), 3);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (supports[i] == Support::attached) part.row(row) = u.row(row);
    if (supports[i] == Support::sliding) {
      part.row(row) = u.row(row).dot(supports[i].normal) * supports[i].normal;
    }
  }
  return part;
}

FreePart::FreePart(const Supports& supports) : first_{0} {
  for (int i = 0; i < static_cast<int>(supports.size()); ++i) {
    const Support& support = supports[i];
    if (support == Support::fixed || support == Support::attached) continue;
    nodes_.push_back(i);
    const bool slides = support == Support::sliding;
    first_.push_back(first_.back() + (slides ? 2 : 3));
    tangent_of_.push_back(slides ? static_cast<int>(tangents_.size()) : -1);
    if (!slides) continue;
    const Eigen::Vector3d one = support.normal.unitOrthogonal();
    tangents_.emplace_back();
    tangents_.back() << one, support.normal.cross(one);
  }
}

Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> FreePart::frame(std::size_t i) const {
  if (tangent_of_[i] == -1) return Eigen::Matrix3d::Identity();
  return tangents_[tangent_of_[i]];
}

Eigen::MatrixXd FreePart::gather(const Eigen::MatrixXd& f) const {
  Eigen::MatrixXd q(size(), f.cols());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto block = f.middleRows<3>(3 * nodes_[i]);
    if (tangent_of_[i] == -1) {
      q.middleRows<3>(first_[i]) = block;
    } else {
      q.middleRows<2>(first_[i]).noalias() = tangents_[tangent_of_[i]].transpose() * block;
    }
  }
  return q;
}

Eigen::VectorXd FreePart::gather(const Points& f) const {
  Eigen::VectorXd q(size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto row = f.row(nodes_[i]).transpose();
    if (tangent_of_[i] == -1) {
      q.segment<3>(first_[i]) = row;
    } else {
      q.segment<2>(first_[i]).noalias() = tangents_[tangent_of_[i]].transpose() * row;
    }
  }
  return q;
}

void FreePart::add(const Eigen::MatrixXd& q, Eigen::MatrixXd& u) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    auto block = u.middleRows<3>(3 * nodes_[i]);
    if (tangent_of_[i] == -1) {
      block += q.middleRows<3>(first_[i]);
    } else {
      block.noalias() += tangents_[tangent_of_[i]] * q.middleRows<2>(first_[i]);
    }
  }
}

void FreePart::add(const Eigen::VectorXd& q, double factor, Points& u) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    auto row = u.row(nodes_[i]).transpose();
    if (tangent_of_[i] == -1) {
      row += factor * q.segment<3>(first_[i]);
    } else {
      row.noalias() += factor * (tangents_[tangent_of_[i]] * q.segment<2>(first_[i]));
    }
  }
}

}  // namespace gnathion

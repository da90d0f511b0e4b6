#pragma once

#include <Eigen/Core>

#include "phantom/head_model.h"

namespace gnathion {

/// The colours of the head's skin: brows, open eyes, lips, hairline, and a mole on the patient's
/// left cheek (x > 0), the only thing that tells left from right.
class FacePaint {
 public:
  FacePaint(const HeadModel& head, unsigned seed);

  /// sRGB in 0..1 at a point on the skin, LPS mm.
  Eigen::Vector3d colour(const Eigen::Vector3d& p) const;

  /// Centre of the mole on the skin, LPS mm.
  const Eigen::Vector3d& mole() const { return mole_; }

 private:
  Eigen::Vector3d skin_tone(const Eigen::Vector3d& p) const;
  void paint_lips(const Eigen::Vector3d& p, Eigen::Vector3d& colour) const;
  void paint_eye(const Eigen::Vector3d& p, Eigen::Vector3d& colour) const;
  void paint_hair(const Eigen::Vector3d& p, Eigen::Vector3d& colour) const;

  unsigned seed_;
  Eigen::Vector3d mole_;
};

}  // namespace gnathion

#pragma once

#include <Eigen/Core>
#include <vector>

#include "phantom/distance_functions.h"

namespace gnathion {

/// An adult head as signed distance functions: negative inside, mm. Frame: LPS mm (x to the
/// patient's left, y backwards, z up); the origin lies between the ear canals on the Frankfort
/// plane. Mirror-symmetric but for two things that tell left from right: a raised mole on the left
/// cheek and a nasal septum that bends to the left. All members are const and may be called from
/// any thread.
class HeadModel {
 public:
  using Point = distance::Point;

  HeadModel();

  /// The outer surface, lips and lids closed, ears included.
  double skin(const Point& p) const;
  /// Cranium, midface, arches and upper teeth, with the maxillary sinuses and the brain's cavity.
  double skull(const Point& p) const;
  /// The mandible with the lower teeth, at least joint_gap mm from the skull everywhere.
  double mandible(const Point& p) const;
  /// Cervical vertebrae, joined with neither.
  double spine(const Point& p) const;
  /// The least of skull, mandible and spine.
  double bone(const Point& p) const;
  /// Crowns and roots of all teeth; they are part of skull and mandible too.
  double teeth(const Point& p) const;
  double brain(const Point& p) const;
  double eyeballs(const Point& p) const;
  /// Nasal cavity, pharynx and sinuses: closed, never reaching the skin.
  double airway(const Point& p) const;
  /// Masseter, temporalis, tongue and lip muscle.
  double muscle(const Point& p) const;
  /// Depth of the subcutaneous fat below the skin at p, mm.
  double fat_depth(const Point& p) const;

  /// Outward unit normal of the skin by central differences.
  Point skin_normal(const Point& p) const;

  static constexpr double joint_gap = 3.2;

 private:
  struct Tooth {
    Point edge;               ///< middle of the cutting edge
    Eigen::Vector2d outward;  ///< in the x,y plane, towards lips or cheek
    double width;             ///< along the arch
    double edge_thickness;    ///< from lip side to tongue side at the edge
    double neck_thickness;    ///< the same at the gum
    double crown;             ///< height of the crown
    double root;              ///< length of the root
    double up;                ///< +1: the root points up (upper jaw), −1: down
  };
  static std::vector<Tooth> make_row(bool upper);
  static double tooth(const Point& p, const Tooth& t);
  double row(const Point& p, const std::vector<Tooth>& teeth) const;
  double alveolar_process(const Point& p, bool upper) const;
  double mandible_bone(const Point& p) const;
  double cranium_outer(const Point& p) const;
  double cranium(const Point& p) const;
  double midface(const Point& p) const;
  double cheekbone(const Point& p) const;
  double orbit(const Point& p) const;
  double nasal_cavity(const Point& p) const;

  std::vector<Tooth> upper_;  ///< the left half (x > 0) of the row
  std::vector<Tooth> lower_;
};

}  // namespace gnathion

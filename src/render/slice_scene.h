#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/plane_section.h"
#include "geometry/rigid_motion.h"
#include "imaging/ct_slice.h"

namespace gnathion {

/// The Hounsfield units that are spread over the greys.
struct HuWindow {
  double level = 500;   ///< HU of the middle grey
  double width = 2500;  ///< HU from black to white, at least 2

  bool operator==(const HuWindow&) const = default;
};
inline constexpr HuWindow bone_window{500, 2500};
inline constexpr HuWindow soft_tissue_window{50, 400};
inline constexpr HuWindow skin_window{-300, 1000};  ///< the skin against the air before it

/// The window within what a volume can hold: level −2000..6000, width 2..8000 HU.
HuWindow limited(HuWindow window);

/// 0 black … 255 white, by DICOM's linear function (PS3.3 C.11.2.1.2.1), rounded to the nearest.
/// \pre window.width >= 2.
std::uint8_t grey_of(double hu, const HuWindow& window);

/// Greys of a slice, as many as its pixels; black outside the volume. `greys` is reused.
void grey_slice(const CtSlice& slice, const HuWindow& window, std::vector<std::uint8_t>& greys);

/// Where a slice cuts a surface.
struct SliceContour {
  std::string name;
  Eigen::Vector3d colour;                             ///< RGB, 0..1
  std::vector<std::array<Eigen::Vector2d, 2>> lines;  ///< picture mm (picture_from_lps())
};

/// What slices are taken of: a CT, and surfaces that are outlined in its pictures. It draws
/// nothing; whoever shows a slice asks for its pixels and lines. Shares what it is given.
class SliceScene {
 public:
  /// Removes all surfaces of the volume before.
  void set_volume(std::shared_ptr<const CtVolume> volume);
  bool has_volume() const { return volume_ != nullptr; }
  /// \pre has_volume(), also of those below.
  const CtVolume& volume() const { return *volume_; }
  const SliceLattice& lattice() const { return lattice_; }

  /// Adds or replaces a surface, at rest (mm, LPS). Contours come in the order of the names' first
  /// appearance, so that the last lies on top. surface: made ready on whatever thread, shared.
  void set_surface(const std::string& name, std::shared_ptr<const PlaneSection> surface,
                   const Eigen::Vector3d& colour);
  /// Ignored for a name that the scene does not have. points: n×3, mm, LPS.
  void set_surface_points(const std::string& name, const Points& points);
  /// Likewise. A pose is applied to the points as they are.
  void set_surface_pose(const std::string& name, const RigidMotion& pose);
  void set_surface_visible(const std::string& name, bool visible);
  void remove_surfaces();
  /// The part of the volume that a picture should show: around the surfaces as they were given (a
  /// scanner's table is left out), all of it where there are none. Mm, LPS.
  LpsBox subject() const;

  /// The slice through `lps`, mm.
  void cut(SlicePlane plane, const Eigen::Vector3d& lps, CtSlice& slice) const;
  std::vector<SliceContour> contours(SlicePlane plane, const Eigen::Vector3d& lps) const;

 private:
  struct Surface {
    std::string name;
    std::shared_ptr<const PlaneSection> section;
    Eigen::Vector3d colour;
    RigidMotion pose;
    bool visible = true;
  };
  Surface* find(const std::string& name);

  std::shared_ptr<const CtVolume> volume_;
  SliceLattice lattice_;
  std::vector<Surface> surfaces_;
  Eigen::AlignedBox3d around_;  ///< the surfaces, mm, LPS
};

}  // namespace gnathion

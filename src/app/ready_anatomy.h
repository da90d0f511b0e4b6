#pragma once

#include <memory>
#include <vector>

#include "geometry/plane_section.h"
#include "prediction/anatomy.h"
#include "render/ready_surface.h"

namespace gnathion {

/// What the views show of an anatomy, made beside the window: publishing a case then only hands it
/// over.
struct ReadyAnatomy {
  std::shared_ptr<const ReadyFace> face;
  std::shared_ptr<const ReadyBone> skull;                  ///< the remainder
  std::vector<std::shared_ptr<const ReadyBone>> segments;  ///< in the anatomy's order
  std::vector<Triangles> coarse_segments;                  ///< likewise, over their vertices
  std::shared_ptr<const PlaneSection> face_section, skull_section;
  std::vector<std::shared_ptr<const PlaneSection>> segment_sections;
};

/// The anatomy's face with its textures. For any thread. Throws Error(input) as ready_face().
std::shared_ptr<const ReadyFace> ready_face_of(const Anatomy& anatomy);

/// Some tenths of a second for half a million triangles. For any thread.
/// \pre face is ready_face_of(*anatomy).
std::shared_ptr<const ReadyAnatomy> ready_anatomy(const std::shared_ptr<const Anatomy>& anatomy,
                                                  std::shared_ptr<const ReadyFace> face);

}  // namespace gnathion

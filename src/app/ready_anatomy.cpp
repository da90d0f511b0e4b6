#include "app/ready_anatomy.h"

#include <utility>

#include "render/coarse_surface.h"

namespace gnathion {

std::shared_ptr<const ReadyFace> ready_face_of(const Anatomy& anatomy) {
  const Face& face = anatomy.face;
  return ready_face(face.mesh, face.document.path().string(), face.document.vertex_colours());
}

std::shared_ptr<const ReadyAnatomy> ready_anatomy(const std::shared_ptr<const Anatomy>& anatomy,
                                                  std::shared_ptr<const ReadyFace> face) {
  const auto section = [&anatomy](const TriangleMesh& mesh) {
    return std::make_shared<const PlaneSection>(
        std::shared_ptr<const TriangleMesh>(anatomy, &mesh));
  };
  auto ready = std::make_shared<ReadyAnatomy>();
  ready->face = std::move(face);
  ready->face_section = section(anatomy->face.mesh.surface);
  ready->skull =
      ready_bone(anatomy->remainder, "skull", coarse_triangles(anatomy->remainder, kQuickSkull));
  ready->skull_section = section(anatomy->remainder);
  for (const BoneSegment& segment : anatomy->segments) {
    ready->coarse_segments.push_back(coarse_triangles(segment.mesh, kQuickSegment));
    ready->segments.push_back(
        ready_bone(segment.mesh, segment.name, ready->coarse_segments.back()));
    ready->segment_sections.push_back(section(segment.mesh));
  }
  return ready;
}

}  // namespace gnathion

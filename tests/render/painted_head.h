#pragma once

#include <filesystem>

#include "geometry/mesh_types.h"

namespace gnathion::test {

/// An egg of a head with a nose, about 150 × 190 × 230 mm, centre at the origin, LPS. Made of
/// quads (triangulated) with a texture seam on the left side, 30° behind the ear, so that the
/// three-quarter view runs across it. Two materials: the painted one, and a plain cap. The paint:
/// a checker, eyes, a red mouth, the letter L on the patient's left cheek and a red mark on the
/// left temple; nothing is symmetric about the midline.
/// The texture is written to `folder`/paint.png.
TexturedMesh painted_head(const std::filesystem::path& folder);

/// An ellipsoid of the given half axes (mm) as a plain surface.
TriangleMesh ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& half_axes);

}  // namespace gnathion::test

#pragma once

#include <filesystem>
#include <string>

#include "geometry/mesh_types.h"

namespace gnathion {

/// Binary PLY, LPS mm, single precision (1e-5 mm at this size). Throws Error(output).
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path);

/// Binary STL, LPS mm, single precision; what STL cannot say stands in its header of 80 bytes, that
/// it is LPS and mm among it. what: a name for the surface, cut where the header ends. Throws
/// Error(output).
void write_stl(const TriangleMesh& mesh, const std::string& what,
               const std::filesystem::path& path);

/// VTK's unstructured grid (.vtu) with double precision; displacements (n×3, mm), when there are
/// any, as a point array. Throws Error(output).
void write_vtu(const TetMesh& mesh, const Points& displacements, const std::filesystem::path& path);

}  // namespace gnathion

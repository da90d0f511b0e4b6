#pragma once

#include <filesystem>
#include <string>

#include "io/obj_document.h"

namespace gnathion {

// Scans leave in their own frame and unit: the numbers of the file, though glTF's own unit is the
// metre. vertices: n×3, the document's, moved or not.

/// Writes `name` into an existing folder, in the format that its ending says: .obj (as
/// ObjDocument::write, textures beside it), .glb or .ply. Throws Error(output); Error(input) for a
/// texture that cannot be read.
void write_scan(const ObjDocument& document, const Points& vertices,
                const std::filesystem::path& folder, const std::string& name);

/// Binary PLY, one file: the document's vertices in order in double precision, vertex colours (its
/// own, else its textures' where each vertex first appears, else its materials'), triangles.
void write_scan_ply(const ObjDocument& document, const Points& vertices,
                    const std::filesystem::path& file);

/// Binary glTF 2.0, one file: a part a material, split where texture coordinates are (glTF has one
/// a vertex), positions in single precision, JPEG and PNG pictures byte for byte, others as PNG.
void write_scan_glb(const ObjDocument& document, const Points& vertices,
                    const std::filesystem::path& file);

}  // namespace gnathion

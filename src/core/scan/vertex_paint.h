#pragma once

#include "io/obj_document.h"

namespace gnathion {

/// n×3, sRGB 0..1, one a vertex of the document: its own colours, else its textures' (nearest
/// pixel, where the vertex first appears in a triangle), else its materials'. Throws Error(input)
/// naming a texture that cannot be read.
Points vertex_paint(const ObjDocument& document);

}  // namespace gnathion

#pragma once

namespace gnathion {

/// Looks up OpenGL's functions for VTK in the current OSMesa context. false: GLEW failed.
bool load_opengl_functions();

}  // namespace gnathion

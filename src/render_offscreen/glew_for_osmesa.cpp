// A file of its own: GLEW's header must come first and leaves the macros undefined that OSMesa's
// header needs.
#include <vtk_glew.h>

#include "offscreen/glew_for_osmesa.h"

namespace gnathion {

bool load_opengl_functions() {
  glewExperimental = GL_TRUE;
  const GLenum answer = glewInit();
  // Without an X server GLEW says "no GLX display", after it has loaded all of OpenGL.
  constexpr GLenum no_glx_display = 4;
  return answer == GLEW_OK || answer == no_glx_display;
}

}  // namespace gnathion

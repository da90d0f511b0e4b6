#include "render/in_front.h"

#include <vtkActor.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace gnathion {

void allow_in_front(vtkActor* actor) {
  // The tag stays: VTK's own passes put their code after it.
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Depth::Impl", true,
      "gl_FragDepth = depth_factor * gl_FragCoord.z;\n//VTK::Depth::Impl\n", false);
  set_in_front(actor, true);
}

void set_in_front(vtkActor* actor, bool in_front) {
  // What the camera sees begins well behind a hundredth of its range of depth.
  actor->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("depth_factor",
                                                                       in_front ? 0.01F : 1.0F);
}

}  // namespace gnathion

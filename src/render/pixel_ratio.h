#pragma once

class vtkRenderer;

namespace gnathion {

/// Pixels of the picture a logical one: more than 1 on screens of high resolution, and 1 outside a
/// window. Lines, dots and grips are sized by it when they are attached; VTK's words grow on their
/// own.
double pixel_ratio(vtkRenderer* renderer);

}  // namespace gnathion

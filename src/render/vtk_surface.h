#pragma once

#include <vtkCellArray.h>
#include <vtkSmartPointer.h>

#include "geometry/mesh_types.h"

namespace gnathion {

/// VTK's copy of a triangle list.
vtkSmartPointer<vtkCellArray> cells_of(const Triangles& triangles);

}  // namespace gnathion

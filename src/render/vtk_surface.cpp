#include "render/vtk_surface.h"

#include <algorithm>

#include <vtkNew.h>
#include <vtkTypeInt64Array.h>

namespace gnathion {

vtkSmartPointer<vtkCellArray> cells_of(const Triangles& triangles) {
  vtkNew<vtkTypeInt64Array> corners;
  corners->SetNumberOfValues(triangles.size());
  std::copy(triangles.data(), triangles.data() + triangles.size(), corners->GetPointer(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(3, corners);
  return cells;
}

}  // namespace gnathion

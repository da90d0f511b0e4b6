#include "render/coarse_surface.h"

#include <vtkDecimatePro.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "render/vtk_surface.h"

namespace gnathion {
namespace {

constexpr const char* row_name = "row";

vtkSmartPointer<vtkPolyData> with_rows(const TriangleMesh& surface) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> rows;
  rows->SetName(row_name);
  points->SetNumberOfPoints(surface.vertices.rows());
  rows->SetNumberOfValues(surface.vertices.rows());
  for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i) {
    points->SetPoint(i, surface.vertices.row(i).data());
    rows->SetValue(i, i);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells_of(surface.triangles));
  data->GetPointData()->AddArray(rows);
  return data;
}

}  // namespace

Triangles coarse_triangles(const TriangleMesh& surface, int wanted) {
  const Eigen::Index count = surface.triangles.rows();
  if (count <= wanted) return surface.triangles;
  // vtkDecimatePro removes vertices, and copies some where it splits, but moves none: the row that
  // each carries stays true.
  vtkNew<vtkDecimatePro> decimate;
  decimate->SetInputData(with_rows(surface));
  decimate->SetTargetReduction(1 - static_cast<double>(wanted) / static_cast<double>(count));
  decimate->PreserveTopologyOff();
  decimate->SplittingOn();
  decimate->BoundaryVertexDeletionOn();
  decimate->Update();
  vtkPolyData* coarse = decimate->GetOutput();
  auto* rows = vtkIdTypeArray::SafeDownCast(coarse->GetPointData()->GetArray(row_name));
  if (!rows || coarse->GetNumberOfPolys() == 0) return surface.triangles;
  Triangles triangles(coarse->GetNumberOfPolys(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    vtkIdType corner_count = 0;
    const vtkIdType* corners = nullptr;
    coarse->GetPolys()->GetCellAtId(t, corner_count, corners);
    for (int c = 0; c < 3; ++c) {
      triangles(t, c) = static_cast<int>(rows->GetValue(corners[c]));
    }
  }
  return triangles;
}

}  // namespace gnathion

#include "io/mesh_files.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>

#include "base/error.h"

namespace gnathion {
namespace {

vtkNew<vtkPoints> to_vtk(const Points& vertices) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(vertices.rows());
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) points->SetPoint(i, vertices.row(i).data());
  return points;
}

template <typename Cells>
vtkNew<vtkCellArray> to_vtk_cells(const Cells& cells) {
  vtkNew<vtkCellArray> array;
  for (Eigen::Index c = 0; c < cells.rows(); ++c) {
    array->InsertNextCell(static_cast<int>(cells.cols()));
    for (const int v : cells.row(c)) array->InsertCellPoint(v);
  }
  return array;
}

template <typename Writer>
void write(Writer& writer, const std::filesystem::path& path) {
  writer.SetFileName(path.c_str());
  if (writer.Write() == 0 || writer.GetErrorCode() != 0) {
    throw Error(ErrorKind::output, path.string(), "it cannot be written",
                "check free space and rights");
  }
}

}  // namespace

void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path) {
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(to_vtk(mesh.vertices));
  surface->SetPolys(to_vtk_cells(mesh.triangles));
  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileTypeToBinary();
  write(*writer.Get(), path);
}

void write_vtu(const TetMesh& mesh, const Points& displacements,
               const std::filesystem::path& path) {
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(to_vtk(mesh.vertices));
  grid->SetCells(VTK_TETRA, to_vtk_cells(mesh.tets));
  if (displacements.rows() == mesh.vertices.rows()) {
    vtkNew<vtkDoubleArray> array;
    array->SetName("displacement_mm");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(displacements.rows());
    std::copy_n(displacements.data(), displacements.size(), array->GetPointer(0));
    grid->GetPointData()->AddArray(array);
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  write(*writer.Get(), path);
}

}  // namespace gnathion

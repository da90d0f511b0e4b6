#include "io/mesh_files.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "io/files.h"

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

template <typename Number>
void append(std::string& bytes, Number number) {
  static_assert(std::endian::native == std::endian::little, "the headers below say so");
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

}  // namespace

void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment LPS, mm\nelement vertex " +
                      std::to_string(mesh.vertices.rows()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(mesh.triangles.rows()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    for (const double x : mesh.vertices.row(v)) append(bytes, static_cast<float>(x));
  }
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    append(bytes, static_cast<unsigned char>(3));
    for (const int v : mesh.triangles.row(f)) append(bytes, v);
  }
  write_text_file(path, bytes);
}

void write_stl(const TriangleMesh& mesh, const std::string& what,
               const std::filesystem::path& path) {
  constexpr std::size_t header_bytes = 80;
  // A header that begins with "solid" would be taken for a text STL.
  std::string bytes = "Gnathion, unit mm, frame LPS (+x left, +y back, +z up): " + what;
  bytes.resize(header_bytes, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.rows()));
  const Points normals = triangle_normals(mesh);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (const double x : normals.row(f)) append(bytes, static_cast<float>(x));
    for (const int v : mesh.triangles.row(f)) {
      for (const double x : mesh.vertices.row(v)) append(bytes, static_cast<float>(x));
    }
    append(bytes, static_cast<std::uint16_t>(0));
  }
  write_text_file(path, bytes);
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
  // Through a text in memory: VTK prints what fails in a file.
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) {
    throw Error(ErrorKind::output, path.string(), "VTK cannot write this mesh",
                "report this as a fault of the program");
  }
  write_text_file(path, writer->GetOutputString());
}

}  // namespace gnathion

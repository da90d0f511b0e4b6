#include "io/mesh_files.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

using test::TemporaryFolder;

TEST(Ply, HasAllPointsInSinglePrecisionAndAllTriangles) {
  TriangleMesh mesh{Points(4, 3), Triangles(3, 3)};
  mesh.vertices << 0.1, -304.123456, 345, 3, 0, 1e-7, 0, 3, -2, 250.7, 3, 1. / 3;
  mesh.triangles << 0, 1, 2, 1, 3, 2, 0, 2, 3;
  const TemporaryFolder folder;
  const auto file = folder / "Knochen groß.ply";
  write_ply(mesh, file);
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfPoints(), 4);
  ASSERT_EQ(read->GetNumberOfCells(), 3);
  for (int v = 0; v < 4; ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(read->GetPoint(v)[axis], static_cast<float>(mesh.vertices(v, axis)));
    }
  }
  for (int f = 0; f < 3; ++f) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(read->GetCell(f)->GetPointId(k), mesh.triangles(f, k));
    }
  }
}

class Vtu : public ::testing::Test {
 protected:
  Vtu() : mesh_{Points(5, 3), Tets(2, 4)} {
    mesh_.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1, 1. / 3, 1 + 1e-15;
    mesh_.tets << 0, 1, 2, 3, 1, 2, 3, 4;
  }
  vtkUnstructuredGrid* written(const Points& displacements) {
    write_vtu(mesh_, displacements, folder_ / "tissue.vtu");
    reader_->SetFileName((folder_ / "tissue.vtu").c_str());
    reader_->Update();
    return reader_->GetOutput();
  }
  TetMesh mesh_;
  TemporaryFolder folder_;
  vtkNew<vtkXMLUnstructuredGridReader> reader_;
};

TEST_F(Vtu, KeepsTetsAndDoublesToTheBit) {
  const Points u = Points::Random(5, 3) / 3;
  vtkUnstructuredGrid* read = written(u);
  ASSERT_EQ(read->GetNumberOfPoints(), 5);
  ASSERT_EQ(read->GetNumberOfCells(), 2);
  vtkDataArray* array = read->GetPointData()->GetArray("displacement_mm");
  ASSERT_NE(array, nullptr);
  for (int v = 0; v < 5; ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(read->GetPoint(v)[axis], mesh_.vertices(v, axis));
      EXPECT_EQ(array->GetComponent(v, axis), u(v, axis));
    }
  }
  for (int t = 0; t < 2; ++t) {
    ASSERT_EQ(read->GetCellType(t), VTK_TETRA);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(read->GetCell(t)->GetPointId(k), mesh_.tets(t, k));
  }
}

TEST_F(Vtu, HasNoDisplacementsWhereNoneAreGiven) {
  EXPECT_EQ(written({})->GetPointData()->GetNumberOfArrays(), 0);
}

TEST_F(Vtu, AndPlyRefuseAPlaceThatCannotBeWritten) {
  TriangleMesh surface{mesh_.vertices, Triangles(1, 3)};
  surface.triangles << 0, 1, 2;
  std::vector<std::filesystem::path> places{folder_ / "none/file"};
  if (std::filesystem::exists("/dev/full")) places.emplace_back("/dev/full");
  ::testing::internal::CaptureStderr();
  for (const auto& place : places) {
    test::expect_error(ErrorKind::output, {place.string()}, [&] { write_vtu(mesh_, {}, place); });
    test::expect_error(ErrorKind::output, {place.string()}, [&] { write_ply(surface, place); });
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "VTK speaks beside our message";
}

}  // namespace
}  // namespace gnathion

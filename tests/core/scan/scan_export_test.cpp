#include "scan/scan_export.h"

#include <gtest/gtest.h>

#include "core/scan/scan_files.h"
#include "scan/scan_repairs.h"
#include "support/expect_error.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::picture_bytes;
using test::read;
using test::TemporaryFolder;

/// Two materials, a seam, a split vertex and one that is in no face.
const std::string kObj =
    "mtllib a.mtl\nv 0 0 0\nv 1000.125 0 0\nv 1 1 0\nv 0 1 0.5\nv 0 0 0\nv 7 7 7\n"
    "vt 0.25 0.75\nvt 0.75 0.75\nvt 0.75 0.25\nvt 0.25 0.25\nvt 0 0.5\n"
    "usemtl skin\nf 1/1 2/2 3/3\nusemtl lip\nf 5/5 3/3 4/4\n";

ObjDocument document_in(const TemporaryFolder& folder, const std::string& picture = ".png") {
  folder.write("a.mtl",
               "newmtl skin\nKd 1 1 1\nmap_Kd skin" + picture + "\nnewmtl lip\nKd 0.5 0.25 1\n");
  folder.write("skin" + picture, picture_bytes(picture));
  return read(folder.write("a.obj", kObj));
}

/// Corner by corner, since each format numbers vertices and coordinates its own way.
void expect_same_corners(const TexturedMesh& a, const TexturedMesh& b, bool with_texture) {
  ASSERT_EQ(a.surface.triangles.rows(), b.surface.triangles.rows());
  for (Eigen::Index f = 0; f < a.surface.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(a.surface.vertices.row(a.surface.triangles(f, k)),
                b.surface.vertices.row(b.surface.triangles(f, k)));
      if (!with_texture) continue;
      EXPECT_EQ(a.texture_coordinates.row(a.corner_texture(f, k)),
                b.texture_coordinates.row(b.corner_texture(f, k)));
    }
  }
}

TEST(WriteScan, AsGlbIsReadBackTheSame) {
  const TemporaryFolder folder;
  const ObjDocument document = document_in(folder);
  Points x = document.mesh().surface.vertices;
  x(3, 2) = 0.75;
  write_scan(document, x, folder.path(), "out.GLB");
  const ObjDocument back = read(folder / "out.GLB");
  TexturedMesh moved = document.mesh();
  moved.surface.vertices = x;
  expect_same_corners(moved, back.mesh(), true);
  ASSERT_EQ(back.mesh().materials.size(), 2U);
  EXPECT_EQ(back.mesh().materials[0].name, "skin");
  EXPECT_EQ(bytes_of(back.mesh().materials[0].texture), picture_bytes(".png"));
  EXPECT_TRUE(back.mesh().materials[1].diffuse.isApprox(Eigen::Vector3d(0.5, 0.25, 1), 1e-6));
  EXPECT_EQ(back.mesh().triangle_material, (std::vector<int>{0, 1}));
}

TEST(WriteScan, AsGlbPutsOtherPicturesInAsPng) {
  const TemporaryFolder folder;
  const ObjDocument document = document_in(folder, ".tiff");
  write_scan(document, document.mesh().surface.vertices, folder.path(), "out.glb");
  const ObjDocument back = read(folder / "out.glb");
  const cv::Mat before = cv::imread((folder / "skin.tiff").string()),
                after = cv::imread(back.mesh().materials[0].texture.string());
  ASSERT_EQ(before.size(), after.size());
  EXPECT_EQ(cv::norm(before, after), 0);
}

TEST(WriteScan, AsPlyKeepsOrderAndPaintsVerticesFromTheTexture) {
  const TemporaryFolder folder;
  const ObjDocument document = document_in(folder);
  write_scan(document, document.mesh().surface.vertices, folder.path(), "out.ply");
  const ObjDocument back = read(folder / "out.ply");
  EXPECT_EQ(back.mesh().surface.vertices, document.mesh().surface.vertices);
  EXPECT_EQ(back.mesh().surface.triangles, document.mesh().surface.triangles);
  EXPECT_EQ(back.vertex_colours().row(0), Eigen::RowVector3d(1, 0, 0)) << "upper left: red";
  EXPECT_EQ(back.vertex_colours().row(1), Eigen::RowVector3d(0, 1, 0));
  EXPECT_EQ(back.vertex_colours().row(2), Eigen::RowVector3d(1, 1, 1));
  EXPECT_NEAR(back.vertex_colours()(3, 2), 1, 1e-12) << "the lip's own colour";
}

TEST(WriteScan, KeepsVertexColours) {
  const TemporaryFolder folder;
  const ObjDocument document =
      read(folder.write("a.obj", "v 0 0 0 0.2 0.4 0.6\nv 1 0 0 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n"));
  for (const char* name : {"b.ply", "b.glb"}) {
    write_scan(document, document.mesh().surface.vertices, folder.path(), name);
    const ObjDocument back = read(folder / name);
    EXPECT_TRUE(back.vertex_colours().isApprox(document.vertex_colours(), 1e-6)) << name;
  }
}

TEST(WriteScan, AsObjIsTheDocumentsOwnWay) {
  const TemporaryFolder folder;
  const ObjDocument document = document_in(folder);
  fs::create_directory(folder / "out");
  write_scan(document, document.mesh().surface.vertices, folder / "out", "b.obj");
  EXPECT_EQ(bytes_of(folder / "out/b.obj"), kObj);
}

TEST(WriteScan, SaysWhatItCannotWrite) {
  const TemporaryFolder folder;
  const ObjDocument document = document_in(folder);
  const Points& x = document.mesh().surface.vertices;
  test::expect_error(ErrorKind::output, {"a.fbx", ".glb"},
                     [&] { write_scan(document, x, folder.path(), "a.fbx"); });
  test::expect_error(ErrorKind::output, {"none/a.glb"},
                     [&] { write_scan(document, x, folder / "none", "a.glb"); });
  folder.write("skin.png", "no picture");
  test::expect_error(ErrorKind::input, {"skin.png"},
                     [&] { write_scan(document, x, folder.path(), "a.ply"); });
}

TEST(RawScanOfADocument, IsTheDocumentAgain) {
  const TemporaryFolder folder;
  const ObjDocument document = document_in(folder);
  const ObjDocument again = ObjDocument::of_scan(folder / "a.obj", raw_scan(document));
  EXPECT_EQ(again.mesh().surface.vertices, document.mesh().surface.vertices);
  expect_same_corners(document.mesh(), again.mesh(), true);
  EXPECT_EQ(again.mesh().materials[0].texture, document.mesh().materials[0].texture);
}

}  // namespace
}  // namespace gnathion

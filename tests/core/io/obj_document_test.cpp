#include "io/obj_document.h"

#include <gtest/gtest.h>

#include <sstream>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::expect_error;
using test::TemporaryFolder;

const std::string two_materials =
    "newmtl skin\nKd 0.9 0.7 0.6\nmap_Kd skin tone.png\n"
    "newmtl lips\nKd 1 0 0\n";

/// A quad and a triangle with a seam (vertex 2 has two vt), groups, two materials, vertex colours.
const std::string textured =
    "# scanned\n"
    "mtllib my mats.mtl\n"
    "o face\n"
    "v 0 0 0 0.9 0.8 0.7\n"
    "v  1.0\t0 -0.0 0.9 0.8 0.7\n"
    "v 1e0 1 0.50 0.9 0.8 0.7\n"
    "v 0 1 0 0.9 0.8 0.7\n"
    "v +2 0.5 0 0.9 0.8 0.7\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.25 0.125\nvt 0.5 0.5\n"
    "vn 0 0 1\n"
    "g cheek left\nusemtl skin\ns 1\n"
    "f 1/1/1 2/2/1 3/3/1 4/4/1\n"
    "g lip\nusemtl lips\n"
    "f 2/5/1 -1/6/1 3/3/1\n";

fs::path write_textured(const TemporaryFolder& folder, const std::string& text = textured) {
  folder.write("in/my mats.mtl", two_materials);
  folder.write("in/skin tone.png", std::string("\x89PNG\r\n\0\x1a", 8));
  return folder.write("in/face.obj", text);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

ObjDocument read_text(const std::string& text) {
  const TemporaryFolder folder;
  return ObjDocument::read(folder.write("face.obj", text));
}

TEST(ObjDocument, ReadsQuadsSeamsGroupsMaterialsAndColours) {
  const TemporaryFolder folder;
  const ObjDocument document = ObjDocument::read(write_textured(folder));
  const TexturedMesh& mesh = document.mesh();
  ASSERT_EQ(mesh.surface.vertices.rows(), 5);
  ASSERT_EQ(mesh.surface.triangles.rows(), 3);
  EXPECT_EQ(mesh.surface.vertices.row(2), Eigen::RowVector3d(1, 1, 0.5));
  EXPECT_EQ(mesh.surface.vertices.row(4), Eigen::RowVector3d(2, 0.5, 0));
  EXPECT_EQ(mesh.surface.triangles.row(2), Eigen::RowVector3i(1, 4, 2));
  EXPECT_EQ(mesh.texture_coordinates.rows(), 6);
  EXPECT_EQ(mesh.corner_texture.row(2), Eigen::RowVector3i(4, 5, 2)) << "the seam is lost";
  EXPECT_EQ(mesh.triangle_material, (std::vector<int>{0, 0, 1}));
  ASSERT_EQ(mesh.materials.size(), 2U);
  EXPECT_EQ(mesh.materials[0].name, "skin");
  EXPECT_EQ(mesh.materials[0].texture, folder / "in/skin tone.png");
  EXPECT_EQ(mesh.materials[1].texture, fs::path());
  EXPECT_EQ(mesh.materials[1].diffuse, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(document.files(),
            (std::vector<fs::path>{folder / "in/face.obj", folder / "in/my mats.mtl",
                                   folder / "in/skin tone.png"}));
}

TEST(ObjDocument, WithoutMotionTheTextIsTheSameToTheByte) {
  const TemporaryFolder folder;
  const ObjDocument document = ObjDocument::read(write_textured(folder));
  EXPECT_EQ(document.text_with(document.mesh().surface.vertices), textured);
}

TEST(ObjDocument, WithMotionOnlyTheNumbersOfMovedVerticesDiffer) {
  const TemporaryFolder folder;
  const ObjDocument document = ObjDocument::read(write_textured(folder));
  Points moved = document.mesh().surface.vertices;
  moved.row(1) << 1. / 3, 0.1, -2e-7;
  moved(4, 2) = 8;
  const std::vector<std::string> before = lines_of(textured),
                                 after = lines_of(document.text_with(moved));
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i == 4) {
      EXPECT_EQ(after[i], "v  0.3333333333333333 0.1 -2e-07 0.9 0.8 0.7");
    } else if (i == 7) {
      EXPECT_EQ(after[i], "v 2 0.5 8 0.9 0.8 0.7");
    } else {
      EXPECT_EQ(after[i], before[i]);
    }
  }
  EXPECT_EQ(read_text(document.text_with(moved).substr(29)).mesh().surface.vertices, moved)
      << "the numbers do not come back to the bit";
}

TEST(ObjDocument, CopiesMaterialsAndTexturesToTheByte) {
  const TemporaryFolder folder;
  const ObjDocument document = ObjDocument::read(write_textured(folder));
  fs::create_directory(folder / "out");
  document.write(folder / "out", "predicted.obj", document.mesh().surface.vertices);
  EXPECT_EQ(bytes_of(folder / "out/predicted.obj"), textured);
  EXPECT_EQ(bytes_of(folder / "out/my mats.mtl"), two_materials);
  EXPECT_EQ(bytes_of(folder / "out/skin tone.png"), std::string("\x89PNG\r\n\0\x1a", 8));
  EXPECT_NO_THROW(ObjDocument::read(folder / "out/predicted.obj"));
}

TEST(ObjDocument, KeepsWindowsLineEnds) {
  const TemporaryFolder folder;
  std::string text = textured, materials = two_materials;
  for (std::string* t : {&text, &materials}) {
    for (std::size_t at = 0; (at = t->find('\n', at)) != std::string::npos; at += 2) {
      t->insert(at, "\r");
    }
  }
  const fs::path file = write_textured(folder, text);
  folder.write("in/my mats.mtl", materials);
  const ObjDocument document = ObjDocument::read(file);
  EXPECT_EQ(document.mesh().materials.at(0).texture, folder / "in/skin tone.png");
  EXPECT_EQ(document.mesh().triangle_material, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(document.text_with(document.mesh().surface.vertices), text);
  Points moved = document.mesh().surface.vertices;
  moved.array() += 1;
  const std::string changed = document.text_with(moved);
  EXPECT_NE(changed.find("v 1 1 1 0.9 0.8 0.7\r\n"), std::string::npos);
  EXPECT_EQ(std::count(changed.begin(), changed.end(), '\r'),
            std::count(text.begin(), text.end(), '\r'));
}

TEST(ObjDocument, ReadsALastLineWithoutAnEnd) {
  EXPECT_EQ(read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").mesh().surface.triangles.rows(), 1);
  const std::string late = "v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0";
  const ObjDocument document = read_text(late);
  EXPECT_EQ(document.text_with(document.mesh().surface.vertices), late);
}

TEST(ObjDocument, SplitVerticesAreOneToTheSurfaceAndMoveTogether) {
  const std::string split =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\n"
      "f 1 2 3 4\nf 5 7 6\n";
  const ObjDocument document = read_text(split);
  const TriangleMesh& surface = document.mesh().surface;
  ASSERT_EQ(surface.vertices.rows(), 7) << "rows are the file's";
  EXPECT_EQ(surface.triangles.row(2), Eigen::RowVector3i(1, 6, 2));
  EXPECT_EQ(edges_of(surface).size(), 7U) << "the seam is open";
  Points moved = surface.vertices;
  moved.row(1) << 1, 0, 5;
  EXPECT_EQ(document.text_with(moved),
            "v 0 0 0\nv 1 0 5\nv 1 1 0\nv 0 1 0\nv 1 0 5\nv 1 1 0\nv 2 0 0\n"
            "f 1 2 3 4\nf 5 7 6\n");
}

TEST(ObjDocument, WithoutMaterialsHasNone) {
  const ObjDocument document = read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(document.mesh().materials.empty());
  EXPECT_EQ(document.mesh().triangle_material, std::vector<int>{-1});
  EXPECT_EQ(document.mesh().corner_texture.row(0), Eigen::RowVector3i(-1, -1, -1));
}

TEST(ObjDocument, OfASurfaceReadsBackToTheBit) {
  TriangleMesh surface{Points(4, 3), Triangles(2, 3)};
  surface.vertices << 0.1, -304.123456789, 1. / 3, 1, 0, 1e-17, 0, 1, -2.5e10, 1, 1, 0;
  surface.triangles << 0, 1, 2, 1, 3, 2;
  const ObjDocument document = ObjDocument::of_surface(surface, "skin");
  EXPECT_EQ(document.mesh().surface.vertices, surface.vertices);
  EXPECT_EQ(document.mesh().surface.triangles, surface.triangles);
  const TemporaryFolder folder;
  document.write(folder.path(), "face.obj", surface.vertices);
  EXPECT_EQ(ObjDocument::read(folder / "face.obj").mesh().surface.vertices, surface.vertices);
}

/// A bad file and what the message must name beside it.
struct BadObj {
  const char* text;
  std::vector<std::string> parts;
};

TEST(ObjDocument, RefusesDamagedFilesNamingTheLine) {
  const std::string start = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\n";
  for (const BadObj& bad : std::vector<BadObj>{
           {"f 1 2 5\n", {"line 6", "5", "only 4"}},
           {"f 1 2 3\nf 2 3 9\n", {"line 7", "9"}},
           {"f 1 2 3 9\nf 1 2 3\n", {"line 6", "9"}},  // a quad, which tinyobjloader drops
           {"f 1 2 3 4 9\nf 1 2 3\n", {"line 6", "9"}},
           {"f 0 1 2\n", {"line 6"}},
           {"f 1 2 -5\n", {"line 6"}},
           {"f 1 2 3\nf 1 2 -9 4\n", {"line 7"}},
           {"f 1/1 2/2 3/1\n", {"line 6", "texture"}},
           {"f 1/1 2/-2 3/1\n", {"line 6", "texture"}},
           {"f 1/1 2/0 3/1\n", {"line 6", "texture"}},
           {"f 1 2 three\n", {"line 6"}},
           {"f 1 2\n", {"line 6", "3"}},
           {"vt 0,5 1\nf 1/1 2/2 3/1\n", {"line 6", "not a finite number"}},
           {"vt nan 1\nf 1/1 2/2 3/1\n", {"line 6", "not a finite number"}},
           {"v nan 0 0\nf 1 2 3\n", {"line 6", "not a finite number"}},
           {"v 1 inf 0\nf 1 2 3\n", {"line 6", "not a finite number"}},
           {"v 0,5 1 2\nf 1 2 3\n", {"line 6", "not a finite number"}},
           {"v 1 2\nf 1 2 3\n", {"line 6", "not a finite number"}},
           {"v 1 2 1e999\nf 1 2 3\n", {"line 6", "not a finite number"}},
           {"f 1 2 3\ng a\nf 1 2 4 5\ng b\nv 2 2 2\n", {"before its vertices"}},
           {"", {"no faces"}},
           {"l 1 2\np 1\n", {"no faces"}}}) {
    SCOPED_TRACE(bad.text);
    std::vector<std::string> parts = bad.parts;
    parts.emplace_back("face.obj");
    expect_error(ErrorKind::input, parts, [&] { read_text(start + bad.text); });
  }
}

TEST(ObjDocument, RefusesWhatIsNoObj) {
  const TemporaryFolder folder;
  expect_error(ErrorKind::input, {"none.obj"}, [&] { ObjDocument::read(folder / "none.obj"); });
  expect_error(ErrorKind::input, {"face.obj", "empty"}, [] { read_text(""); });
  expect_error(ErrorKind::input, {"face.obj", "no vertices"},
               [] { read_text("solid stl\nendsolid\n"); });
  expect_error(ErrorKind::input, {"face.obj", "no vertices"},
               [] { read_text(std::string("ply\n\0\x01\x02", 7)); });
}

TEST(ObjDocument, RefusesAMissingMaterialFileOrTextureByName) {
  const TemporaryFolder folder;
  const fs::path file = write_textured(folder);
  fs::remove(folder / "in/skin tone.png");
  expect_error(ErrorKind::input, {"skin tone.png"}, [&] { ObjDocument::read(file); });
  fs::remove(folder / "in/my mats.mtl");
  expect_error(ErrorKind::input, {"my mats.mtl", "face.obj"}, [&] { ObjDocument::read(file); });
}

TEST(ObjDocument, RefusesATextureOutsideItsFolderBeforeAnythingIsPredicted) {
  const TemporaryFolder folder;
  folder.write("elsewhere/skin.png", "picture");
  folder.write("in/a.mtl", "newmtl skin\nmap_Kd ../elsewhere/skin.png\n");
  const fs::path obj = folder.write(
      "in/face.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl skin\nf 1 2 3\n");
  expect_error(ErrorKind::input, {"skin.png", "outside its own folder"},
               [&] { ObjDocument::read(obj); });
}

TEST(ObjDocument, NeverOverwritesAFileOfTheFolder) {
  const TemporaryFolder folder;
  const ObjDocument document = ObjDocument::read(write_textured(folder));
  folder.write("out/skin tone.png", "ours");
  expect_error(ErrorKind::output, {"skin tone.png", "another name"}, [&] {
    document.write(folder.path() / "out", "predicted.obj", document.mesh().surface.vertices);
  });
  EXPECT_EQ(bytes_of(folder.path() / "out/skin tone.png"), "ours");
}

TEST(ObjDocument, TheRealScanReadsMovesAndReadsAgain) {
  const fs::path scan = fs::path(GNATHION_SHARED_DATA) / "face-scan";
  if (!fs::exists(scan)) GTEST_SKIP() << "no shared data here";
  const ObjDocument document = ObjDocument::read(scan / "LeePerrySmith.obj");
  const TriangleMesh& surface = document.mesh().surface;
  ASSERT_EQ(surface.vertices.rows(), 8838);
  EXPECT_EQ(surface.triangles.rows(), 17672);
  EXPECT_EQ(document.mesh().texture_coordinates.rows(), 9218);
  EXPECT_EQ(document.mesh().materials.size(), 1U);
  EXPECT_EQ(document.text_with(surface.vertices), bytes_of(scan / "LeePerrySmith.obj"));
  const std::vector<Edge> edges = edges_of(surface);
  const std::vector<bool> rim = rim_vertices(surface, edges);
  EXPECT_EQ(std::count(rim.begin(), rim.end(), true), 0) << "the scan is closed";

  Points moved = surface.vertices;
  for (Eigen::Index v = 0; v < moved.rows(); ++v) {
    if (moved(v, 1) < 0) moved.row(v) += Eigen::RowVector3d(0.01, -0.001, 1. / 7);
  }
  const TemporaryFolder folder;
  document.write(folder.path(), "predicted.obj", moved);
  const ObjDocument again = ObjDocument::read(folder / "predicted.obj");
  EXPECT_EQ(again.mesh().surface.vertices, moved);
  // A quad is cut along its shorter diagonal, which may be the other one after the motion.
  EXPECT_EQ(again.mesh().surface.triangles.rows(), surface.triangles.rows());
  EXPECT_EQ(again.mesh().texture_coordinates, document.mesh().texture_coordinates);
  EXPECT_EQ(bytes_of(folder / "Map-COL.jpg"), bytes_of(scan / "Map-COL.jpg"));
  const auto before = lines_of(bytes_of(scan / "LeePerrySmith.obj")),
             after = lines_of(bytes_of(folder / "predicted.obj"));
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].rfind("v ", 0) == 0) continue;
    EXPECT_EQ(after[i], before[i]);
  }
}

}  // namespace
}  // namespace gnathion

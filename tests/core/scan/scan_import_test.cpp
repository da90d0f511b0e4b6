#include "scan/scan_import.h"

#include <gtest/gtest.h>

#include <assimp/scene.h>
#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <thread>

#include "core/scan/binary_fbx.h"
#include "core/scan/scan_files.h"
#include "geometry/triangle_mesh.h"
#include "support/expect_error.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::picture_bytes;
using test::raw;
using test::read;
using test::SquareGltf;
using test::TemporaryFolder;

const std::string kPlyHeader =
    "ply\nformat ascii 1.0\ncomment TextureFile my skin.png\n"
    "element vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
    "end_header\n";
const std::string kPly = kPlyHeader +
                         "0 0 0 255 0 0\n0.1 0 0 0 255 0\n0.1 1 0.123456789012345 0 0 255\n"
                         "0 1 0 1 2 3\n0 0 0 9 9 9\n"
                         "4 0 1 2 3 8 0 0 1 0 1 1 0 1\n3 4 2 3 6 0.5 0.5 1 1 0 1\n";

TEST(ReadScan, OfAPlyKeepsOrderDoublesColoursCornersAndItsPicture) {
  const TemporaryFolder folder;
  folder.write("my skin.png", picture_bytes(".png"));
  const ObjDocument document = read(folder.write("face of Ä.ply", kPly));
  const TexturedMesh& mesh = document.mesh();
  ASSERT_EQ(mesh.surface.vertices.rows(), 5);
  EXPECT_EQ(mesh.surface.vertices(2, 2), 0.123456789012345);
  // The diagonals are 1.0 each but for z: 0–2 is the longer one.
  const Triangles wanted = (Triangles(3, 3) << 0, 1, 3, 1, 2, 3, 0, 2, 3).finished();
  EXPECT_EQ(mesh.surface.triangles, wanted) << "vertex 4 lies where vertex 0 does";
  EXPECT_EQ(document.vertex_colours().row(3), Eigen::RowVector3d(1, 2, 3) / 255);
  ASSERT_EQ(mesh.materials.size(), 1U);
  EXPECT_EQ(mesh.materials[0].texture, folder / "my skin.png");
  EXPECT_EQ(mesh.texture_coordinates.row(mesh.corner_texture(2, 0)), Eigen::RowVector2d(0.5, 0.5));
  EXPECT_EQ(mesh.texture_coordinates.row(mesh.corner_texture(0, 0)), Eigen::RowVector2d(0, 0));
  EXPECT_EQ(document.files(),
            (std::vector<fs::path>{folder / "face of Ä.ply", folder / "my skin.png"}));
}

TEST(ReadScan, OfAPlyInEitherByteOrderIsTheSame) {
  const TemporaryFolder folder;
  const std::string head =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar uint vertex_index\nend_header\n";
  const std::string x = raw<float>({0, 0, 0, 1.5, 0, 0, 0, -2.25, 8});
  const std::string corners = raw<std::uint32_t>({2, 1, 0});
  const auto swapped = [](std::string bytes) {
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
      std::reverse(bytes.begin() + std::ptrdiff_t(i), bytes.begin() + std::ptrdiff_t(i + 4));
    }
    return bytes;
  };
  const fs::path little =
      folder.write("l.ply", "ply\nformat binary_little_endian 1.0\n" + head + x + "\3" + corners);
  const fs::path big = folder.write(
      "b.ply", "ply\nformat binary_big_endian 1.0\n" + head + swapped(x) + "\3" + swapped(corners));
  const ObjDocument a = read(little), b = read(big);
  EXPECT_EQ(a.mesh().surface.vertices, b.mesh().surface.vertices);
  EXPECT_EQ(a.mesh().surface.vertices(2, 1), -2.25);
  EXPECT_EQ(a.mesh().surface.triangles.row(0), Eigen::RowVector3i(2, 1, 0));
  EXPECT_EQ(b.mesh().surface.triangles.row(0), Eigen::RowVector3i(2, 1, 0));
}

void expect_square(const ObjDocument& document) {
  const TexturedMesh& mesh = document.mesh();
  ASSERT_EQ(mesh.surface.vertices.rows(), 6);
  const Triangles wanted = (Triangles(2, 3) << 0, 1, 2, 0, 2, 5).finished();
  EXPECT_EQ(mesh.surface.triangles, wanted) << "split vertices are one to the mechanics";
  // glTF's v runs down.
  EXPECT_EQ(mesh.texture_coordinates.row(mesh.corner_texture(0, 0)), Eigen::RowVector2d(0, 1));
  EXPECT_EQ(mesh.texture_coordinates.row(mesh.corner_texture(1, 0)), Eigen::RowVector2d(0.5, 0.5));
  EXPECT_EQ(document.vertex_colours().row(1), Eigen::RowVector3d(0, 1, 0));
  EXPECT_NEAR(document.vertex_colours()(5, 0), 0.7354, 1e-4) << "sRGB of half the light";
  ASSERT_EQ(mesh.materials.size(), 1U);
  EXPECT_EQ(mesh.materials[0].name, "skin");
}

TEST(ReadScan, OfAGlbKeepsSeamColoursAndThePictureWithin) {
  const TemporaryFolder folder;
  const SquareGltf square;
  fs::path picture;
  {
    const ObjDocument document =
        read(folder.write("scan.glb", test::glb(square.json(), square.bytes())));
    expect_square(document);
    const ObjDocument copy = document;
    picture = copy.mesh().materials[0].texture;
    EXPECT_EQ(bytes_of(picture), square.image) << "byte for byte";
    const auto rights = fs::status(picture.parent_path()).permissions();
    EXPECT_EQ(rights & (fs::perms::group_all | fs::perms::others_all), fs::perms::none);
    EXPECT_EQ(document.files(), std::vector<fs::path>{folder / "scan.glb"});
  }
  EXPECT_FALSE(fs::exists(picture.parent_path())) << "a patient's picture stayed behind";
}

TEST(ReadScan, OfAGltfReadsTheFilesBesideIt) {
  const TemporaryFolder folder;
  SquareGltf square;
  folder.write("das bin/größe.bin", square.bytes());
  folder.write("skin.png", square.image);
  square.image_json = R"("uri":"skin.png")";
  const ObjDocument document =
      read(folder.write("scan.gltf", square.json(R"("uri":"das bin/größe.bin",)")));
  expect_square(document);
  EXPECT_EQ(document.mesh().materials[0].texture, folder / "skin.png");
}

TEST(ReadScan, PutsPartsWhereTheSceneHasThemAndMirroredOnesTheRightWayRound) {
  const TemporaryFolder folder;
  SquareGltf square;
  square.node = R"("mesh":0,"translation":[10,20,30],"scale":[-2,2,2])";
  const ObjDocument document =
      read(folder.write("scan.glb", test::glb(square.json(), square.bytes())));
  const TriangleMesh& surface = document.mesh().surface;
  EXPECT_EQ(surface.vertices.row(2), Eigen::RowVector3d(8, 22, 30));
  EXPECT_EQ(surface.triangles.row(0), Eigen::RowVector3i(2, 1, 0));
  EXPECT_EQ(triangle_normals(surface).row(0), Eigen::RowVector3d(0, 0, 1));
}

TEST(ReadScan, WrittenAsObjIsTheSameScan) {
  const TemporaryFolder folder;
  const SquareGltf square;
  const ObjDocument document =
      read(folder.write("my scan.glb", test::glb(square.json(), square.bytes())));
  fs::create_directory(folder / "out");
  Points x = document.mesh().surface.vertices;
  x(1, 2) = 0.1;
  document.write(folder / "out", "predicted.obj", x);
  const ObjDocument back = ObjDocument::read(folder / "out/predicted.obj");
  EXPECT_EQ(back.mesh().surface.vertices, x);
  EXPECT_EQ(back.mesh().surface.triangles, document.mesh().surface.triangles);
  EXPECT_EQ(back.mesh().texture_coordinates, document.mesh().texture_coordinates);
  EXPECT_EQ(back.mesh().corner_texture, document.mesh().corner_texture);
  EXPECT_EQ(back.vertex_colours(), document.vertex_colours());
  ASSERT_EQ(back.mesh().materials.size(), 1U);
  EXPECT_EQ(bytes_of(back.mesh().materials[0].texture), square.image);
}

TEST(ReadScan, OfAnStlMakesOneVertexOfEachPlace) {
  const TemporaryFolder folder;
  std::string stl(80, ' ');
  stl += raw<std::uint32_t>({2});
  for (const auto& corners : {std::vector<float>{0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0},
                              std::vector<float>{0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0}}) {
    stl += raw(corners) + std::string(2, '\0');
  }
  const ObjDocument document = read(folder.write("scan.STL", stl));
  EXPECT_EQ(document.mesh().surface.vertices.rows(), 4);
  const Triangles wanted = (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished();
  EXPECT_EQ(document.mesh().surface.triangles, wanted);
}

/// The square with its seam, however it was written: v 0 0 0, 1 0 0, 1 1 0, 0 1 0.5, two materials.
void expect_square(const TexturedMesh& mesh) {
  EXPECT_EQ(mesh.surface.vertices.rows(), 4);
  ASSERT_EQ(mesh.surface.triangles.rows(), 2);
  EXPECT_NEAR(surface_area(mesh.surface), 0.5 + 0.5 * std::sqrt(1.5), 1e-6);
  EXPECT_NE(mesh.triangle_material[0], mesh.triangle_material[1]);
}

/// Corners with their texture coordinates, the first triangle with the picture skin.png.
void expect_painted_square(const TexturedMesh& mesh, const fs::path& folder) {
  std::set<std::pair<double, double>> uv;
  for (int f = 0; f < 2; ++f) {
    for (int k = 0; k < 3; ++k) {
      const int row = mesh.corner_texture(f, k);
      ASSERT_GE(row, 0);
      uv.insert({mesh.texture_coordinates(row, 0), mesh.texture_coordinates(row, 1)});
    }
  }
  EXPECT_EQ(uv, (std::set<std::pair<double, double>>{{0, 0}, {1, 0}, {1, 1}, {0.25, 1}, {0, 0.5}}));
  const Material& skin = mesh.materials[std::size_t(mesh.triangle_material[0])];
  EXPECT_EQ(skin.texture, folder / "skin.png");
  EXPECT_TRUE(mesh.materials[std::size_t(mesh.triangle_material[1])].texture.empty());
}

/// Written by assimp from the square.
fs::path square_by_assimp(const TemporaryFolder& folder, const char* id,
                          const std::string& ending) {
  folder.write("skin.png", picture_bytes(".png"));
  folder.write("mats.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd skin.png\nnewmtl lip\nKd 1 0 0\n");
  const fs::path obj =
      folder.write("in.obj",
                   "mtllib mats.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvt 1 0\nvt 1 1\n"
                   "vt 0.25 1\nvt 0 0.5\nusemtl skin\nf 1/1 2/2 3/3\nusemtl lip\nf 1/5 3/3 4/4\n");
  Assimp::Importer importer;
  Assimp::Exporter exporter;
  const fs::path file = folder / ("scan." + ending);
  EXPECT_EQ(exporter.Export(importer.ReadFile(obj.string(), 0), id, file.string()), AI_SUCCESS)
      << exporter.GetErrorString();
  return file;
}

class ByAssimp : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(ByAssimp, KeepsPlacesCornersAndMaterials) {
  const auto [id, ending] = GetParam();
  const TemporaryFolder folder;
  const ObjDocument document = read(square_by_assimp(folder, id, ending));
  expect_square(document.mesh());
  expect_painted_square(document.mesh(), folder.path());
}

TEST(ReadScan, OfABinaryFbxKeepsPlacesCornersAndMaterials) {
  const TemporaryFolder folder;
  folder.write("skin.png", picture_bytes(".png"));
  const ObjDocument document =
      read(folder.write("scan.fbx", test::square_as_binary_fbx("skin.png")));
  expect_square(document.mesh());
  expect_painted_square(document.mesh(), folder.path());
}

TEST(ReadScan, OfA3mfKeepsPlacesAndMaterials) {
  const TemporaryFolder folder;
  const ObjDocument document = read(square_by_assimp(folder, "3mf", "3mf"));
  expect_square(document.mesh());
  EXPECT_EQ(document.mesh().materials[std::size_t(document.mesh().triangle_material[1])].name,
            "id1_lip");
}

INSTANTIATE_TEST_SUITE_P(Formats, ByAssimp,
                         testing::Values(std::pair{"fbxa", "fbx"}, std::pair{"3ds", "3ds"},
                                         std::pair{"collada", "dae"}),
                         [](const auto& format) { return std::string(format.param.first); });

TEST(ReadScan, KeepsWhatAnObjSaysToTheLetter) {
  const TemporaryFolder folder;
  const std::string text = "v 0 0 0 1 0 0\nv 1.50 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n";
  const ObjDocument document = read(folder.write("a.obj", text));
  EXPECT_EQ(document.text_with(document.mesh().surface.vertices), text);
  EXPECT_EQ(document.vertex_colours(), Points(Eigen::Matrix3d::Identity()));
}

TEST(ReadScan, TakesColoursOfAnObjUpTo255) {
  const TemporaryFolder folder;
  const ObjDocument document =
      read(folder.write("a.obj", "v 0 0 0 255 0 0\nv 1 0 0 0 51 0\nv 0 1 0 0 0 255\nf 1 2 3\n"));
  EXPECT_EQ(document.vertex_colours()(1, 1), 0.2);
}

TEST(ReadScan, IsGivenUpAtItsLimits) {
  const TemporaryFolder folder;
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2000000\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0 1 0 0 0 1 0\n";
  for (int f = 0; f < 2000000; ++f) ply += "3 0 1 2\n";
  const fs::path file = folder.write("large.ply", ply);
  const auto expect = [&](const ScanLimits& limits, const char* words) {
    Progress progress;
    test::expect_error(ErrorKind::input, {"large.ply", words},
                       [&] { read_scan(file, progress, limits); });
  };
  expect({.time = std::chrono::seconds(0)}, "more than 0 seconds");
  expect({.output_bytes = 1000000}, "more than a scan");
#ifndef __SANITIZE_ADDRESS__
  expect({.memory_bytes = 120'000'000}, "memory");
#endif
}

TEST(ReadScan, IsCancelledAtOnce) {
  const TemporaryFolder folder;
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 3000000\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0 1 0 0 0 1 0\n";
  for (int f = 0; f < 3000000; ++f) ply += "3 0 1 2\n";
  const fs::path file = folder.write("large.ply", ply);
  Progress progress;
  std::chrono::steady_clock::time_point asked;
  std::thread user([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    asked = std::chrono::steady_clock::now();
    progress.cancel();
  });
  EXPECT_THROW(read_scan(file, progress), Error);
  const auto took = std::chrono::steady_clock::now() - asked;
  user.join();
  EXPECT_LT(took, std::chrono::seconds(1));
}

TEST(ReadScan, SaysWhenItsProgramIsMissing) {
  const TemporaryFolder folder;
  folder.write("my skin.png", picture_bytes(".png"));
  const fs::path file = folder.write("a.ply", kPly);
  setenv("GNATHION_SCAN_READER", (folder / "none").c_str(), 1);
  test::expect_error(ErrorKind::input, {"none", "cannot be started", "install"},
                     [&] { read(file); });
  unsetenv("GNATHION_SCAN_READER");
}

}  // namespace
}  // namespace gnathion

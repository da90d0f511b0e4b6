#include "render/face_scene.h"

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include "base/error.h"
#include "render/baseline.h"
#include "render/coarse_surface.h"
#include "render/ready_surface.h"
#include "render/scene_fixture.h"

namespace gnathion::test {
namespace {

bool is_red(const std::uint8_t* p) {
  return p[0] > 120 && p[1] < 60 && p[2] < 70;
}
bool is_blue(const std::uint8_t* p) {
  return p[2] > 150 && p[0] < 110;
}

/// A bump at the chin and a hollow at the forehead's left, mm.
Eigen::VectorXd bump_and_hollow(const TexturedMesh& head) {
  Eigen::VectorXd values(head.surface.vertices.rows());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Eigen::RowVector3d x = head.surface.vertices.row(i);
    const double chin = (x - Eigen::RowVector3d(0, -75, -65)).squaredNorm();
    const double brow = (x - Eigen::RowVector3d(40, -70, 55)).squaredNorm();
    values(i) = 4 * std::exp(-chin / 1200) - 4 * std::exp(-brow / 700);
  }
  return values;
}

TEST_F(SceneTest, TexturedHeadLooksAsStored) {
  scene.set_face(head);
  scene.set_label("Before");
  EXPECT_TRUE(matches_baseline(front(), "head_front"));
  EXPECT_TRUE(matches_baseline(render_picture(scene, CameraPreset::three_quarter, 320, 320),
                               "head_three_quarter"));
  EXPECT_TRUE(matches_baseline(render_picture(scene, CameraPreset::right, 320, 240), "head_right"));
}

TEST_F(SceneTest, ColourMapLooksAsStored) {
  scene.set_face(head);
  scene.show_colour_map(bump_and_hollow(head));
  EXPECT_TRUE(matches_baseline(front(), "colour_map_front"));
}

TEST_F(SceneTest, BonesUnderTranslucentFaceLookAsStored) {
  scene.set_face(head);
  scene.set_face_opacity(0.35);
  scene.set_bone("skull", ellipsoid({0, 8, 25}, {62, 78, 78}), skull_look);
  scene.set_bone("segment", ellipsoid({0, -35, -62}, {38, 36, 18}), segment_look);
  RigidMotion forward;
  forward.translation = {0, -12, 0};
  scene.set_bone_pose("segment", forward);
  EXPECT_TRUE(matches_baseline(render_picture(scene, CameraPreset::left, 320, 320), "bones_left"));
}

TEST_F(SceneTest, PatientsLeftIsOnThePicturesRightInFront) {
  scene.set_face(head);
  EXPECT_GT(mean_column(front(), is_red), 200);
  const Picture left = render_picture(scene, CameraPreset::left, 320, 320);
  EXPECT_GT(mean_column(left, is_red), 0);
  EXPECT_LT(mean_column(left, is_red), 160);  // before the ear, and the nose is to the left
  const Picture right = render_picture(scene, CameraPreset::right, 320, 320);
  EXPECT_EQ(mean_column(right, is_red), -1);
}

TEST_F(SceneTest, MovedPointsChangeThePictureAndComeBack) {
  scene.set_face(head);
  const Picture before = front();
  Points moved = head.surface.vertices;
  moved.col(0).array() += moved.col(2).array() * 0.2;
  scene.set_face_points(moved);
  EXPECT_GT(difference(front(), before).far_pixels, 0.05);
  scene.set_face_points(head.surface.vertices);
  EXPECT_EQ(front(), before);
}

TEST_F(SceneTest, MovedPointsLookLikeAFaceMadeOfThem) {
  scene.set_face(head);
  TexturedMesh other = head;
  other.surface.vertices.col(1).array() *= 1.15;
  scene.set_face_points(other.surface.vertices);
  const Picture updated = front();
  FaceScene fresh;
  fresh.set_face(other);
  EXPECT_EQ(updated, render_picture(fresh, CameraPreset::front, 320, 320));
}

TEST_F(SceneTest, VertexColoursAreShownWhereThereIsNoTexture) {
  TexturedMesh plain = head;
  for (Material& material : plain.materials) material.texture.clear();
  Points colours = Points::Zero(head.surface.vertices.rows(), 3);
  for (Eigen::Index v = 0; v < colours.rows(); ++v) {
    colours(v, head.surface.vertices(v, 0) > 0 ? 1 : 0) = 0.8;  // the patient's left is green
  }
  scene.set_face(plain, "face", colours);
  const auto green = [](const std::uint8_t* c) { return c[1] > c[0] + 60 && c[1] > c[2] + 60; };
  const auto red = [](const std::uint8_t* c) { return c[0] > c[1] + 60 && c[0] > c[2] + 60; };
  const Picture painted = front();
  EXPECT_GT(mean_column(painted, green), 170);
  EXPECT_LT(mean_column(painted, red), 150);
  // A colour map takes their place and gives it back; without the photograph they are not shown.
  scene.show_colour_map(Eigen::VectorXd::Zero(colours.rows()), 5);
  EXPECT_EQ(mean_column(front(), green), -1);
  scene.hide_colour_map();
  EXPECT_EQ(front(), painted);
  scene.set_face_textured(false);
  EXPECT_EQ(mean_column(front(), green), -1);
  EXPECT_THROW(scene.set_face(plain, "face", colours.topRows(3)), Error);
}

TEST_F(SceneTest, RefusesWrongPoints) {
  scene.set_face(head);
  const Picture before = front();
  Points broken = head.surface.vertices;
  broken(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scene.set_face_points(broken), Error);
  EXPECT_THROW(scene.set_face_points(broken.topRows(10)), Error);
  EXPECT_EQ(front(), before);
}

TEST_F(SceneTest, RefusesABrokenFaceAndKeepsTheOneShown) {
  scene.set_face(head);
  const Picture before = front();
  TexturedMesh broken = head;
  broken.surface.vertices(3, 0) = std::numeric_limits<double>::quiet_NaN();
  try {
    scene.set_face(broken, "photo.obj");
    FAIL() << "a face with a coordinate that is not a number was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.subject(), "photo.obj");
  }
  EXPECT_EQ(front(), before);
}

TEST_F(SceneTest, MissingTextureNamesTheFileAndKeepsTheFaceShown) {
  scene.set_face(head);
  const Picture before = front();
  TexturedMesh other = head;
  other.materials[0].texture = folder / "absent.jpg";
  try {
    scene.set_face(other);
    FAIL() << "a face without its texture was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.subject(), (folder / "absent.jpg").string());
  }
  EXPECT_EQ(front(), before);
}

TEST_F(SceneTest, UnreadableTextureNamesTheFile) {
  std::ofstream(folder / "text.png") << "this is no picture";
  head.materials[0].texture = folder / "text.png";
  try {
    scene.set_face(head);
    FAIL() << "a text file was accepted as a texture";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.subject(), (folder / "text.png").string());
  }
}

TEST_F(SceneTest, ColourMapIsCoolInHollowsHotOnBulgesAndHasABar) {
  scene.set_face(head);
  scene.set_orientation_letters(false);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(head.surface.vertices.rows());
  scene.show_colour_map(rest, 4);
  const Picture flat = front();
  // At rest the only colour in the picture is the bar: hot above cool, on the right.
  EXPECT_GT(mean_column(flat, is_red), 260);
  EXPECT_GT(mean_column(flat, is_blue), 260);
  scene.show_colour_map(Eigen::VectorXd::Constant(rest.size(), 4.0), 4);
  EXPECT_LT(mean_column(front(), is_red), 200);
  scene.show_colour_map(Eigen::VectorXd::Constant(rest.size(), -4.0), 4);
  EXPECT_LT(mean_column(front(), is_blue), 200);
  scene.hide_colour_map();
  EXPECT_EQ(mean_column(front(), is_blue), -1);
}

TEST_F(SceneTest, UnmeasuredValuesAreGrey) {
  scene.set_face(head);
  const auto count = head.surface.vertices.rows();
  scene.show_colour_map(Eigen::VectorXd::Constant(count, std::numeric_limits<double>::quiet_NaN()),
                        1);
  const Picture picture = front();
  const std::uint8_t* forehead = picture.at(160, 110);
  EXPECT_NEAR(forehead[0], forehead[2], 12);
  EXPECT_LT(forehead[0], 190);
}

TEST_F(SceneTest, ColourMapOfAnotherFaceIsRefused) {
  EXPECT_THROW(scene.show_colour_map(Eigen::VectorXd::Zero(3)), Error);
  scene.set_face(head);
  EXPECT_THROW(scene.show_colour_map(Eigen::VectorXd::Zero(3)), Error);
}

TEST_F(SceneTest, PoseMovesABone) {
  scene.set_bone("skull", ellipsoid({0, 0, 0}, {60, 60, 60}), skull_look);
  scene.set_bone("segment", ellipsoid({0, -60, 0}, {15, 15, 15}), {{0.9, 0, 0}, 1});
  scene.look_from(CameraPreset::front, 1);
  OffscreenRenderer renderer;
  const double rest = mean_column(renderer.render(scene, 320, 320), is_red);
  RigidMotion motion;
  motion.translation = {25, 0, 0};
  scene.set_bone_pose("segment", motion);
  const double shifted = mean_column(renderer.render(scene, 320, 320), is_red);
  EXPECT_NEAR(rest, 160, 2);
  EXPECT_GT(shifted, rest + 25);
}

TEST_F(SceneTest, CoarseBoneIsDrawnOnlyWhenAskedForAndLooksMuchTheSame) {
  const TriangleMesh bone = ellipsoid({0, 0, 0}, {60, 60, 60});
  const Triangles coarse = coarse_triangles(bone, 1200);
  EXPECT_LE(coarse.rows(), 1200);
  EXPECT_GT(coarse.rows(), 600);
  scene.set_bone("skull", bone, skull_look, coarse);
  const Picture fine = front();
  scene.set_coarse(true);
  const Picture rough = front();
  EXPECT_NE(rough, fine);
  EXPECT_LT(difference(rough, fine).far_pixels, 0.02);
  scene.set_coarse(false);
  EXPECT_EQ(front(), fine);
  EXPECT_EQ(coarse_triangles(bone, 100000), bone.triangles);
}

/// The surfaces that a renderer draws.
std::vector<vtkPolyData*> surfaces_in(vtkRenderer* renderer) {
  std::vector<vtkPolyData*> all;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor()) {
    all.push_back(vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputAsDataSet()));
  }
  return all;
}

TEST_F(SceneTest, WhatWasMadeReadyElsewhereIsSharedByScenesAndLooksTheSame) {
  const TriangleMesh skull = ellipsoid({0, 8, 25}, {62, 78, 78});
  scene.set_face(head);
  scene.set_bone("skull", skull, skull_look);
  const Picture direct = front();
  const auto face = ready_face(head, "face");
  const auto bone = ready_bone(skull, "skull", coarse_triangles(skull, 1200));
  FaceScene first, second;
  for (FaceScene* each : {&first, &second}) {
    each->set_face(face);
    each->set_bone("skull", bone, skull_look);
    EXPECT_EQ(render_picture(*each, CameraPreset::front, 320, 320), direct);
    const std::vector<vtkPolyData*> shown = surfaces_in(each->renderer());
    ASSERT_EQ(shown.size(), face->whole.size() + 2);
    for (std::size_t p = 0; p < face->whole.size(); ++p) {
      EXPECT_EQ(shown[p]->GetPolys(), face->whole[p].arrays.cells);
    }
    vtkPolyData* whole = shown[face->whole.size()];
    EXPECT_EQ(whole->GetPolys(), bone->whole.cells);
    EXPECT_EQ(whole->GetPoints()->GetData(), bone->whole.points);
    EXPECT_EQ(whole->GetPointData()->GetNormals(), bone->whole.normals);
    EXPECT_EQ(shown.back()->GetPolys(), bone->coarse.cells);
  }
  // The face of one moves alone.
  Points moved = head.surface.vertices;
  moved.col(0).array() += 12;
  first.set_face_points(moved);
  EXPECT_NE(render_picture(first, CameraPreset::front, 320, 320), direct);
  EXPECT_EQ(render_picture(second, CameraPreset::front, 320, 320), direct);
}

TEST(ReadyBone, IsClosedWhenItHasNoBorderAndItsNormalsPointOutward) {
  TriangleMesh bone;
  bone.vertices.resize(4, 3);
  bone.vertices << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10;
  bone.triangles.resize(4, 3);
  bone.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  EXPECT_TRUE(ready_bone(bone, "skull")->is_outward_closed);
  TriangleMesh open = bone;
  open.triangles.conservativeResize(3, 3);
  EXPECT_FALSE(ready_bone(open, "skull")->is_outward_closed);
  TriangleMesh twisted = bone;
  std::swap(twisted.triangles(3, 0), twisted.triangles(3, 1));
  EXPECT_FALSE(ready_bone(twisted, "skull")->is_outward_closed);
  bone.triangles.col(0).swap(bone.triangles.col(1));
  EXPECT_FALSE(ready_bone(bone, "skull")->is_outward_closed) << "inside out";
}

/// A spherical shell: an outer and an inner surface, `wall` mm apart.
TriangleMesh shell(double radius, double wall) {
  const TriangleMesh outer = ellipsoid({0, 0, 0}, {radius, radius, radius});
  const double within = radius - wall;
  TriangleMesh inner = ellipsoid({0, 0, 0}, {within, within, within});
  inner.triangles.col(0).swap(inner.triangles.col(1));
  TriangleMesh both;
  both.vertices.resize(outer.vertices.rows() + inner.vertices.rows(), 3);
  both.vertices << outer.vertices, inner.vertices;
  both.triangles.resize(outer.triangles.rows() + inner.triangles.rows(), 3);
  both.triangles << outer.triangles,
      (inner.triangles.array() + static_cast<int>(outer.vertices.rows())).matrix();
  return both;
}

TEST_F(SceneTest, CoarseBoneWithAThinWallHasNoDarkSpots) {
  const TriangleMesh bone = shell(60, 2);
  scene.set_orientation_letters(false);
  scene.set_bone("skull", bone, skull_look, coarse_triangles(bone, 2400));
  const Picture fine = front();
  scene.set_coarse(true);
  const Picture coarse = front();
  EXPECT_NE(coarse, fine);
  // Where the sphere faces the eye, both sides of the wall are within one cell of the grid.
  int darker = 0;
  for (int y = 120; y < 200; ++y) {
    for (int x = 120; x < 200; ++x) darker += coarse.at(x, y)[0] + 40 < fine.at(x, y)[0] ? 1 : 0;
  }
  EXPECT_EQ(darker, 0);
}

/// Every triangle cut into four, its corners' texture coordinates halved along the edges.
TexturedMesh four_times_finer(const TexturedMesh& mesh) {
  TexturedMesh fine = mesh;
  const Eigen::Index n = mesh.surface.triangles.rows();
  std::map<std::pair<int, int>, int> middles;
  std::vector<Eigen::RowVector3d> points;
  std::vector<Eigen::RowVector2d> uvs;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] = middles.try_emplace(
        std::minmax(a, b), static_cast<int>(mesh.surface.vertices.rows() + points.size()));
    if (is_new) {
      points.emplace_back((mesh.surface.vertices.row(a) + mesh.surface.vertices.row(b)) / 2);
    }
    return found->second;
  };
  const auto middle_uv = [&](int a, int b) {
    if (a < 0 || b < 0) return -1;
    uvs.emplace_back((mesh.texture_coordinates.row(a) + mesh.texture_coordinates.row(b)) / 2);
    return static_cast<int>(mesh.texture_coordinates.rows() + uvs.size()) - 1;
  };
  fine.surface.triangles.resize(4 * n, 3);
  fine.corner_texture.resize(4 * n, 3);
  fine.triangle_material.clear();
  for (Eigen::Index t = 0; t < n; ++t) {
    std::array<int, 6> v{}, w{};
    for (int k = 0; k < 3; ++k) {
      v[k] = mesh.surface.triangles(t, k);
      w[k] = mesh.corner_texture(t, k);
    }
    for (int k = 0; k < 3; ++k) {
      v[3 + k] = middle(v[k], v[(k + 1) % 3]);
      w[3 + k] = middle_uv(w[k], w[(k + 1) % 3]);
    }
    const int corners[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    for (int q = 0; q < 4; ++q) {
      for (int k = 0; k < 3; ++k) {
        fine.surface.triangles(4 * t + q, k) = v[corners[q][k]];
        fine.corner_texture(4 * t + q, k) = w[corners[q][k]];
      }
      fine.triangle_material.push_back(mesh.triangle_material[static_cast<std::size_t>(t)]);
    }
  }
  const auto append = [](auto& rows, const auto& more) {
    const Eigen::Index before = rows.rows();
    rows.conservativeResize(before + static_cast<Eigen::Index>(more.size()), Eigen::NoChange);
    for (std::size_t i = 0; i < more.size(); ++i) {
      rows.row(before + static_cast<Eigen::Index>(i)) = more[i];
    }
  };
  append(fine.surface.vertices, points);
  append(fine.texture_coordinates, uvs);
  return fine;
}

TEST_F(SceneTest, LargeFaceIsDrawnCoarseWhileAskedForAndMovesWithIt) {
  while (head.surface.triangles.rows() < 60000) head = four_times_finer(head);
  scene.set_orientation_letters(false);
  scene.set_face(head);
  const Picture fine = front();
  scene.set_coarse(true);
  const Picture coarse = front();
  EXPECT_NE(coarse, fine);
  EXPECT_LT(difference(coarse, fine).far_pixels, 0.03) << "texture and outline stay";
  Points moved = head.surface.vertices;
  moved.col(0).array() += 12;
  scene.set_face_points(moved);
  const Picture coarse_moved = front();
  scene.set_coarse(false);
  const Picture fine_moved = front();
  EXPECT_LT(difference(coarse_moved, fine_moved).far_pixels, 0.03);
  FaceScene direct;
  direct.set_orientation_letters(false);
  direct.set_face(head);
  direct.set_face_points(moved);
  EXPECT_EQ(fine_moved, render_picture(direct, CameraPreset::front, 320, 320))
      << "the whole face is where the coarse one was moved to";
}

TEST_F(SceneTest, HiddenAndRemovedThingsLeaveThePicture) {
  scene.set_orientation_letters(false);
  scene.set_face(head);
  scene.look_from(CameraPreset::front, 1);
  OffscreenRenderer renderer;
  const Picture with_face = renderer.render(scene, 200, 200);
  scene.set_face_visible(false);
  const Picture empty = renderer.render(scene, 200, 200);
  EXPECT_NE(empty, with_face);
  scene.set_bone("skull", ellipsoid({0, 0, 0}, {60, 60, 60}), skull_look);
  EXPECT_NE(renderer.render(scene, 200, 200), empty);
  scene.set_bone_visible("skull", false);
  EXPECT_EQ(renderer.render(scene, 200, 200), empty);
  scene.set_bone_visible("skull", true);
  scene.set_bone_drawn("skull", false);
  EXPECT_EQ(renderer.render(scene, 200, 200), empty);
  scene.set_bone_drawn("skull", true);
  EXPECT_NE(renderer.render(scene, 200, 200), empty);
  scene.remove_bones();
  EXPECT_TRUE(scene.bone_names().empty());
  EXPECT_EQ(renderer.render(scene, 200, 200), empty);
  scene.set_face_visible(true);
  EXPECT_EQ(renderer.render(scene, 200, 200), with_face);
  scene.remove_face();
  EXPECT_FALSE(scene.has_face());
  EXPECT_EQ(renderer.render(scene, 200, 200), empty);
}

TEST_F(SceneTest, EveryPresetShowsTheWholeHead) {
  scene.set_orientation_letters(false);
  FaceScene empty;
  empty.set_orientation_letters(false);
  scene.set_face(head);
  for (const CameraPreset view : {CameraPreset::front, CameraPreset::left, CameraPreset::right,
                                  CameraPreset::three_quarter}) {
    const Picture picture = render_picture(scene, view, 300, 200);
    const Picture background = render_picture(empty, view, 300, 200);
    int inside = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 300; ++x) {
        const bool is_head =
            !std::equal(picture.at(x, y), picture.at(x, y) + 3, background.at(x, y));
        const bool border = x < 5 || x >= 295 || y < 5 || y >= 195;
        EXPECT_FALSE(is_head && border) << name_of(view) << " cuts at " << x << ", " << y;
        inside += is_head;
      }
    }
    EXPECT_GT(inside, 12000) << name_of(view);
  }
}

}  // namespace
}  // namespace gnathion::test

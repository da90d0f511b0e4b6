#include "render/region_overlay.h"

#include <cmath>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "render/baseline.h"
#include "render/scene_fixture.h"

namespace gnathion::test {
namespace {

/// The painted head with a region around its chin.
class OverlayTest : public SceneTest {
 protected:
  OverlayTest() {
    scene.set_face(head);
    overlay.attach(scene.renderer());
    overlay.set_face(head.surface);
    for (Eigen::Index v = 0; v < head.surface.vertices.rows(); ++v) {
      if (near_chin(v)) region.push_back(static_cast<int>(v));
    }
  }
  ~OverlayTest() override { overlay.detach(); }

  bool near_chin(Eigen::Index v) const {
    return (head.surface.vertices.row(v) - Eigen::RowVector3d(0, -75, -65)).norm() < 45;
  }

  void show_region() {
    std::vector<int> inside;
    std::vector<std::array<int, 2>> rim;
    const Triangles& all = head.surface.triangles;
    for (int f = 0; f < all.rows(); ++f) {
      if (near_chin(all(f, 0)) && near_chin(all(f, 1)) && near_chin(all(f, 2))) inside.push_back(f);
    }
    for (const Edge& edge : edges_of({head.surface.vertices, all(inside, Eigen::all)})) {
      if (edge.right == -1) rim.push_back({edge.a, edge.b});
    }
    overlay.set_region(all(inside, Eigen::all), rim);
  }

  static int count(const Picture& picture, const Eigen::Vector3d& rgb, double within) {
    int found = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const std::uint8_t* p = picture.at(x, y);
        const Eigen::Vector3d colour(p[0], p[1], p[2]);
        found += (colour / 255 - rgb).norm() < within;
      }
    }
    return found;
  }
  static bool is_greenish(const std::uint8_t* p) { return p[1] > p[0] + 12 && p[1] > p[2] + 12; }
  static int greenish(const Picture& picture) {
    int found = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) found += is_greenish(picture.at(x, y));
    }
    return found;
  }

  RegionOverlay overlay;
  std::vector<int> region;
};

TEST_F(OverlayTest, RegionLooksAsStored) {
  show_region();
  std::vector<SupportPoint> supports;
  for (const int v : region) {
    supports.push_back({v, support_marks[static_cast<std::size_t>(v) % support_marks.size()]});
  }
  overlay.set_supports(supports);
  EXPECT_TRUE(matches_baseline(front(), "region_front"));
}

TEST_F(OverlayTest, RegionIsGreenAndLetsThePhotographThrough) {
  const Picture before = front();
  const int painted = greenish(before);  // the head has a green eye
  show_region();
  const Picture shown = front();
  EXPECT_GT(greenish(shown), painted + 1500);
  // The checker of the paint is still there: two shades of green at least.
  double darkest = 255, brightest = 0;
  for (int x = 140; x < 180; ++x) {
    const std::uint8_t* p = shown.at(x, 235);
    if (!is_greenish(p)) continue;
    darkest = std::min<double>(darkest, p[0]);
    brightest = std::max<double>(brightest, p[0]);
  }
  EXPECT_GT(brightest - darkest, 4);
  overlay.set_region({}, {});
  EXPECT_EQ(greenish(front()), painted);
}

TEST_F(OverlayTest, RegionLooksTheSameWhileFramesAreQuick) {
  show_region();
  const Picture at_rest = front();
  scene.set_coarse_bones(true);  // a stroke of the brush
  const Picture quick = front();
  EXPECT_LT(difference(quick, at_rest).far_pixels, 0.001);
  scene.set_coarse_bones(false);
  EXPECT_EQ(front(), at_rest);
}

TEST_F(OverlayTest, RegionFollowsTheFace) {
  show_region();
  const double before = mean_column(front(), is_greenish);
  Points moved = head.surface.vertices;
  moved.col(0).array() += 15;  // to the patient's left, the picture's right
  scene.set_face_points(moved);
  overlay.set_points(moved);
  OffscreenRenderer renderer;
  const Picture shifted = renderer.render(scene, 320, 320);  // the camera stays
  EXPECT_GT(mean_column(shifted, is_greenish), before + 8);
}

TEST_F(OverlayTest, SupportsHaveTheirColours) {
  for (const SupportMark mark : support_marks) {
    std::vector<SupportPoint> points;
    for (const int v : region) points.push_back({v, mark});
    overlay.set_supports({});
    const int none = count(front(), colour_of(mark), 0.06);
    overlay.set_supports(points);
    EXPECT_GT(count(front(), colour_of(mark), 0.06), none + 100) << static_cast<int>(mark);
  }
}

TEST_F(OverlayTest, FaultsAndCursorStandOut) {
  EXPECT_EQ(count(front(), fault_colour, 0.1), 0);
  overlay.set_faults(region);
  EXPECT_GT(count(front(), fault_colour, 0.1), 300);
  overlay.set_faults({});
  Points cursor(2, 3);
  cursor << -20, -130, -60, 20, -130, -60;
  overlay.set_cursor(cursor, true);
  const auto is_red = [](const std::uint8_t* p) { return p[0] > 220 && p[1] < 120 && p[2] < 110; };
  const double column = mean_column(front(), is_red);
  EXPECT_NEAR(column, 160, 30);
  overlay.set_cursor({}, false);
  overlay.detach();
  EXPECT_FALSE(overlay.is_attached());
}

}  // namespace
}  // namespace gnathion::test

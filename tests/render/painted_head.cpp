#include "render/painted_head.h"

#include <algorithm>
#include <cmath>

#include "render/picture.h"

namespace gnathion::test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int around = 72, upwards = 36;  // quads
constexpr double seam = 120;              // degrees from the front towards the left

/// Unit vector for an angle from the front towards the left and a height angle, in degrees.
Eigen::Vector3d direction(double turn, double height) {
  const double t = turn * pi / 180, h = height * pi / 180;
  return {std::cos(h) * std::sin(t), -std::cos(h) * std::cos(t), std::sin(h)};
}

Eigen::Vector3d head_point(double turn, double height) {
  const double side = std::remainder(turn, 360.0);
  const double nose = 24 * std::exp(-side * side / 60 - (height + 2) * (height + 2) / 160);
  const Eigen::Vector3d d = direction(turn, height);
  return d.cwiseProduct(Eigen::Vector3d(75, 95, 115)) + nose * d;
}

bool in_box(double x, double y, double x0, double x1, double y0, double y1) {
  return x >= x0 && x <= x1 && y >= y0 && y <= y1;
}

/// RGB of the paint; turn: degrees from the front towards the left, −180..180.
Eigen::Vector3d paint(double turn, double height) {
  if (in_box(turn, height, 30, 34, -40, -14) || in_box(turn, height, 34, 46, -40, -36)) {
    return {20, 20, 30};  // L
  }
  if (std::hypot(turn - 62, height - 22) < 8) return {220, 20, 30};  // mark on the left temple
  if (std::hypot((turn - 20) / 1.6, height - 14) < 5) return {30, 60, 120};
  if (std::hypot((turn + 20) / 1.6, height - 14) < 5) return {60, 110, 60};
  if (in_box(turn, height, -14, 14, -34, -29)) return {160, 90, 85};
  const bool odd = (static_cast<int>(std::floor(turn / 15) + std::floor(height / 15)) & 1) != 0;
  return odd ? Eigen::Vector3d(222, 184, 160) : Eigen::Vector3d(240, 208, 188);
}

Picture painted_texture() {
  Picture picture{720, 360, std::vector<std::uint8_t>(3 * 720 * 360)};
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      const double turn = std::remainder(seam + (column + 0.5) * 360 / picture.width, 360.0);
      const double height = 90 - (row + 0.5) * 180 / picture.height;
      const Eigen::Vector3d rgb = paint(turn, height);
      for (int c = 0; c < 3; ++c) {
        picture.rgb[static_cast<size_t>(3 * (row * picture.width + column) + c)] =
            static_cast<std::uint8_t>(rgb(c));
      }
    }
  }
  return picture;
}

/// Triangles of a grid of around × (upwards + 1) vertices, quads cut in two, without the slivers at
/// the poles; `columns` is around (closed) or around + 1 (open at the seam).
Triangles grid_triangles(int columns) {
  Triangles triangles(2 * around * upwards, 3);
  Eigen::Index t = 0;
  for (int j = 0; j < upwards; ++j) {
    for (int i = 0; i < around; ++i) {
      const int a = j * columns + i, b = j * columns + (i + 1) % columns;
      const int c = b + columns, d = a + columns;
      if (j > 0) triangles.row(t++) << a, b, c;
      if (j < upwards - 1) triangles.row(t++) << a, c, d;
    }
  }
  return triangles.topRows(t);
}

double turn_of(int i) {
  return seam + i * 360.0 / around;
}
double height_of(int j) {
  return -90 + j * 180.0 / upwards;
}

}  // namespace

TexturedMesh painted_head(const std::filesystem::path& folder) {
  TexturedMesh head;
  head.surface.vertices.resize(around * (upwards + 1), 3);
  head.texture_coordinates.resize((around + 1) * (upwards + 1), 2);
  for (int j = 0; j <= upwards; ++j) {
    for (int i = 0; i <= around; ++i) {
      if (i < around) {
        head.surface.vertices.row(j * around + i) = head_point(turn_of(i), height_of(j));
      }
      head.texture_coordinates.row(j * (around + 1) + i) << static_cast<double>(i) / around,
          static_cast<double>(j) / upwards;
    }
  }
  head.surface.triangles = grid_triangles(around);
  head.corner_texture = grid_triangles(around + 1);
  for (Eigen::Index t = 0; t < head.surface.triangles.rows(); ++t) {
    const bool cap = head.surface.vertices(head.surface.triangles(t, 0), 2) > 95;
    head.triangle_material.push_back(cap ? 1 : 0);
  }
  write_png(painted_texture(), folder / "paint.png");
  head.materials.resize(2);
  head.materials[0].name = "paint";
  head.materials[0].texture = folder / "paint.png";
  head.materials[1].name = "cap";
  head.materials[1].diffuse = {0.25, 0.45, 0.60};
  return head;
}

TriangleMesh ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& half_axes) {
  TriangleMesh mesh;
  mesh.vertices.resize(around * (upwards + 1), 3);
  for (int j = 0; j <= upwards; ++j) {
    for (int i = 0; i < around; ++i) {
      mesh.vertices.row(j * around + i) =
          centre + direction(turn_of(i), height_of(j)).cwiseProduct(half_axes);
    }
  }
  mesh.triangles = grid_triangles(around);
  return mesh;
}

}  // namespace gnathion::test

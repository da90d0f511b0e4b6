#include "phantom/phantom_photograph.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "base/error.h"
#include "phantom/parallel_rows.h"
#include "phantom/surface_search.h"

namespace gnathion {

using Eigen::Vector3d;

namespace {

constexpr double margin = 0.02;  // of the texture, around the grid

/// The rays of the camera: from outside to an axis in the head, fanning out so that they meet the
/// underside of nose and chin too. The axis bends back into the neck, so that the photograph goes
/// on behind the jaw's angle, below the ear: its rim should not lie on bone that is to be moved.
/// u, v in [−1, 1]: right to left, bottom to top.
struct Camera {
  static Vector3d target(double v) {
    return v > 0 ? Vector3d(0, -22, 11 + 35 * v) : Vector3d(0, -22 - 27 * v, 11 + 91 * v);
  }
  static Vector3d outward(double u, double v) {
    const double side = u * (86 + 24 * std::max(0.0, -v)) * M_PI / 180;
    const double up = (-20 + (v > 0 ? 52 : 22) * v) * M_PI / 180;
    return {std::sin(side) * std::cos(up), -std::cos(side) * std::cos(up), std::sin(up)};
  }
};

Vector3d photographed(const HeadModel& head, double u, double v) {
  const Vector3d out = Camera::outward(u, v);
  return surface_point([&](const Vector3d& p) { return head.skin(p); },
                       Camera::target(v) + 220 * out, -out);
}

/// Parameters in [−1, 1] that cut a curve of the given arc lengths (at equal parameters) into
/// pieces of equal length, about `edge` each.
std::vector<double> evenly_spaced(const std::vector<double>& piece, double edge) {
  std::vector<double> arc(piece.size() + 1, 0);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    arc[i + 1] = arc[i] + piece[i];
  }
  const int count = std::max(8, static_cast<int>(std::lround(arc.back() / edge)));
  std::vector<double> parameters;
  std::size_t i = 0;
  for (int k = 0; k <= count; ++k) {
    const double wanted = arc.back() * k / count;
    while (i + 1 < piece.size() && arc[i + 1] < wanted) {
      ++i;
    }
    const double t =
        (static_cast<double>(i) + (wanted - arc[i]) / piece[i]) / static_cast<double>(piece.size());
    parameters.push_back(std::clamp(2 * t - 1, -1.0, 1.0));
  }
  return parameters;
}

struct Parameters {
  std::vector<double> u, v;
};

/// Spacing of the grid's columns and rows, from the mean lengths on a coarse grid. Cell lengths
/// are averaged over the face, where the ears' sides (|u| > 0.7) do not count.
Parameters grid_parameters(const HeadModel& head, double edge) {
  constexpr int n = 56;
  std::vector<Vector3d> coarse;
  for (int r = 0; r <= n; ++r) {
    for (int c = 0; c <= n; ++c) {
      coarse.push_back(photographed(head, 2.0 * c / n - 1, 2.0 * r / n - 1));
    }
  }
  const auto at = [&](int r, int c) { return coarse[static_cast<std::size_t>(r * (n + 1) + c)]; };
  std::vector<double> across(n, 0.0);
  std::vector<double> upwards(n, 0.0);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const auto row = static_cast<std::size_t>(r);
      const auto column = static_cast<std::size_t>(c);
      across[column] += (at(r, c + 1) - at(r, c)).norm() / n;
      if (std::abs(2 * c - n) < 0.7 * n) {
        upwards[row] += (at(r + 1, c) - at(r, c)).norm() / (0.7 * n);
      }
    }
  }
  return {evenly_spaced(across, edge), evenly_spaced(upwards, edge)};
}

/// Evens out the grid: each inner point towards its neighbours' mean, then back onto the skin.
/// Every round reads the grid of the round before, so the order of the rows does not matter.
void relax(const HeadModel& head, PhantomPhotograph& photo, unsigned threads, Progress& progress) {
  const int columns = photo.columns;
  Points next = photo.grid;
  for (int round = 0; round < 12; ++round) {
    for_each_row(photo.rows - 2, threads, progress, [&](int row) {
      for (int c = 1; c + 1 < columns; ++c) {
        const int i = (row + 1) * columns + c;
        const Vector3d mean = (photo.grid.row(i - 1) + photo.grid.row(i + 1) +
                               photo.grid.row(i - columns) + photo.grid.row(i + columns)) /
                              4;
        Vector3d p = (Vector3d(photo.grid.row(i)) + mean) / 2;
        for (int newton = 0; newton < 3; ++newton) {
          p -= head.skin(p) * head.skin_normal(p);
        }
        next.row(i) = p;
      }
    });
    photo.grid.swap(next);
  }
}

void keep_oval(const Parameters& parameters, PhantomPhotograph& photo) {
  std::vector<int> vertex(static_cast<std::size_t>(photo.columns * photo.rows), -1);
  const auto inside = [&](int r, int c) {
    const double u = parameters.u[static_cast<std::size_t>(c)];
    const double v = parameters.v[static_cast<std::size_t>(r)];
    return std::pow(std::abs(u), 3) + std::pow(std::abs(v), 3) < 0.998;
  };
  std::vector<std::vector<int>> grid_faces;
  for (int r = 0; r + 1 < photo.rows; ++r) {
    for (int c = 0; c + 1 < photo.columns; ++c) {
      std::vector<int> face;
      const std::array<std::array<int, 2>, 4> corners{
          {{r, c}, {r, c + 1}, {r + 1, c + 1}, {r + 1, c}}};
      for (const auto& [row, column] : corners) {
        if (inside(row, column)) {
          face.push_back(row * photo.columns + column);
        }
      }
      if (face.size() >= 3) {
        grid_faces.push_back(face);
        for (const int i : face) {
          vertex[static_cast<std::size_t>(i)] = 0;
        }
      }
    }
  }
  for (int i = 0; i < photo.columns * photo.rows; ++i) {
    if (vertex[static_cast<std::size_t>(i)] == 0) {
      vertex[static_cast<std::size_t>(i)] = static_cast<int>(photo.kept.size());
      photo.kept.push_back(i);
    }
  }
  for (std::vector<int>& face : grid_faces) {
    for (int& i : face) {
      i = vertex[static_cast<std::size_t>(i)];
    }
  }
  photo.faces = std::move(grid_faces);
}

/// Takes the edge off the rim's steps: each rim vertex half way towards the middle of its two rim
/// neighbours, back on the skin. Once only: more would flatten the rim's triangles.
void smooth_rim(const HeadModel& head, PhantomPhotograph& photo) {
  std::map<std::pair<int, int>, int> uses;
  for (const std::vector<int>& face : photo.faces) {
    for (std::size_t c = 0; c < face.size(); ++c) {
      ++uses[std::minmax(face[c], face[(c + 1) % face.size()])];
    }
  }
  std::map<int, std::vector<int>> neighbours;
  for (const auto& [edge, count] : uses) {
    if (count == 1) {
      neighbours[edge.first].push_back(edge.second);
      neighbours[edge.second].push_back(edge.first);
    }
  }
  const Points before = photo.grid;
  const auto point = [&](int i) -> Vector3d {
    return before.row(photo.kept[static_cast<std::size_t>(i)]);
  };
  for (const auto& [i, others] : neighbours) {
    Vector3d p = point(i) / 2 + (point(others.at(0)) + point(others.at(1))) / 4;
    for (int newton = 0; newton < 3; ++newton) {
      p -= head.skin(p) * head.skin_normal(p);
    }
    photo.grid.row(photo.kept[static_cast<std::size_t>(i)]) = p;
  }
}

/// Bilinear position on the grid, column and row in grid units.
Vector3d grid_position(const PhantomPhotograph& photo, double column, double row) {
  const int c = std::clamp(static_cast<int>(column), 0, photo.columns - 2);
  const int r = std::clamp(static_cast<int>(row), 0, photo.rows - 2);
  const double s = std::clamp(column - c, 0.0, 1.0);
  const double t = std::clamp(row - r, 0.0, 1.0);
  const auto at = [&](int dr, int dc) -> Vector3d {
    return photo.grid.row((r + dr) * photo.columns + c + dc);
  };
  return (1 - t) * ((1 - s) * at(0, 0) + s * at(0, 1)) + t * ((1 - s) * at(1, 0) + s * at(1, 1));
}

std::vector<unsigned char> painted_texture(const PhantomPhotograph& photo, const FacePaint& paint,
                                           const PhantomOptions& options, Progress& progress) {
  const int n = options.texture_pixels;
  cv::Mat image(n, n, CV_8UC3);
  for_each_row(n, options.threads, progress, [&](int j) {
    const double v = 1 - (j + 0.5) / n;
    for (int i = 0; i < n; ++i) {
      const double u = (i + 0.5) / n;
      const Vector3d p = grid_position(photo, (u - margin) / (1 - 2 * margin) * (photo.columns - 1),
                                       (v - margin) / (1 - 2 * margin) * (photo.rows - 1));
      const Vector3d rgb = paint.colour(p) * 255;
      image.at<cv::Vec3b>(j, i) = {cv::saturate_cast<unsigned char>(rgb.z()),
                                   cv::saturate_cast<unsigned char>(rgb.y()),
                                   cv::saturate_cast<unsigned char>(rgb.x())};
    }
  });
  std::vector<unsigned char> png;
  cv::imencode(".png", image, png, {cv::IMWRITE_PNG_COMPRESSION, 4});
  return png;
}

std::string obj_text(const PhantomPhotograph& photo, const Similarity& lps_from_photograph) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "# Gnathion's synthetic face, not a person; mm, y up, z forwards\nmtllib face.mtl\n";
  text << std::fixed;
  text.precision(6);
  for (const int i : photo.kept) {
    const Vector3d p = lps_from_photograph.displacement_to_source(Vector3d(photo.grid.row(i)) -
                                                                  lps_from_photograph.translation);
    text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (const int i : photo.kept) {
    const Eigen::Vector2d t = photo.texture_coordinate(i);
    text << "vt " << t.x() << ' ' << t.y() << '\n';
  }
  text << "g face\nusemtl skin\n";
  for (const std::vector<int>& face : photo.faces) {
    text << 'f';
    for (const int i : face) {
      text << ' ' << i + 1 << '/' << i + 1;
    }
    text << '\n';
  }
  return text.str();
}

void write_bytes(const std::filesystem::path& path, const char* bytes, std::size_t count) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes, static_cast<std::streamsize>(count));
  file.close();
  if (!file) {
    throw Error(ErrorKind::output, path.string(), "the file could not be written",
                "free some space or choose a folder that can be written");
  }
}

}  // namespace

Eigen::Vector2d PhantomPhotograph::texture_coordinate(int grid_index) const {
  const int column = grid_index % columns;
  const int row = grid_index / columns;
  const double u = static_cast<double>(column) / (columns - 1);
  const double v = static_cast<double>(row) / (rows - 1);
  return {margin + (1 - 2 * margin) * u, margin + (1 - 2 * margin) * v};
}

PhantomPhotograph make_phantom_photograph(const HeadModel& head, const PhantomOptions& options,
                                          Progress& progress) {
  const auto stage = progress.stage("phantom photograph");
  const Parameters parameters = grid_parameters(head, options.photograph_edge_mm);
  PhantomPhotograph photo;
  photo.columns = static_cast<int>(parameters.u.size());
  photo.rows = static_cast<int>(parameters.v.size());
  photo.grid.resize(photo.columns * photo.rows, 3);
  for_each_row(photo.rows, options.threads, progress, [&](int r) {
    for (int c = 0; c < photo.columns; ++c) {
      photo.grid.row(r * photo.columns + c) =
          photographed(head, parameters.u[static_cast<std::size_t>(c)],
                       parameters.v[static_cast<std::size_t>(r)]);
    }
  });
  relax(head, photo, options.threads, progress);
  keep_oval(parameters, photo);
  smooth_rim(head, photo);
  return photo;
}

void write_phantom_photograph(const PhantomPhotograph& photograph, const FacePaint& paint,
                              const Similarity& lps_from_photograph,
                              const std::filesystem::path& folder, const PhantomOptions& options,
                              Progress& progress) {
  const auto stage = progress.stage("phantom texture");
  const std::string obj = obj_text(photograph, lps_from_photograph);
  write_bytes(folder / "face.obj", obj.data(), obj.size());
  const std::string mtl =
      "newmtl skin\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nd 1\nillum 1\nmap_Kd face.png\n";
  write_bytes(folder / "face.mtl", mtl.data(), mtl.size());
  const std::vector<unsigned char> png = painted_texture(photograph, paint, options, progress);
  write_bytes(folder / "face.png", reinterpret_cast<const char*>(png.data()), png.size());
}

}  // namespace gnathion

#include "projection/skin_charts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>

#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kDirections = 6;
constexpr double kLeastFacing = 0.45;  // cosine between a triangle and its piece's direction
constexpr double kLeastMargin = 0.1;   // the same of a triangle in a margin

/// A direction from which a piece is looked at, and the picture's axes seen from there.
struct View {
  Vector3d towards, right, down;
};

View view_of(int direction) {
  const Vector3d left(1, 0, 0), back(0, 1, 0), up(0, 0, 1);
  switch (direction) {
    case 0:
      return {-back, left, -up};  // the face
    case 1:
      return {left, back, -up};
    case 2:
      return {-left, -back, -up};
    case 3:
      return {-up, left, back};
    case 4:
      return {up, left, -back};
    default:
      return {back, -left, -up};
  }
}

double area_of(const TriangleMesh& surface, Eigen::Index triangle) {
  const Vector3d a = surface.vertices.row(surface.triangles(triangle, 0)),
                 b = surface.vertices.row(surface.triangles(triangle, 1)),
                 c = surface.vertices.row(surface.triangles(triangle, 2));
  return (b - a).cross(c - a).norm() / 2;
}

/// The triangles that share an edge with each; −1 on a rim.
Triangles neighbours_of(const TriangleMesh& surface) {
  std::unordered_map<std::uint64_t, std::pair<int, int>> open;  // edge → triangle, side
  Triangles neighbours = Triangles::Constant(surface.triangles.rows(), 3, -1);
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax(surface.triangles(f, k), surface.triangles(f, (k + 1) % 3));
      const std::uint64_t edge = static_cast<std::uint64_t>(low) << 32U |
                                 static_cast<std::uint64_t>(static_cast<unsigned>(high));
      const auto [found, is_new] = open.try_emplace(edge, static_cast<int>(f), k);
      if (is_new) continue;
      neighbours(f, k) = found->second.first;
      neighbours(found->second.first, found->second.second) = static_cast<int>(f);
    }
  }
  return neighbours;
}

/// Normals of the triangles evened out over their neighbours, so that pieces do not fray.
Points smooth_normals(const Points& normals, const Triangles& neighbours) {
  Points smooth = normals;
  for (int round = 0; round < 8; ++round) {
    Points next = smooth;
    for (Eigen::Index f = 0; f < smooth.rows(); ++f) {
      for (const int other : neighbours.row(f)) {
        if (other >= 0) next.row(f) += smooth.row(other);
      }
      next.row(f).normalize();
    }
    smooth = next;
  }
  return smooth;
}

/// Grows the pieces.
class Layout {
 public:
  Layout(const TriangleMesh& surface, const ChartOptions& options)
      : surface_(surface),
        options_(options),
        neighbours_(neighbours_of(surface)),
        normals_(triangle_normals(surface)),
        smooth_(smooth_normals(normals_, neighbours_)),
        piece_of_(static_cast<std::size_t>(surface.triangles.rows()), -1) {}

  struct Piece {
    int direction = 0;
    std::vector<int> triangles;
    std::vector<int> margin;
    Vector2d origin = Vector2d::Zero();  ///< of its box, in its direction's own pixels
    int width = 0, height = 0;
    int x = 0, y = 0;  ///< of its box in the picture
  };

  /// What evened-out normals put into no piece, or what would overlap in it, its own normal does.
  void grow(const std::vector<bool>& wanted, Progress& progress) {
    make_sheets(wanted);
    for (const bool smooth : {true, false}) {
      for (Eigen::Index f = 0; f < surface_.triangles.rows(); ++f) {
        if (!wanted[static_cast<std::size_t>(f)]) continue;
        if (piece_of_[static_cast<std::size_t>(f)] >= 0) continue;
        progress.check();
        grow_from(static_cast<int>(f), wanted, smooth);
      }
    }
    for (Piece& piece : pieces_) finish(piece);
  }

  std::vector<Piece>& pieces() { return pieces_; }

  Vector2d place(int vertex, const View& view) const {
    const Vector3d x = surface_.vertices.row(vertex);
    return Vector2d(view.right.dot(x), view.down.dot(x)) / options_.mm_per_pixel;
  }
  std::array<Vector2d, 3> corners(int triangle, const View& view) const {
    std::array<Vector2d, 3> corner;
    for (int k = 0; k < 3; ++k) {
      corner[static_cast<std::size_t>(k)] = place(surface_.triangles(triangle, k), view);
    }
    return corner;
  }

 private:
  int direction_of(int triangle, bool smooth) const {
    const Vector3d normal = (smooth ? smooth_ : normals_).row(triangle);
    int best = 0;
    for (int d = 1; d < kDirections; ++d) {
      if (view_of(d).towards.dot(normal) > view_of(best).towards.dot(normal)) best = d;
    }
    return best;
  }
  double facing(int triangle, const View& view) const {
    return normals_.row(triangle).dot(view.towards);
  }

  /// Takes the triangle's pixels for the piece; false, and none taken, when another triangle of it
  /// has one of them.
  bool take_pixels(int triangle, int direction, int piece) {
    Sheet& sheet = sheets_[static_cast<std::size_t>(direction)];
    auto corner = corners(triangle, view_of(direction));
    for (Vector2d& c : corner) c -= sheet.origin;
    bool free = true;
    const auto each = [&](const auto& pixel) {
      for_each_pixel(corner, sheet.width, sheet.height, [&](int x, int y, const Vector3d& weights) {
        if (weights.minCoeff() < 1e-9) return;  // on an edge, which its neighbour shares
        pixel(sheet.piece[static_cast<std::size_t>(y) * static_cast<std::size_t>(sheet.width) +
                          static_cast<std::size_t>(x)]);
      });
    };
    each([&](int taken_by) { free = free && taken_by != piece; });
    if (free) each([&](int& taken_by) { taken_by = piece; });
    return free;
  }

  /// The pixels of all that is wanted, seen along a direction.
  void make_sheets(const std::vector<bool>& wanted) {
    for (int d = 0; d < kDirections; ++d) {
      Sheet& sheet = sheets_[static_cast<std::size_t>(d)];
      Vector2d least = Vector2d::Constant(1e9), most = Vector2d::Constant(-1e9);
      for (Eigen::Index f = 0; f < surface_.triangles.rows(); ++f) {
        if (!wanted[static_cast<std::size_t>(f)]) continue;
        for (const Vector2d& c : corners(static_cast<int>(f), view_of(d))) {
          least = least.cwiseMin(c);
          most = most.cwiseMax(c);
        }
      }
      sheet.origin = least.array().floor();
      sheet.width = std::max(0, static_cast<int>(most.x() - sheet.origin.x()) + 2);
      sheet.height = std::max(0, static_cast<int>(most.y() - sheet.origin.y()) + 2);
      sheet.piece.assign(
          static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height), -1);
    }
  }

  void grow_from(int seed, const std::vector<bool>& wanted, bool smooth) {
    const int direction = direction_of(seed, smooth);
    const View view = view_of(direction);
    Piece piece;
    piece.direction = direction;
    const int number = static_cast<int>(pieces_.size());
    std::vector<int> front{seed};
    for (std::size_t next = 0; next < front.size(); ++next) {
      const int f = front[next];
      if (piece_of_[static_cast<std::size_t>(f)] >= 0) continue;
      if (facing(f, view) < kLeastFacing || !take_pixels(f, direction, number)) continue;
      piece_of_[static_cast<std::size_t>(f)] = number;
      piece.triangles.push_back(f);
      for (const int other : neighbours_.row(f)) {
        if (other < 0 || !wanted[static_cast<std::size_t>(other)]) continue;
        if (piece_of_[static_cast<std::size_t>(other)] >= 0) continue;
        if (direction_of(other, smooth) == direction) front.push_back(other);
      }
    }
    if (!piece.triangles.empty()) pieces_.push_back(std::move(piece));
  }

  /// The triangles around a piece that face its direction a little, as far as the margin reaches.
  void add_margin(Piece& piece) const {
    const View view = view_of(piece.direction);
    std::vector<int> ring = piece.triangles;
    std::map<int, bool> seen;
    for (const int f : ring) seen[f] = true;
    const double edge = mean_edge_length(surface_);
    const int rings = 1 + 2 * static_cast<int>(std::ceil(options_.margin_mm / edge));
    for (int round = 0; round < rings; ++round) {
      std::vector<int> next;
      for (const int f : ring) {
        for (const int other : neighbours_.row(f)) {
          if (other < 0 || seen[other] || facing(other, view) < kLeastMargin) continue;
          seen[other] = true;
          next.push_back(other);
        }
      }
      piece.margin.insert(piece.margin.end(), next.begin(), next.end());
      ring = std::move(next);
    }
  }

  void finish(Piece& piece) const {
    add_margin(piece);
    const View view = view_of(piece.direction);
    Vector2d least = Vector2d::Constant(1e9), most = Vector2d::Constant(-1e9);
    for (const int f : piece.triangles) {
      for (const Vector2d& c : corners(f, view)) {
        least = least.cwiseMin(c);
        most = most.cwiseMax(c);
      }
    }
    const int margin = std::max(4, static_cast<int>(options_.margin_mm / options_.mm_per_pixel));
    piece.origin = least.array().floor() - margin;
    const Vector2d size = most - piece.origin;
    piece.width = static_cast<int>(std::ceil(size.x())) + margin + 1;
    piece.height = static_cast<int>(std::ceil(size.y())) + margin + 1;
  }

  /// Which piece has each pixel.
  struct Sheet {
    Vector2d origin;
    int width = 0, height = 0;
    std::vector<int> piece;
  };

  const TriangleMesh& surface_;
  const ChartOptions& options_;
  Triangles neighbours_;
  Points normals_, smooth_;
  std::vector<int> piece_of_;  ///< of each triangle
  std::vector<Piece> pieces_;
  std::array<Sheet, kDirections> sheets_;
};

/// Boxes on shelves, the highest first. Returns the picture's height.
int shelve(std::vector<Layout::Piece>& pieces, int width) {
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return pieces[a].height > pieces[b].height;
  });
  int x = 0, y = 0, shelf = 0;
  for (const std::size_t i : order) {
    Layout::Piece& piece = pieces[i];
    if (x > 0 && x + piece.width > width) {
      x = 0;
      y += shelf;
      shelf = 0;
    }
    piece.x = x;
    piece.y = y;
    x += piece.width;
    shelf = std::max(shelf, piece.height);
  }
  return y + shelf;
}

/// The narrowest width that makes the picture about as high as it is wide.
void pack(std::vector<Layout::Piece>& pieces, SkinCharts& charts) {
  double area = 0;
  int widest = 16;
  for (const Layout::Piece& piece : pieces) {
    area += static_cast<double>(piece.width) * piece.height;
    widest = std::max(widest, piece.width);
  }
  charts.width = std::max(widest, static_cast<int>(std::sqrt(area)));
  charts.height = std::max(16, shelve(pieces, charts.width));
  while (charts.height > charts.width) {
    charts.width += charts.width / 16 + 1;
    charts.height = std::max(16, shelve(pieces, charts.width));
  }
  charts.plain = {4, charts.height + 12};
  charts.height += 17;
}

/// Where the corners are, and what is drawn.
void place(const Layout& layout, const std::vector<Layout::Piece>& pieces,
           const TriangleMesh& surface, SkinCharts& charts) {
  charts.corners = Triangles::Constant(surface.triangles.rows(), 3, -1);
  std::vector<Vector2d> places;
  std::vector<SkinCharts::Drawn> own;
  for (const Layout::Piece& piece : pieces) {
    const auto number = static_cast<int>(charts.pieces.size());
    charts.pieces.push_back({piece.x, piece.y, piece.width, piece.height});
    const View view = view_of(piece.direction);
    const Vector2d shift = Vector2d(piece.x, piece.y) - piece.origin;
    const auto drawn = [&](int f) {
      SkinCharts::Drawn d{f, number, layout.corners(f, view)};
      for (Vector2d& c : d.corner) c += shift;
      return d;
    };
    for (const int f : piece.margin) charts.drawn.push_back(drawn(f));
    std::map<int, int> row_of;
    for (const int f : piece.triangles) {
      own.push_back(drawn(f));
      for (int k = 0; k < 3; ++k) {
        const int v = surface.triangles(f, k);
        const auto [row, is_new] = row_of.try_emplace(v, static_cast<int>(places.size()));
        if (is_new) places.push_back(own.back().corner[static_cast<std::size_t>(k)]);
        charts.corners(f, k) = row->second;
      }
    }
  }
  charts.drawn.insert(charts.drawn.end(), own.begin(), own.end());
  charts.places.resize(static_cast<Eigen::Index>(places.size()), 2);
  for (std::size_t i = 0; i < places.size(); ++i) {
    charts.places.row(static_cast<Eigen::Index>(i)) = places[i];
  }
}

}  // namespace

SkinCharts lay_out(const TriangleMesh& surface, const std::vector<bool>& wanted,
                   const ChartOptions& options, Progress& progress) {
  ChartOptions tried = options;
  // Boxes are about half full.
  double area = 0;
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    if (wanted[static_cast<std::size_t>(f)]) area += area_of(surface, f);
  }
  tried.mm_per_pixel = std::max(tried.mm_per_pixel, std::sqrt(1.5 * area) / options.largest_side);
  while (true) {
    Layout layout(surface, tried);
    layout.grow(wanted, progress);
    SkinCharts charts;
    charts.mm_per_pixel = tried.mm_per_pixel;
    pack(layout.pieces(), charts);
    if (charts.width <= options.largest_side && charts.height <= options.largest_side) {
      place(layout, layout.pieces(), surface, charts);
      return charts;
    }
    tried.mm_per_pixel *= 1.2;
  }
}

}  // namespace gnathion

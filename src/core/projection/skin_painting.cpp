#include "projection/skin_painting.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "projection/photo_view.h"
#include "registration/parallel.h"

namespace gnathion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFinest = 0.2, kCoarsest = 1;  // mm in a pixel, where it is chosen
constexpr double kLeastWeight = 1e-6;           // of a pixel that is seen
constexpr double kSharpness = 8;                // power of the weights for the fine band
constexpr float kGutterPixels = 6;              // beside a piece that have its border's colours
constexpr int kMadeUpRounds = 6;                // of evening out what is made up

/// Everything that a pixel is painted from.
struct Palette {
  std::span<const PlacedPhoto> photos;
  std::vector<PhotoView> views;
  std::vector<cv::Mat> pictures;  ///< RGB, no finer than what is painted
  std::vector<double> scale;      ///< of these to the photographs
  const TriangleMesh* skin = nullptr;
  std::vector<double> beyond;  ///< mm of each vertex from what is seen
  Points made_up;              ///< n×3, colours of the vertices that are not seen
};

/// Logarithms of the gains: the least squares of what pairs of photographs say where both see the
/// same, the first's held at 0; one that shares nothing keeps its colours.
void match_colours(std::vector<PhotoView>& views, PaintedSkin& painted) {
  const auto count = static_cast<Eigen::Index>(views.size());
  for (int channel = 0; channel < 3; ++channel) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(count, count) * 1e-6;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(count);
    a(0, 0) += 1e6;
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j < i; ++j) {
        const PhotoView &one = views[static_cast<std::size_t>(i)],
                        &two = views[static_cast<std::size_t>(j)];
        std::vector<double> ratios;
        for (std::size_t v = 0; v < one.weight.size(); ++v) {
          const auto row = static_cast<Eigen::Index>(v);
          const double p = one.broad(row, channel), q = two.broad(row, channel);
          const bool both = one.weight[v] > 0.05 && two.weight[v] > 0.05;
          // What is nearly black or clipped says nothing of light.
          if (both && std::min(p, q) > 0.08 && std::max(p, q) < 0.97)
            ratios.push_back(std::log(q / p));
        }
        if (ratios.size() < 30) continue;
        const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
        std::nth_element(ratios.begin(), middle, ratios.end());
        const auto weight = static_cast<double>(ratios.size());
        a(i, i) += weight;
        a(j, j) += weight;
        a(i, j) -= weight;
        a(j, i) -= weight;
        b[i] += weight * *middle;
        b[j] -= weight * *middle;
      }
    }
    const Eigen::VectorXd gain = a.ldlt().solve(b).array().exp();
    for (Eigen::Index i = 0; i < count; ++i) {
      painted.photos[static_cast<std::size_t>(i)].gain[channel] = gain[i];
      views[static_cast<std::size_t>(i)].broad.col(channel) *= gain[i];
    }
  }
}

double disagreement_of(const std::vector<PhotoView>& views) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t v = 0; v < views[i].weight.size(); ++v) {
        if (views[i].weight[v] <= 0.05 || views[j].weight[v] <= 0.05) continue;
        const auto row = static_cast<Eigen::Index>(v);
        sum += (views[i].broad.row(row) - views[j].broad.row(row)).cwiseAbs().mean();
        ++count;
      }
    }
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

/// The photograph, small enough not to flicker where it is finer than what is painted.
void add_picture(const PlacedPhoto& photo, const PhotoView& view, double mm_per_pixel,
                 Palette& palette) {
  const Photo& own = *photo.photo;
  const cv::Mat full(own.height, own.width, CV_8UC3, const_cast<std::uint8_t*>(own.rgb.data()));
  const double scale = std::min(1.0, 1.2 * view.mm_per_pixel / mm_per_pixel);
  cv::Mat picture = full;
  if (scale < 0.9) cv::resize(full, picture, {}, scale, scale, cv::INTER_AREA);
  palette.pictures.push_back(picture);
  palette.scale.push_back(scale < 0.9 ? scale : 1);
}

/// Between the four pixels around a place, sRGB 0..1.
Vector3d colour_at(const cv::Mat& picture, const Vector2d& place) {
  const double x = std::clamp(place.x(), 0.0, picture.cols - 1.001);
  const double y = std::clamp(place.y(), 0.0, picture.rows - 1.001);
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const auto at = [&](int dx, int dy) {
    const auto& c = picture.at<cv::Vec3b>(j + dy, i + dx);
    return Vector3d(c[0], c[1], c[2]);
  };
  const double s = x - i, t = y - j;
  return ((1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1))) /
         255;
}

/// The colour of a place of the skin.
Vector3d painted_at(const Palette& palette, const PaintedSkin& painted, int triangle,
                    const Vector3d& weights) {
  const Eigen::RowVector3i corner = palette.skin->triangles.row(triangle);
  Vector3d place = Vector3d::Zero(), broad = Vector3d::Zero(), fine = Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    place += weights[k] * palette.skin->vertices.row(corner[k]).transpose();
  double broad_sum = 0, fine_sum = 0;
  for (std::size_t i = 0; i < palette.views.size(); ++i) {
    const PhotoView& view = palette.views[i];
    double weight = 0;
    Vector3d low = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      weight += weights[k] * view.weight[static_cast<std::size_t>(corner[k])];
      low += weights[k] * view.broad.row(corner[k]).transpose();
    }
    if (weight <= kLeastWeight) continue;
    const Vector2d pixel = palette.photos[i].camera.pixel(place);
    const Vector2d scaled = (pixel.array() + 0.5) * palette.scale[i] - 0.5;
    const Vector3d colour =
        colour_at(palette.pictures[i], scaled).cwiseProduct(painted.photos[i].gain);
    const double sharp = std::pow(weight, kSharpness);
    broad += weight * low;
    fine += sharp * (colour - low);
    broad_sum += weight;
    fine_sum += sharp;
  }
  if (fine_sum > 0) return broad / broad_sum + fine / fine_sum;
  Vector3d made_up = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) made_up += weights[k] * palette.made_up.row(corner[k]).transpose();
  return made_up;
}

/// Which drawn triangle each pixel shows; −1: none.
cv::Mat owners(const SkinCharts& charts) {
  cv::Mat owner(charts.height, charts.width, CV_32S, cv::Scalar(-1));
  for (std::size_t d = 0; d < charts.drawn.size(); ++d) {
    const SkinCharts::Drawn& drawn = charts.drawn[d];
    const SkinCharts::Box& box = charts.pieces[static_cast<std::size_t>(drawn.piece)];
    for_each_pixel(drawn.corner, charts.width, charts.height, [&](int x, int y, const auto&) {
      if (x < box.x || y < box.y || x >= box.x + box.width || y >= box.y + box.height) return;
      owner.at<int>(y, x) = static_cast<int>(d);
    });
  }
  return owner;
}

Vector3d weights_in(const std::array<Vector2d, 3>& corner, int x, int y) {
  Vector3d weights = Vector3d::Zero();
  for_each_pixel(
      {corner[0] - Vector2d(x, y), corner[1] - Vector2d(x, y), corner[2] - Vector2d(x, y)}, 1, 1,
      [&](int, int, const Vector3d& w) { weights = w; });
  return weights;
}

/// A picture that is being painted.
struct Canvas {
  cv::Mat colour;  ///< RGB
  cv::Mat open;    ///< 255 beside the pieces
  cv::Mat owner;
};

cv::Vec3b bytes(const Vector3d& colour) {
  const Vector3d c = 255 * colour.cwiseMax(0).cwiseMin(1);
  return {cv::saturate_cast<std::uint8_t>(c[0]), cv::saturate_cast<std::uint8_t>(c[1]),
          cv::saturate_cast<std::uint8_t>(c[2])};
}

Canvas painted_canvas(const Palette& palette, const PaintedSkin& painted, Progress& progress) {
  const SkinCharts& charts = painted.charts;
  Canvas canvas{cv::Mat(charts.height, charts.width, CV_8UC3), {}, owners(charts)};
  canvas.open = cv::Mat(charts.height, charts.width, CV_8U, cv::Scalar(255));
  for_each_in_parallel(static_cast<std::size_t>(charts.height), [&](std::size_t row) {
    progress.check();
    const int y = static_cast<int>(row);
    for (int x = 0; x < charts.width; ++x) {
      cv::Vec3b& pixel = canvas.colour.at<cv::Vec3b>(y, x);
      pixel = bytes(painted.plain);
      const int owner = canvas.owner.at<int>(y, x);
      if (owner < 0) continue;
      const SkinCharts::Drawn& drawn = charts.drawn[static_cast<std::size_t>(owner)];
      pixel = bytes(painted_at(palette, painted, drawn.triangle, weights_in(drawn.corner, x, y)));
      canvas.open.at<std::uint8_t>(y, x) = 0;
    }
  });
  return canvas;
}

/// Beside a piece the colours of its border go on, so that no pixel of another piece or of none
/// shines in where the picture is smoothed.
void widen_pieces(Canvas& canvas) {
  cv::Mat distance, label;
  cv::distanceTransform(canvas.open, distance, label, cv::DIST_L2, cv::DIST_MASK_5,
                        cv::DIST_LABEL_PIXEL);
  std::vector<cv::Point> nearest;  // painted pixel of each label
  for (int y = 0; y < label.rows; ++y) {
    for (int x = 0; x < label.cols; ++x) {
      if (canvas.open.at<std::uint8_t>(y, x) != 0) continue;
      const auto number = static_cast<std::size_t>(label.at<int>(y, x));
      if (nearest.size() <= number) nearest.resize(number + 1);
      nearest[number] = {x, y};
    }
  }
  for (int y = 0; y < label.rows; ++y) {
    for (int x = 0; x < label.cols; ++x) {
      const float away = distance.at<float>(y, x);
      if (away == 0 || away > kGutterPixels || canvas.owner.at<int>(y, x) >= 0) continue;
      const cv::Point& from = nearest[static_cast<std::size_t>(label.at<int>(y, x))];
      canvas.colour.at<cv::Vec3b>(y, x) = canvas.colour.at<cv::Vec3b>(from);
      canvas.open.at<std::uint8_t>(y, x) = 0;
    }
  }
}

double area_of(const TriangleMesh& mesh, Eigen::Index f) {
  const Vector3d a = mesh.vertices.row(mesh.triangles(f, 0)),
                 b = mesh.vertices.row(mesh.triangles(f, 1)),
                 c = mesh.vertices.row(mesh.triangles(f, 2));
  return (b - a).cross(c - a).norm() / 200;  // cm²
}

/// cm² by photograph and together. Returns which triangles get colours of their own.
std::vector<bool> measure(const Palette& palette, double reach_mm, PaintedSkin& painted) {
  const TriangleMesh& skin = *palette.skin;
  std::vector<bool> wanted(static_cast<std::size_t>(skin.triangles.rows()));
  for (Eigen::Index f = 0; f < skin.triangles.rows(); ++f) {
    const double area = area_of(skin, f);
    const auto all = [&](const auto& holds) {
      return holds(skin.triangles(f, 0)) && holds(skin.triangles(f, 1)) &&
             holds(skin.triangles(f, 2));
    };
    for (std::size_t i = 0; i < palette.views.size(); ++i) {
      const auto& weight = palette.views[i].weight;
      const bool seen = all([&](int v) { return weight[static_cast<std::size_t>(v)] > 0; });
      if (seen) painted.photos[i].seen_cm2 += area;
    }
    const auto beyond = [&](int v) { return palette.beyond[static_cast<std::size_t>(v)]; };
    wanted[static_cast<std::size_t>(f)] = !all([&](int v) { return beyond(v) >= reach_mm; });
    const bool seen = all([&](int v) { return beyond(v) <= 0; });
    painted.skin_cm2 += area;
    if (seen) painted.seen_cm2 += area;
    if (!seen && wanted[static_cast<std::size_t>(f)]) painted.inpainted_cm2 += area;
  }
  return wanted;
}

/// The median colour of what is seen; and how far each vertex is from that.
void find_seen(const std::vector<std::vector<int>>& neighbours, double reach_mm, Palette& palette,
               PaintedSkin& painted) {
  const auto count = neighbours.size();
  std::vector<bool> seen(count);
  std::array<std::vector<double>, 3> channels;
  for (const PhotoView& view : palette.views) {
    for (std::size_t v = 0; v < count; ++v) {
      if (view.weight[v] <= 0) continue;
      seen[v] = true;
      if (view.weight[v] < 0.3) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        channels[c].push_back(
            view.broad(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c)));
      }
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<double>& values = channels[c];
    if (values.empty()) continue;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    painted.plain[static_cast<Eigen::Index>(c)] = std::min(1.0, *middle);
  }
  palette.beyond = edge_distances(palette.skin->vertices, neighbours, seen, reach_mm);
}

/// The broad colours carried on over the skin, so that no seam of the picture shows; they fade into
/// the plain one.
void make_up(const std::vector<std::vector<int>>& neighbours, double reach_mm,
             const Vector3d& plain, Palette& palette) {
  const auto count = neighbours.size();
  palette.made_up = plain.transpose().replicate(static_cast<Eigen::Index>(count), 1);
  std::vector<std::size_t> order;
  for (std::size_t v = 0; v < count; ++v) {
    double sum = 0;
    Eigen::RowVector3d colour = Eigen::RowVector3d::Zero();
    for (const PhotoView& view : palette.views) {
      sum += view.weight[v];
      colour += view.weight[v] * view.broad.row(static_cast<Eigen::Index>(v));
    }
    if (sum > 0) palette.made_up.row(static_cast<Eigen::Index>(v)) = colour / sum;
    if (sum <= 0 && palette.beyond[v] < reach_mm) order.push_back(v);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(palette.beyond[a], a) < std::pair(palette.beyond[b], b);
  });
  for (int round = 0; round <= kMadeUpRounds; ++round) {
    for (const std::size_t v : order) {
      int used = 0;
      Eigen::RowVector3d colour = Eigen::RowVector3d::Zero();
      for (const int u : neighbours[v]) {
        const double beyond = palette.beyond[static_cast<std::size_t>(u)];
        // At first from what is nearer to the seen skin alone: the rest is not made up yet.
        if (beyond >= reach_mm || (round == 0 && beyond >= palette.beyond[v])) continue;
        colour += palette.made_up.row(u);
        ++used;
      }
      if (used > 0) palette.made_up.row(static_cast<Eigen::Index>(v)) = colour / used;
    }
  }
  for (const std::size_t v : order) {
    const double fade = smooth_step(0, reach_mm, palette.beyond[v]);
    auto row = palette.made_up.row(static_cast<Eigen::Index>(v));
    row = (1 - fade) * row + fade * plain.transpose();
  }
}

}  // namespace

PaintedSkin paint_skin(std::span<const PlacedPhoto> photos, const SkinSight& skin,
                       const PaintOptions& options, Progress& progress) {
  const auto stage = progress.stage("painting the skin");
  const auto neighbours = vertex_neighbours(skin.mesh());
  Palette palette;
  palette.photos = photos;
  palette.skin = &skin.mesh();
  PaintedSkin painted;
  double finest = kCoarsest;
  for (const PlacedPhoto& photo : photos) {
    palette.views.push_back(view_of(photo, skin, neighbours, progress));
    painted.photos.push_back({photo.name});
    finest = std::min(finest, palette.views.back().mm_per_pixel);
  }
  match_colours(palette.views, painted);
  painted.disagreement = disagreement_of(palette.views);
  find_seen(neighbours, options.inpaint_mm, palette, painted);
  make_up(neighbours, options.inpaint_mm, painted.plain, palette);
  const std::vector<bool> wanted = measure(palette, options.inpaint_mm, painted);
  ChartOptions charts;
  charts.mm_per_pixel = options.mm_per_pixel.value_or(std::max(kFinest, finest));
  painted.charts = lay_out(skin.mesh(), wanted, charts, progress);
  for (std::size_t i = 0; i < photos.size(); ++i) {
    add_picture(photos[i], palette.views[i], painted.charts.mm_per_pixel, palette);
  }
  Canvas canvas = painted_canvas(palette, painted, progress);
  widen_pieces(canvas);
  painted.picture = {canvas.colour.cols, canvas.colour.rows, {}};
  painted.picture.rgb.assign(canvas.colour.datastart, canvas.colour.dataend);
  return painted;
}

RawScan scan_of(const PaintedSkin& painted, const TriangleMesh& skin) {
  RawScan scan;
  scan.surface = skin;
  const SkinCharts& charts = painted.charts;
  const Eigen::Index plain = charts.places.rows();
  scan.texture_coordinates.resize(plain + 1, 2);
  const auto coordinate = [&](const Eigen::RowVector2d& pixel) {
    return Eigen::RowVector2d((pixel.x() + 0.5) / charts.width,
                              1 - (pixel.y() + 0.5) / charts.height);
  };
  for (Eigen::Index i = 0; i < plain; ++i) {
    scan.texture_coordinates.row(i) = coordinate(charts.places.row(i));
  }
  scan.texture_coordinates.row(plain) = coordinate(charts.plain.transpose());
  scan.corner_texture = charts.corners.unaryExpr(
      [plain](int row) { return row < 0 ? static_cast<int>(plain) : row; });
  scan.material.assign(static_cast<std::size_t>(skin.triangles.rows()), 0);
  scan.materials = {{"skin", Vector3d::Ones(), 0}};
  scan.textures = {{"photograph.png", true, png_of(painted.picture)}};
  return scan;
}

}  // namespace gnathion

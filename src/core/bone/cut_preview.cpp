#include "bone/cut_preview.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <utility>

#include "bone/cut_box.h"
#include "bone/section_spans.h"
#include "geometry/bsp_tree.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

constexpr double row_step = 0.5;      // mm between the rows of a section
constexpr double least_patch = 10;    // mm², less is a graze
constexpr double marked_reach = 2.5;  // mm beside a forbidden cut that is coloured with it

/// Disjoint sets of whole numbers.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (at(i) != i) {
      at(i) = at(at(i));
      i = at(i);
    }
    return i;
  }
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    at(std::max(a, b)) = std::min(a, b);
  }
  std::size_t size() const { return parent_.size(); }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

/// The blade's rectangle, or the six sides of a box with their normals outward.
std::vector<Rectangle> rectangles_of(const BoxCut& box, bool is_plate) {
  const auto side = [&box](int axis, double sign) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    return Rectangle{box.centre + sign * box.half_extents(axis) * box.axes.col(axis),
                     box.axes.col(a),
                     box.axes.col(b),
                     sign * box.axes.col(axis),
                     box.half_extents(a),
                     box.half_extents(b)};
  };
  if (is_plate) {
    Rectangle blade = side(2, 1);
    blade.centre = box.centre;
    return {blade};
  }
  return {side(0, -1), side(0, 1), side(1, -1), side(1, 1), side(2, -1), side(2, 1)};
}

double part_of_volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                      const Eigen::Vector3d& c) {
  return a.dot(b.cross(c)) / 6;
}

using Polygon = std::vector<Eigen::Vector3d>;

/// What lies on the negative side of the plane normal·x = offset.
Polygon clipped(const Polygon& polygon, const Eigen::Vector3d& normal, double offset) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d& p = polygon[i];
    const Eigen::Vector3d& q = polygon[(i + 1) % polygon.size()];
    const double from = normal.dot(p) - offset, to = normal.dot(q) - offset;
    if (from < 0) kept.push_back(p);
    if ((from < 0) != (to < 0)) kept.push_back(p + from / (from - to) * (q - p));
  }
  return kept;
}

double part_of_volume(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += part_of_volume(polygon[0], polygon[i - 1], polygon[i]);
  }
  return sum;
}

/// "behind", "above" …: where `direction` (LPS) points to.
std::string place_word(const Eigen::Vector3d& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  constexpr std::array<std::array<const char*, 2>, 3> words = {
      {{"on the patient's right of", "on the patient's left of"},
       {"in front of", "behind"},
       {"below", "above"}}};
  return words[static_cast<std::size_t>(axis)][direction(axis) > 0 ? 1 : 0];
}

std::string rounded(double value, const char* unit) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.1f %s", value, unit);
  return text.data();
}

}  // namespace

/// The bone with what does not depend on the cut.
struct PreviewedBone {
  TriangleMesh mesh;
  std::vector<int> component;   ///< of the vertices
  Eigen::Vector3d centre;       ///< of the bounding box
  Eigen::VectorXd volume_part;  ///< m: of the tetrahedra from `centre` to the triangles, mm³
  Points area_vector;           ///< m×3: along the normals, as long as the area, mm²
  BspTree tree;

  explicit PreviewedBone(TriangleMesh bone) : mesh(std::move(bone)), tree(mesh) {
    centre = 0.5 * (mesh.vertices.colwise().minCoeff() + mesh.vertices.colwise().maxCoeff());
    volume_part.resize(mesh.triangles.rows());
    area_vector.resize(mesh.triangles.rows(), 3);
    component.assign(static_cast<std::size_t>(mesh.vertices.rows()), -1);
    const std::vector<int> of_triangle = triangle_components(mesh);
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
      const Eigen::Vector3d a = corner(t, 0) - centre, b = corner(t, 1) - centre,
                            c = corner(t, 2) - centre;
      volume_part(t) = part_of_volume(a, b, c);
      area_vector.row(t) = 0.5 * (b - a).cross(c - a).transpose();
      for (int k = 0; k < 3; ++k) {
        component[static_cast<std::size_t>(mesh.triangles(t, k))] =
            of_triangle[static_cast<std::size_t>(t)];
      }
    }
  }
  Eigen::Vector3d corner(Eigen::Index triangle, int k) const {
    return mesh.vertices.row(mesh.triangles(triangle, k)).transpose();
  }
};

namespace {

/// A sawn area that hangs together.
struct Patch {
  double area = 0;                                   // mm²
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // LPS mm
  int outer = -1, inner = -1;                        // nodes on its two sides
  Eigen::Vector3d border = Eigen::Vector3d::Zero();  // towards where the blade ends in it
  double border_rows = 0;                            // how long that border is, in rows
  std::size_t rectangle = 0;                         // one of those it lies on
  Eigen::AlignedBox2d extent;                        // on that
};

struct Piece {
  int component = -1;
  bool inside = false;  // the box; of a blade: behind it
  double volume = 0;    // mm³
  CutPart part = CutPart::kept;
};

/// One preview being worked out. The surface's vertices and the two sides of every span of the
/// sawn areas are nodes; those that hang together after the cut are joined.
class Cutting {
 public:
  Cutting(const PreviewedBone& bone, const BoundedCut& cut, const CutOptions& options)
      : bone_(bone),
        box_(box_of(cut)),
        plate_(std::get_if<PlateCut>(&cut)),
        options_(options),
        rectangles_(rectangles_of(box_, plate_ != nullptr)) {
    code_vertices();
    make_sections();
    join_surface();
    join_sections();
    flatten();
    measure();
    find_pieces();
    find_patches();
  }

  CutPreview result() {
    choose_segment();
    give_parts();
    CutPreview preview;
    preview.refusal = refusal();
    if (comes_off()) preview.segment_mm3 = piece(segment_).volume;
    for (const Piece& p : pieces_) {
      if (p.part == CutPart::loose) preview.loose_mm3.push_back(p.volume);
    }
    for (const Patch& patch : patches_) preview.sawn_mm2 += patch.area;
    colour(preview.part);
    return preview;
  }

 private:
  bool is_inside(int vertex) const { return codes_[static_cast<std::size_t>(vertex)] == 0; }
  Piece& piece(int p) { return pieces_[static_cast<std::size_t>(p)]; }
  int piece_of_node(int node) const {
    return piece_of_root_[static_cast<std::size_t>(root_[static_cast<std::size_t>(node)])];
  }
  int outer_node(std::size_t span) const { return vertex_count() + 2 * static_cast<int>(span); }
  int inner_node(std::size_t span) const { return outer_node(span) + 1; }
  int vertex_count() const { return static_cast<int>(bone_.mesh.vertices.rows()); }

  /// A bit for each rectangle that a vertex lies beyond; none: inside the box, or behind the blade.
  void code_vertices() {
    codes_.resize(static_cast<std::size_t>(vertex_count()));
    for (std::size_t v = 0; v < codes_.size(); ++v) {
      const Eigen::Vector3d x = bone_.mesh.vertices.row(static_cast<Eigen::Index>(v));
      for (std::size_t r = 0; r < rectangles_.size(); ++r) {
        const bool beyond = (x - rectangles_[r].centre).dot(rectangles_[r].normal) >= 0;
        codes_[v] = static_cast<std::uint8_t>(codes_[v] | (beyond ? 1U << r : 0U));
      }
    }
  }

  void make_sections() {
    const auto count = static_cast<std::size_t>(bone_.mesh.triangles.rows());
    crossed_.assign(count, false);
    std::vector<std::vector<int>> crossing(rectangles_.size());
    for (std::size_t t = 0; t < count; ++t) {
      const int* corners = &bone_.mesh.triangles(static_cast<Eigen::Index>(t), 0);
      const unsigned a = codes_[static_cast<std::size_t>(corners[0])];
      const unsigned b = codes_[static_cast<std::size_t>(corners[1])];
      const unsigned c = codes_[static_cast<std::size_t>(corners[2])];
      const unsigned planes = (a | b | c) & ~(a & b & c);
      if (planes == 0) continue;
      // A corner in the box and one outside: divided, though rounding may hide where.
      crossed_[t] = plate_ == nullptr && (a == 0 || b == 0 || c == 0);
      for (std::size_t r = 0; r < rectangles_.size(); ++r) {
        if ((planes >> r & 1U) != 0) crossing[r].push_back(static_cast<int>(t));
      }
    }
    for (std::size_t r = 0; r < rectangles_.size(); ++r) {
      sections_.push_back(section_of(bone_.mesh, rectangles_[r], crossing[r], codes_,
                                     static_cast<std::uint8_t>(1U << r), row_step));
      for (const int t : sections_[r].triangles) crossed_[static_cast<std::size_t>(t)] = true;
      first_span_.push_back(span_count_);
      span_count_ += sections_[r].spans.size();
    }
  }

  void join_surface() {
    nodes_ = Sets(static_cast<std::size_t>(vertex_count()) + 2 * span_count_);
    areas_ = Sets(span_count_);
    for (std::size_t t = 0; t < crossed_.size(); ++t) {
      const int* corners = &bone_.mesh.triangles(static_cast<Eigen::Index>(t), 0);
      if (!crossed_[t]) {
        nodes_.join(corners[0], corners[1]);
        nodes_.join(corners[1], corners[2]);
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        const int p = corners[k], q = corners[(k + 1) % 3];
        if (is_inside(p) == is_inside(q)) nodes_.join(p, q);
      }
    }
  }

  void join_sections() {
    for (std::size_t r = 0; r < sections_.size(); ++r) {
      const std::vector<Span>& spans = sections_[r].spans;
      std::size_t above = 0;  // the first span of the next row that may overlap
      for (std::size_t s = 0; s < spans.size(); ++s) {
        join_with_surface(r, s);
        while (above < spans.size() &&
               (spans[above].row <= spans[s].row ||
                (spans[above].row == spans[s].row + 1 && spans[above].end < spans[s].begin))) {
          ++above;
        }
        for (std::size_t o = above;
             o < spans.size() && spans[o].row == spans[s].row + 1 && spans[o].begin <= spans[s].end;
             ++o) {
          join_spans(first_span_[r] + s, first_span_[r] + o);
        }
      }
    }
    if (plate_ == nullptr) {
      join_around_edges();
    } else {
      join_around_blade();
    }
  }

  void join_spans(std::size_t a, std::size_t b) {
    nodes_.join(outer_node(a), outer_node(b));
    nodes_.join(inner_node(a), inner_node(b));
    areas_.join(static_cast<int>(a), static_cast<int>(b));
  }

  void join_with_surface(std::size_t r, std::size_t s) {
    const Span& span = sections_[r].spans[s];
    for (const int triangle : {span.first, span.last}) {
      if (triangle < 0) continue;
      for (int k = 0; k < 3; ++k) {
        const int v = bone_.mesh.triangles(triangle, k);
        if (is_inside(v)) nodes_.join(v, inner_node(first_span_[r] + s));
        if ((codes_[static_cast<std::size_t>(v)] >> r & 1U) != 0) {
          nodes_.join(v, outer_node(first_span_[r] + s));
        }
      }
    }
  }

  bool is_at_border(std::size_t r, const Span& span) const {
    return span.first < 0 || span.last < 0 || span.row == 0 || span.row + 1 == sections_[r].rows;
  }

  /// Bone goes on beyond the blade's border, and holds both sides together there.
  void join_around_blade() {
    for (std::size_t s = 0; s < span_count_; ++s) {
      if (is_at_border(0, sections_[0].spans[s])) nodes_.join(outer_node(s), inner_node(s));
    }
  }

  /// A span that reaches an edge of the box: between the edge's coordinates `from` and `to`.
  struct Touch {
    int edge;
    double from, to;
    std::size_t span;
  };

  /// The sawn areas of neighbouring sides meet at the box's edges.
  void join_around_edges() {
    std::vector<Touch> touches;
    for (std::size_t r = 0; r < sections_.size(); ++r) {
      const int axis = static_cast<int>(r) / 2, side = static_cast<int>(r) % 2;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (std::size_t s = 0; s < sections_[r].spans.size(); ++s) {
        const Span& span = sections_[r].spans[s];
        const std::size_t id = first_span_[r] + s;
        const double half = 0.5 * sections_[r].row_height, at = sections_[r].row_v(span.row);
        // An edge: its own axis, then the sides of the next axis and the one after.
        if (span.first < 0) touches.push_back({4 * v + 2 * side, at - half, at + half, id});
        if (span.last < 0) touches.push_back({4 * v + 2 * side + 1, at - half, at + half, id});
        if (span.row == 0) touches.push_back({4 * u + side, span.begin, span.end, id});
        if (span.row + 1 == sections_[r].rows) {
          touches.push_back({4 * u + 2 + side, span.begin, span.end, id});
        }
      }
    }
    std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) {
      return std::pair(a.edge, a.from) < std::pair(b.edge, b.from);
    });
    for (std::size_t i = 0, group = 0; i < touches.size(); ++i) {
      if (touches[i].edge != touches[group].edge || touches[i].from > touches[group].to) group = i;
      join_spans(touches[group].span, touches[i].span);
      if (touches[i].to > touches[group].to) group = i;
    }
  }

  void flatten() {
    root_.resize(nodes_.size());
    for (std::size_t i = 0; i < root_.size(); ++i) root_[i] = nodes_.root(static_cast<int>(i));
  }

  double& volume_at(int node) {
    return volume_[static_cast<std::size_t>(root_[static_cast<std::size_t>(node)])];
  }

  /// By the divergence theorem about the cut's centre, so that a blade's areas add nothing.
  void measure() {
    volume_.assign(nodes_.size(), 0);
    const Eigen::Vector3d shift = (box_.centre - bone_.centre) / 3;
    for (std::size_t t = 0; t < crossed_.size(); ++t) {
      const auto row = static_cast<Eigen::Index>(t);
      const double whole = bone_.volume_part(row) - bone_.area_vector.row(row).dot(shift);
      if (crossed_[t]) {
        measure_divided(row, whole);
      } else {
        volume_at(bone_.mesh.triangles(row, 0)) += whole;
      }
    }
    for (std::size_t r = 0; r < sections_.size(); ++r) {
      const double height = plate_ == nullptr ? box_.half_extents(static_cast<int>(r) / 2) / 3 : 0;
      for (std::size_t s = 0; s < sections_[r].spans.size(); ++s) {
        const double area = area_of(r, s);
        // The saw takes half its kerf from either side.
        const double lost = plate_ == nullptr ? 0 : box_.half_extents.z() * area;
        volume_at(inner_node(first_span_[r] + s)) += height * area - lost;
        volume_at(outer_node(first_span_[r] + s)) -= height * area + lost;
      }
    }
  }

  double area_of(std::size_t r, std::size_t s) const {
    const Span& span = sections_[r].spans[s];
    return (span.end - span.begin) * sections_[r].row_height;
  }

  void measure_divided(Eigen::Index triangle, double whole) {
    Polygon inside;
    for (int k = 0; k < 3; ++k) inside.push_back(bone_.corner(triangle, k) - box_.centre);
    for (const Rectangle& side : rectangles_) {
      inside = clipped(inside, side.normal, side.normal.dot(side.centre - box_.centre));
    }
    int inner = -1, outer = -1;
    for (int k = 0; k < 3; ++k) {
      const int v = bone_.mesh.triangles(triangle, k);
      (is_inside(v) ? inner : outer) = v;
    }
    // A corner or an edge of the box pokes through the triangle: what is inside hangs on nothing
    // of the surface, and is too small to look for its span.
    const double part = inner < 0 || inside.size() < 3 ? 0 : part_of_volume(inside);
    if (inner >= 0) volume_at(inner) += part;
    if (outer >= 0) volume_at(outer) += whole - part;
  }

  void find_pieces() {
    piece_of_root_.assign(nodes_.size(), -1);
    for (int v = 0; v < vertex_count(); ++v) {
      const auto root = static_cast<std::size_t>(root_[static_cast<std::size_t>(v)]);
      if (piece_of_root_[root] >= 0 || volume_[root] < options_.minimum_volume) continue;
      piece_of_root_[root] = static_cast<int>(pieces_.size());
      pieces_.push_back(
          {bone_.component[static_cast<std::size_t>(v)], is_inside(v), volume_[root]});
    }
  }

  void find_patches() {
    std::vector<int> patch_of(span_count_, -1);
    for (std::size_t r = 0; r < sections_.size(); ++r) {
      const Rectangle& side = rectangles_[r];
      for (std::size_t s = 0; s < sections_[r].spans.size(); ++s) {
        const Span& span = sections_[r].spans[s];
        const std::size_t id = first_span_[r] + s;
        int& index = patch_of[static_cast<std::size_t>(areas_.root(static_cast<int>(id)))];
        if (index < 0) {
          index = static_cast<int>(patches_.size());
          patches_.emplace_back();
          patches_.back().rectangle = r;
        }
        Patch& patch = patches_[static_cast<std::size_t>(index)];
        const double v = sections_[r].row_v(span.row), area = area_of(r, s);
        patch.area += area;
        patch.centre += area * (side.centre + 0.5 * (span.begin + span.end) * side.u + v * side.v);
        patch.outer = outer_node(id);
        patch.inner = inner_node(id);
        if (patch.rectangle == r) {
          patch.extent.extend(Eigen::Vector2d(span.begin, v));
          patch.extent.extend(Eigen::Vector2d(span.end, v));
        }
        add_border(patch, r, span);
      }
    }
    for (Patch& patch : patches_) patch.centre /= std::max(patch.area, 1e-12);
  }

  void add_border(Patch& patch, std::size_t r, const Span& span) const {
    const auto add = [&patch](const Eigen::Vector3d& direction, double rows) {
      patch.border += rows * direction;
      patch.border_rows += rows;
    };
    const double length = (span.end - span.begin) / row_step;
    if (span.first < 0) add(-rectangles_[r].u, 1);
    if (span.last < 0) add(rectangles_[r].u, 1);
    if (span.row == 0) add(-rectangles_[r].v, length);
    if (span.row + 1 == sections_[r].rows) add(rectangles_[r].v, length);
  }

  void choose_segment() {
    if (plate_ != nullptr) {
      segment_ = piece_at(plate_->seed);
      return;
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (!pieces_[p].inside) continue;
      if (segment_ < 0 || pieces_[p].volume > piece(segment_).volume) {
        segment_ = static_cast<int>(p);
      }
    }
  }

  /// The piece that holds a place, or the nearest to it; −1: a chip.
  int piece_at(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d& normal = rectangles_[0].normal;
    const double height = (place - box_.centre).dot(normal);
    // Away from the blade no sawn area is in the way.
    const Eigen::Vector3d away = height >= 0 ? normal : -normal;
    int triangle = -1;
    Eigen::Vector3d point = place;
    const auto hit = bone_.tree.first_hit(place, away, 1e4);
    if (hit && bone_.area_vector.row(hit->triangle).dot(away) > 0) {
      triangle = hit->triangle;
      point += hit->distance * away;
    } else if (const auto nearest = bone_.tree.nearest(place, 1e4)) {
      triangle = nearest->triangle;
      point = nearest->point;
    }
    if (triangle < 0) return -1;
    const bool behind = (point - box_.centre).dot(normal) < 0;
    int vertex = bone_.mesh.triangles(triangle, 0);
    for (int k = 0; crossed_[static_cast<std::size_t>(triangle)] && k < 3; ++k) {
      const int v = bone_.mesh.triangles(triangle, k);
      if (is_inside(v) == behind) vertex = v;
    }
    return piece_of_node(vertex);
  }

  /// Whether a patch is where the segment comes off.
  bool separates(const Patch& patch) const {
    const int outer = piece_of_node(patch.outer), inner = piece_of_node(patch.inner);
    return segment_ >= 0 && (outer == segment_) != (inner == segment_);
  }

  /// Whether there is a segment; of a blade: one parted from a whole piece of the same bone.
  bool comes_off() {
    if (segment_ < 0 || plate_ == nullptr) return segment_ >= 0;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (static_cast<int>(p) != segment_ && pieces_[p].component == piece(segment_).component) {
        return true;
      }
    }
    return false;
  }

  /// A sawn area that is larger than a graze and has no part in taking the segment off.
  bool is_forbidden(const Patch& patch) {
    if (patch.area < least_patch || separates(patch)) return false;
    if (plate_ != nullptr) return true;
    // In a box, chips of other bone are no harm: nothing of them is lost.
    const int inner = piece_of_node(patch.inner);
    return inner >= 0 && inner != segment_;
  }

  void give_parts() {
    std::vector<int> body(bone_.component.size(),
                          -1);  // the largest piece that stays, by component
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (static_cast<int>(p) == segment_ || (plate_ == nullptr && pieces_[p].inside)) continue;
      int& largest = body[static_cast<std::size_t>(pieces_[p].component)];
      if (largest < 0 || pieces_[p].volume > piece(largest).volume) largest = static_cast<int>(p);
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const bool in_box = plate_ == nullptr && pieces_[p].inside;
      // Halves of a jaw whose middle comes off are both what stays.
      const int largest = body[static_cast<std::size_t>(pieces_[p].component)];
      const bool stays = largest < 0 || pieces_[p].volume > 0.5 * piece(largest).volume;
      if (!in_box && !stays) pieces_[p].part = CutPart::loose;
    }
    if (comes_off()) piece(segment_).part = CutPart::segment;
    for (const Patch& patch : patches_) {
      if (plate_ == nullptr && is_forbidden(patch)) {
        piece(piece_of_node(patch.inner)).part = CutPart::forbidden;
      }
    }
  }

  std::optional<Error> refusal() {
    const std::string what = plate_ == nullptr ? "the box" : "the blade";
    if (patches_.empty() && (plate_ != nullptr || segment_ < 0)) {
      return Error(ErrorKind::anatomy, "cut", what + " does not touch the bone",
                   "move it onto the bone");
    }
    if (segment_ < 0) {
      return Error(ErrorKind::anatomy, "cut",
                   plate_ == nullptr ? "the box holds too little bone to be moved"
                                     : "the piece to take is too small to be moved",
                   plate_ == nullptr ? "enlarge the box or move it so that the segment lies in it"
                                     : "move the blade deeper into the bone");
    }
    if (!comes_off()) return stops_short();
    return other_bone(what);
  }

  /// Nothing comes apart: where the blade ends within the bone.
  std::optional<Error> stops_short() const {
    const Patch* largest = &patches_.front();
    for (const Patch& patch : patches_) {
      if (patch.border_rows > largest->border_rows) largest = &patch;
    }
    if (largest->border_rows == 0) {
      return Error(ErrorKind::anatomy, "cut", "the blade passes through, but nothing comes apart",
                   "move or turn the blade so that it parts the bone in two");
    }
    // Ends on opposite sides ask for a larger blade, not for another place.
    const bool one_sided = largest->border.norm() > 0.3 * largest->border_rows;
    return Error(ErrorKind::anatomy, "cut",
                 "the blade does not pass through the whole bone: it ends within it, and nothing "
                 "comes apart",
                 "enlarge the blade" +
                     (one_sided ? " or move it " + towards(largest->border) : std::string()));
  }

  static std::string towards(const Eigen::Vector3d& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    constexpr std::array<std::array<const char*, 2>, 3> words = {
        {{"to the patient's right", "to the patient's left"}, {"forward", "back"}, {"down", "up"}}};
    return words[static_cast<std::size_t>(axis)][direction(axis) > 0 ? 1 : 0];
  }

  std::optional<Error> other_bone(const std::string& what) {
    double area = 0, useful = 0, volume = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), home = box_.centre;
    Eigen::Vector3d useful_centre = Eigen::Vector3d::Zero();
    for (const Patch& patch : patches_) {
      if (is_forbidden(patch)) {
        area += patch.area;
        centre += patch.area * patch.centre;
      } else if (separates(patch)) {
        useful += patch.area;
        useful_centre += patch.area * patch.centre;
      }
    }
    if (area == 0) return std::nullopt;
    if (useful > 0) home = useful_centre / useful;
    for (const Piece& p : pieces_) {
      if (p.part == CutPart::forbidden) volume += p.volume;
    }
    const std::string amount =
        plate_ != nullptr ? rounded(area / 100, "cm² ") : rounded(volume / 1000, "cm³ ");
    return Error(ErrorKind::anatomy, "cut",
                 what + " also cuts bone that does not belong to the segment: " + amount +
                     place_word(centre / area - home) + " it",
                 "make " + what + " smaller on that side, or move or turn it");
  }

  void colour(std::vector<CutPart>& part) {
    part.resize(crossed_.size());
    for (std::size_t t = 0; t < part.size(); ++t) {
      const int* corners = &bone_.mesh.triangles(static_cast<Eigen::Index>(t), 0);
      int vertex = corners[0];
      // Of a divided triangle two corners are on one side.
      if (crossed_[t] && is_inside(corners[0]) != is_inside(corners[1])) vertex = corners[2];
      const int own = piece_of_node(vertex);
      part[t] = own < 0 ? CutPart::kept : piece(own).part;
    }
    if (plate_ == nullptr) return;
    for (const Patch& patch : patches_) {
      if (is_forbidden(patch)) mark_beside(patch, part);
    }
  }

  /// The bone's surface along a cut that should not be.
  void mark_beside(const Patch& patch, std::vector<CutPart>& part) const {
    const Rectangle& blade = rectangles_[patch.rectangle];
    Eigen::AlignedBox2d extent = patch.extent;
    extent.extend((patch.extent.min().array() - marked_reach).matrix().eval());
    extent.extend((patch.extent.max().array() + marked_reach).matrix().eval());
    for (std::size_t t = 0; t < part.size(); ++t) {
      const Eigen::Vector3d x = bone_.corner(static_cast<Eigen::Index>(t), 0) - blade.centre;
      if (std::abs(x.dot(blade.normal)) > marked_reach) continue;
      if (extent.contains(Eigen::Vector2d(x.dot(blade.u), x.dot(blade.v)))) {
        part[t] = CutPart::forbidden;
      }
    }
  }

  const PreviewedBone& bone_;
  BoxCut box_;
  const PlateCut* plate_;  // null: a box
  CutOptions options_;
  std::vector<Rectangle> rectangles_;
  std::vector<std::uint8_t> codes_;
  std::vector<char> crossed_;  // of the triangles: the cut divides it
  std::vector<RectangleSection> sections_;
  std::vector<std::size_t> first_span_;  // of each section, among all
  std::size_t span_count_ = 0;
  Sets nodes_{0};
  Sets areas_{0};  // of the spans: those of one patch
  std::vector<int> root_;
  std::vector<double> volume_;  // by root
  std::vector<int> piece_of_root_;
  std::vector<Piece> pieces_;
  std::vector<Patch> patches_;
  int segment_ = -1;
};

}  // namespace

CutPreviewer::CutPreviewer(TriangleMesh bone)
    : bone_(std::make_unique<const PreviewedBone>(std::move(bone))) {}

CutPreviewer::~CutPreviewer() = default;

const TriangleMesh& CutPreviewer::bone() const {
  return bone_->mesh;
}

CutPreview CutPreviewer::preview(const BoundedCut& cut, const CutOptions& options) const {
  return Cutting(*bone_, cut, options).result();
}

}  // namespace gnathion

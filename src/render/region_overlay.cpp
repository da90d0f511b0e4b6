#include "render/region_overlay.h"

#include <algorithm>
#include <initializer_list>
#include <map>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt64Array.h>

#include "geometry/triangle_mesh.h"
#include "render/pixel_ratio.h"
#include "render/vtk_surface.h"

namespace gnathion {
namespace {

// mm off the skin, so that the layers do not fight for the same depth. Lines and points lie above
// the green, which would tint them.
constexpr double kSurfaceLift = 0.25;
constexpr double kMarkLift = 0.6;

constexpr double kMarksApart = 4;  // mm

const Eigen::Vector3d rim_colour{0.02, 0.25, 0.10};
// Of the brush: a light line on a dark one stands out from any skin and any mark.
const Eigen::Vector3d halo_colour{0.05, 0.05, 0.05};
const Eigen::Vector3d paint_colour{1, 1, 1};
const Eigen::Vector3d erase_colour{1.0, 0.35, 0.30};

/// A list of points with so many corners a cell.
vtkSmartPointer<vtkCellArray> cells(const std::vector<int>& corners, int corners_a_cell) {
  vtkNew<vtkTypeInt64Array> list;
  list->SetNumberOfValues(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), list->GetPointer(0));
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(corners_a_cell, list);
  return array;
}

/// Cells over points that others use, too; unlit, so that no normals are needed.
struct Layer {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  void set_up(vtkPoints* points, const Eigen::Vector3d& colour) {
    data->SetPoints(points);
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->VisibilityOff();
    actor->GetProperty()->LightingOff();
    set_colour(colour);
  }
  void set_colour(const Eigen::Vector3d& colour) {
    actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
  }
  void set_triangles(const Triangles& triangles) {
    data->SetPolys(cells_of(triangles));
    actor->SetVisibility(triangles.rows() > 0);
  }
  void set_lines(const std::vector<int>& ends) {
    data->SetLines(cells(ends, 2));
    actor->SetVisibility(!ends.empty());
  }
  void set_vertices(const std::vector<int>& vertices) {
    data->SetVerts(cells(vertices, 1));
    actor->SetVisibility(!vertices.empty());
  }
  void moved() { data->Modified(); }
};

void lift(const Points& points, const Points& normals, double by, vtkPoints* target) {
  auto* array = vtkFloatArray::SafeDownCast(target->GetData());
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(points.rows());
  Eigen::Map<Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>> rows(array->GetPointer(0),
                                                                            points.rows(), 3);
  rows = (points + by * normals).cast<float>();
  array->Modified();
  target->Modified();
}

}  // namespace

Eigen::Vector3d colour_of(SupportMark mark) {
  switch (mark) {
    case SupportMark::attached:
      return {0.84, 0.37, 0.0};
    case SupportMark::sliding:
      return {0.34, 0.71, 0.91};
    case SupportMark::fixed:
      return {0.05, 0.05, 0.05};
    case SupportMark::free:
      return {1, 1, 1};
  }
  return {1, 1, 1};
}

int size_of(SupportMark mark) {
  switch (mark) {
    case SupportMark::attached:
    case SupportMark::sliding:
      return 6;
    case SupportMark::fixed:
      return 5;
    case SupportMark::free:
      return 3;
  }
  return 3;
}

namespace {

/// Those that are not within `apart` mm of one before, which would cover it. A grid of cells of
/// that size finds the neighbours.
std::vector<SupportPoint> spread_out(const std::vector<SupportPoint>& points, const Points& places,
                                     double apart) {
  std::map<std::array<int, 3>, std::vector<Eigen::RowVector3d>> grid;
  std::vector<SupportPoint> kept;
  for (const SupportPoint& point : points) {
    const Eigen::RowVector3d x = places.row(point.vertex);
    const Eigen::RowVector3i cell = (x / apart).array().floor().cast<int>();
    bool free = true;
    for (int near = 0; near < 27 && free; ++near) {
      const auto found =
          grid.find({cell[0] + near % 3 - 1, cell[1] + near / 3 % 3 - 1, cell[2] + near / 9 - 1});
      if (found == grid.end()) continue;
      for (const Eigen::RowVector3d& y : found->second) free = free && (x - y).norm() >= apart;
    }
    if (!free) continue;
    grid[{cell[0], cell[1], cell[2]}].push_back(x);
    kept.push_back(point);
  }
  return kept;
}

}  // namespace

struct RegionOverlay::Impl {
  vtkNew<vtkPoints> surface_points;
  vtkNew<vtkPoints> mark_points;
  vtkNew<vtkPoints> cursor_points;
  vtkNew<vtkPoints> halo_points;
  Layer region, rim, sliding, faults, halo, cursor;
  std::array<Layer, support_marks.size()> supports;
  TriangleMesh face;
  vtkRenderer* renderer = nullptr;

  Impl() {
    region.set_up(surface_points, region_colour);
    sliding.set_up(surface_points, sliding_area_colour);
    for (Layer* layer : {&region, &sliding}) {
      layer->actor->GetProperty()->SetOpacity(0.42);
      layer->actor->GetProperty()->BackfaceCullingOn();
      layer->actor->ForceTranslucentOn();
    }
    rim.set_up(mark_points, rim_colour);
    faults.set_up(mark_points, fault_colour);
    for (std::size_t i = 0; i < supports.size(); ++i) {
      supports[i].set_up(mark_points, colour_of(support_marks[i]));
    }
    cursor.set_up(cursor_points, paint_colour);
    halo.set_up(halo_points, halo_colour);
    set_size(1);
  }

  /// Of lines and dots.
  void set_size(double pixel_ratio) {
    const auto pixels = [pixel_ratio](double logical) {
      return static_cast<float>(pixel_ratio * logical);
    };
    rim.actor->GetProperty()->SetLineWidth(pixels(3));
    cursor.actor->GetProperty()->SetLineWidth(pixels(2));
    halo.actor->GetProperty()->SetLineWidth(pixels(5));
    faults.actor->GetProperty()->SetPointSize(pixels(6));
    for (std::size_t i = 0; i < supports.size(); ++i) {
      supports[i].actor->GetProperty()->SetPointSize(pixels(size_of(support_marks[i])));
    }
  }

  std::vector<Layer*> layers() {
    std::vector<Layer*> all{&region, &sliding, &rim, &faults, &halo, &cursor};
    for (Layer& layer : supports) all.push_back(&layer);
    return all;
  }

  void place(const Points& points) {
    face.vertices = points;
    const Points normals = vertex_normals(face);
    lift(points, normals, kSurfaceLift, surface_points);
    lift(points, normals, kMarkLift, mark_points);
    for (Layer* layer : layers()) layer->moved();
  }
};

RegionOverlay::RegionOverlay() : impl_(std::make_unique<Impl>()) {}

RegionOverlay::~RegionOverlay() {
  detach();
}

void RegionOverlay::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  impl_->set_size(pixel_ratio(renderer));
  for (Layer* layer : impl_->layers()) renderer->AddActor(layer->actor);
}

void RegionOverlay::detach() {
  if (!impl_->renderer) return;
  for (Layer* layer : impl_->layers()) impl_->renderer->RemoveActor(layer->actor);
  impl_->renderer = nullptr;
}

bool RegionOverlay::is_attached() const {
  return impl_->renderer != nullptr;
}

void RegionOverlay::set_face(const TriangleMesh& face) {
  set_region({}, {});
  set_sliding_area({});
  set_supports({});
  set_faults({});
  set_cursor({}, false);
  impl_->face = face;
  impl_->place(face.vertices);
}

void RegionOverlay::set_points(const Points& points) {
  impl_->place(points);
}

void RegionOverlay::set_region(const Triangles& triangles,
                               const std::vector<std::array<int, 2>>& rim) {
  impl_->region.set_triangles(triangles);
  std::vector<int> ends;
  ends.reserve(2 * rim.size());
  for (const auto& [a, b] : rim) ends.insert(ends.end(), {a, b});
  impl_->rim.set_lines(ends);
}

void RegionOverlay::set_sliding_area(const Triangles& triangles) {
  impl_->sliding.set_triangles(triangles);
}

void RegionOverlay::set_supports(const std::vector<SupportPoint>& supports) {
  const std::vector<SupportPoint> shown = spread_out(supports, impl_->face.vertices, kMarksApart);
  for (std::size_t i = 0; i < support_marks.size(); ++i) {
    std::vector<int> vertices;
    for (const SupportPoint& point : shown) {
      if (point.mark == support_marks[i]) vertices.push_back(point.vertex);
    }
    impl_->supports[i].set_vertices(vertices);
  }
}

void RegionOverlay::set_faults(const std::vector<int>& vertices) {
  impl_->faults.set_vertices(vertices);
}

void RegionOverlay::set_cursor(const Points& segment_ends, bool erases) {
  Impl& self = *impl_;
  const auto count = static_cast<int>(segment_ends.rows());
  self.halo_points->SetNumberOfPoints(count);
  self.cursor_points->SetNumberOfPoints(count);
  Eigen::RowVector3d eye = Eigen::RowVector3d::Zero();
  if (self.renderer != nullptr) self.renderer->GetActiveCamera()->GetPosition(eye.data());
  std::vector<int> ends;
  for (int i = 0; i < count; ++i) {
    const Eigen::RowVector3d x = segment_ends.row(i);
    const Eigen::RowVector3d nearer = x + kSurfaceLift * (eye - x).normalized();
    self.halo_points->SetPoint(i, x.data());
    self.cursor_points->SetPoint(i, nearer.data());
    ends.push_back(i);
  }
  self.halo_points->Modified();
  self.cursor_points->Modified();
  self.halo.set_lines(ends);
  self.cursor.set_lines(ends);
  self.cursor.set_colour(erases ? erase_colour : paint_colour);
}

}  // namespace gnathion

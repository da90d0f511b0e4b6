#include "render/skin_line.h"

#include <array>
#include <vector>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace gnathion {
namespace {

constexpr std::array<double, 3> kDark{0.05, 0.05, 0.05}, kLight{1.0, 0.85, 0.2};

vtkSmartPointer<vtkPoints> vtk_points(const Points& places) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    points->InsertNextPoint(places(i, 0), places(i, 1), places(i, 2));
  }
  return points;
}

/// One unlit stroke or set of dots.
struct Stroke {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  Stroke(const std::array<double, 3>& colour, float width, float dot, double nearer) {
    mapper->SetInputData(data);
    // The light stroke lies on the dark one: it is drawn as if it were a little nearer.
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, nearer);
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter(nearer);
    actor->SetMapper(mapper);
    actor->PickableOff();
    vtkProperty* property = actor->GetProperty();
    property->LightingOff();
    property->SetColor(colour[0], colour[1], colour[2]);
    property->SetLineWidth(width);
    property->SetPointSize(dot);
    property->RenderPointsAsSpheresOn();
  }
};

}  // namespace

struct SkinLine::Impl {
  Stroke dark{kDark, 5, 11, -4}, light{kLight, 2.5F, 7, -8};
  vtkRenderer* renderer = nullptr;
};

SkinLine::SkinLine() : impl_(std::make_unique<Impl>()) {}

SkinLine::~SkinLine() {
  detach();
}

void SkinLine::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  for (Stroke* stroke : {&impl_->dark, &impl_->light}) renderer->AddActor(stroke->actor);
}

void SkinLine::detach() {
  if (impl_->renderer == nullptr) return;
  for (Stroke* stroke : {&impl_->dark, &impl_->light}) impl_->renderer->RemoveActor(stroke->actor);
  impl_->renderer = nullptr;
}

void SkinLine::set_line(const Points& line, const Points& knobs) {
  Points all(line.rows() + knobs.rows(), 3);
  all.topRows(line.rows()) = line;
  all.bottomRows(knobs.rows()) = knobs;
  const auto points = vtk_points(all);
  vtkNew<vtkCellArray> lines, dots;
  if (line.rows() > 1) {
    lines->InsertNextCell(static_cast<int>(line.rows()));
    for (Eigen::Index i = 0; i < line.rows(); ++i) lines->InsertCellPoint(i);
  }
  for (Eigen::Index i = line.rows(); i < all.rows(); ++i) {
    dots->InsertNextCell(1);
    dots->InsertCellPoint(i);
  }
  for (Stroke* stroke : {&impl_->dark, &impl_->light}) {
    stroke->data->SetPoints(points);
    stroke->data->SetLines(lines);
    stroke->data->SetVerts(dots);
    stroke->data->Modified();
    stroke->actor->SetVisibility(all.rows() > 0);
  }
}

}  // namespace gnathion

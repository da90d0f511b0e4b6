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

#include "render/pixel_ratio.h"

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

  float width, dot;  // logical pixels
  double lift;       // mm off the skin

  Stroke(const std::array<double, 3>& colour, float line_width, float dot_size, double lift_mm)
      : width(line_width), dot(dot_size), lift(lift_mm) {
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->VisibilityOff();
    vtkProperty* property = actor->GetProperty();
    property->LightingOff();
    property->SetColor(colour[0], colour[1], colour[2]);
    set_size(1);
  }

  void set_size(double pixel_ratio) {
    actor->GetProperty()->SetLineWidth(static_cast<float>(pixel_ratio) * width);
    actor->GetProperty()->SetPointSize(static_cast<float>(pixel_ratio) * dot);
  }
};

}  // namespace

struct SkinLine::Impl {
  Stroke dark{kDark, 5, 9, 0.7}, light{kLight, 2.5F, 5, 1.0};  // the light one over the dark one
  vtkRenderer* renderer = nullptr;
};

SkinLine::SkinLine() : impl_(std::make_unique<Impl>()) {}

SkinLine::~SkinLine() {
  detach();
}

void SkinLine::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  for (Stroke* stroke : {&impl_->dark, &impl_->light}) {
    stroke->set_size(pixel_ratio(renderer));
    renderer->AddActor(stroke->actor);
  }
}

void SkinLine::detach() {
  if (impl_->renderer == nullptr) return;
  for (Stroke* stroke : {&impl_->dark, &impl_->light}) impl_->renderer->RemoveActor(stroke->actor);
  impl_->renderer = nullptr;
}

void SkinLine::set_line(const Places& line, const Places& knobs) {
  const Eigen::Index count = line.on.rows() + knobs.on.rows();
  vtkNew<vtkCellArray> lines, dots;
  if (line.on.rows() > 1) {
    lines->InsertNextCell(static_cast<int>(line.on.rows()));
    for (Eigen::Index i = 0; i < line.on.rows(); ++i) lines->InsertCellPoint(i);
  }
  for (Eigen::Index i = line.on.rows(); i < count; ++i) {
    dots->InsertNextCell(1);
    dots->InsertCellPoint(i);
  }
  for (Stroke* stroke : {&impl_->dark, &impl_->light}) {
    Points all(count, 3);
    all.topRows(line.on.rows()) = line.on + stroke->lift * line.outward;
    all.bottomRows(knobs.on.rows()) = knobs.on + stroke->lift * knobs.outward;
    stroke->data->SetPoints(vtk_points(all));
    stroke->data->SetLines(lines);
    stroke->data->SetVerts(dots);
    stroke->data->Modified();
    stroke->actor->SetVisibility(count > 0);
  }
}

}  // namespace gnathion

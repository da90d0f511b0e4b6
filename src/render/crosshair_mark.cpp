#include "render/crosshair_mark.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>

namespace gnathion {
namespace {

constexpr double arm_mm = 8;

}  // namespace

struct CrosshairMark::Impl {
  vtkNew<vtkPoints> points;
  vtkNew<vtkActor2D> lines;
};

CrosshairMark::CrosshairMark() : impl_(std::make_unique<Impl>()) {
  vtkNew<vtkCellArray> lines;
  for (const vtkIdType first : {0, 2, 4}) {
    const vtkIdType line[] = {first, first + 1};
    lines->InsertNextCell(2, line);
  }
  impl_->points->SetNumberOfPoints(6);
  vtkNew<vtkPolyData> data;
  data->SetPoints(impl_->points);
  data->SetLines(lines);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkCoordinate> world;
  world->SetCoordinateSystemToWorld();
  mapper->SetTransformCoordinate(world);
  impl_->lines->SetMapper(mapper);
  impl_->lines->GetProperty()->SetColor(0.05, 0.45, 0.15);
  add(impl_->lines);
  set_place(Eigen::Vector3d::Zero());
}

CrosshairMark::~CrosshairMark() {
  detach();
}

void CrosshairMark::set_place(const Eigen::Vector3d& lps) {
  for (int end = 0; end < 6; ++end) {
    const Eigen::Vector3d p =
        lps + (end % 2 == 0 ? -arm_mm : arm_mm) * Eigen::Vector3d::Unit(end / 2);
    impl_->points->SetPoint(end, p.data());
  }
  impl_->points->Modified();
}

void CrosshairMark::prepare(vtkRenderer& renderer) {
  impl_->lines->GetProperty()->SetLineWidth(static_cast<float>(2 * pixel_ratio(renderer)));
}

}  // namespace gnathion

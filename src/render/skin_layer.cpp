#include "render/skin_layer.h"

#include <vtkActor.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "geometry/triangle_mesh.h"
#include "render/split_surface.h"
#include "render/vtk_surface.h"

namespace gnathion {
namespace {

/// VTK's copy of n×3 numbers.
vtkSmartPointer<vtkDoubleArray> copy_of(const Points& rows) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(rows.rows());
  std::copy(rows.data(), rows.data() + rows.size(), array->GetPointer(0));
  return array;
}

}  // namespace

struct SkinLayer::Impl {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkRenderer* renderer = nullptr;

  Impl() {
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->VisibilityOff();
    vtkProperty* look = actor->GetProperty();
    look->SetColor(0.70, 0.76, 0.82);
    look->SetAmbient(0.10);
    look->SetDiffuse(0.88);
    look->SetSpecular(0.05);
    look->SetInterpolationToPhong();
  }
};

SkinLayer::SkinLayer() : impl_(std::make_unique<Impl>()) {}

SkinLayer::~SkinLayer() {
  detach();
}

void SkinLayer::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  renderer->AddActor(impl_->actor);
}

void SkinLayer::detach() {
  if (impl_->renderer == nullptr) return;
  impl_->renderer->RemoveActor(impl_->actor);
  impl_->renderer = nullptr;
}

void SkinLayer::set_skin(const TriangleMesh& skin) {
  check_surface(skin, "skin of the CT");
  vtkNew<vtkPoints> points;
  points->SetData(copy_of(skin.vertices));
  impl_->data->SetPoints(points);
  impl_->data->GetPointData()->SetNormals(copy_of(vertex_normals(skin)));
  impl_->data->SetPolys(cells_of(skin.triangles));
}

void SkinLayer::set_opacity(double opacity) {
  impl_->actor->SetVisibility(opacity > 0);
  impl_->actor->GetProperty()->SetOpacity(opacity);
  impl_->actor->GetProperty()->SetBackfaceCulling(opacity < 1);
}

}  // namespace gnathion

#include "render/orientation_cube.h"

#include <Eigen/Geometry>
#include <algorithm>

#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

constexpr const char* side_letters = "LRPASI";  // +x −x +y −y +z −z
const Eigen::Vector3d paper{0.97, 0.975, 0.98};
const Eigen::Vector3d edge_ink{0.35, 0.40, 0.46};
const Eigen::Vector3d letter_ink{0.10, 0.20, 0.36};
constexpr double half_side = 26;  // logical pixels
constexpr double margin = 6;
constexpr double room_for_letters = 26;  // the scene's, in the corner below
/// A face seen more from the side than this has no letter: it would lie over its neighbour's.
constexpr double least_facing_for_a_letter = 0.3;

}  // namespace

std::vector<CubeFace> visible_cube_faces(const Eigen::Vector3d& right, const Eigen::Vector3d& up,
                                         const Eigen::Vector3d& away) {
  std::vector<CubeFace> faces;
  const auto seen = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector2d(right.dot(p), up.dot(p));
  };
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const Eigen::Vector3d normal = (side % 2 == 0 ? 1 : -1) * Eigen::Vector3d::Unit(axis);
    const double facing = -away.dot(normal);
    if (facing < 1e-3) continue;
    const Eigen::Vector3d a = Eigen::Vector3d::Unit((axis + 1) % 3);
    const Eigen::Vector3d b = Eigen::Vector3d::Unit((axis + 2) % 3);
    faces.push_back(
        {side_letters[side],
         {seen(normal - a - b), seen(normal + a - b), seen(normal + a + b), seen(normal - a + b)},
         seen(normal),
         facing});
  }
  std::sort(faces.begin(), faces.end(),
            [](const CubeFace& p, const CubeFace& q) { return p.facing < q.facing; });
  return faces;
}

struct OrientationCube::Impl {
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> quads;
  vtkNew<vtkPolyData> edges;
  vtkNew<vtkActor2D> quads_actor;
  vtkNew<vtkActor2D> edges_actor;
  std::array<vtkNew<vtkTextActor>, 3> letters;  // no more than three faces are seen

  void set_faces(const std::vector<CubeFace>& faces, const Eigen::Vector2d& centre, double scale) {
    vtkNew<vtkCellArray> polygons;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    points->Reset();
    for (const CubeFace& face : faces) {
      vtkIdType ids[5];
      for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector2d p = centre + scale * face.corners[k];
        ids[k] = points->InsertNextPoint(p.x(), p.y(), 0);
      }
      ids[4] = ids[0];
      polygons->InsertNextCell(4, ids);
      lines->InsertNextCell(5, ids);
      const Eigen::Vector3d shade = 255 * (0.72 + 0.28 * face.facing) * paper;
      colours->InsertNextTuple3(shade.x(), shade.y(), shade.z());
    }
    points->Modified();
    quads->SetPolys(polygons);
    quads->GetCellData()->SetScalars(colours);
    edges->SetLines(lines);
  }

  void set_letters(const std::vector<CubeFace>& faces, const Eigen::Vector2d& centre, double scale,
                   int font) {
    for (std::size_t k = 0; k < letters.size(); ++k) {
      vtkTextActor* letter = letters[k];
      const bool shown = k < faces.size() && faces[k].facing > least_facing_for_a_letter;
      letter->SetInput(shown ? std::string(1, faces[k].letter).c_str() : "");
      if (!shown) continue;
      const Eigen::Vector2d p = centre + scale * faces[k].centre;
      letter->SetPosition(p.x(), p.y());
      letter->GetTextProperty()->SetFontSize(font);
    }
  }
};

OrientationCube::OrientationCube() : impl_(std::make_unique<Impl>()) {
  impl_->quads->SetPoints(impl_->points);
  impl_->edges->SetPoints(impl_->points);
  const auto show = [this](vtkPolyData* data, vtkActor2D* actor) {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    add(actor);
  };
  show(impl_->quads, impl_->quads_actor);
  show(impl_->edges, impl_->edges_actor);
  impl_->edges_actor->GetProperty()->SetColor(edge_ink.x(), edge_ink.y(), edge_ink.z());
  for (vtkTextActor* letter : impl_->letters) {
    letter->SetInput("");
    letter->GetTextProperty()->SetColor(letter_ink.x(), letter_ink.y(), letter_ink.z());
    letter->GetTextProperty()->BoldOn();
    letter->GetTextProperty()->SetJustificationToCentered();
    letter->GetTextProperty()->SetVerticalJustificationToCentered();
    add(letter);
  }
}

OrientationCube::~OrientationCube() {
  detach();
}

void OrientationCube::prepare(vtkRenderer& renderer) {
  vtkCamera* camera = renderer.GetActiveCamera();
  const Eigen::Vector3d away(camera->GetDirectionOfProjection());
  const Eigen::Vector3d right = away.cross(Eigen::Vector3d(camera->GetViewUp())).normalized();
  const std::vector<CubeFace> faces = visible_cube_faces(right, right.cross(away), away);
  const double ratio = pixel_ratio(&renderer);
  const Eigen::Vector2d size(renderer.GetSize()[0], renderer.GetSize()[1]);
  // The least circle that holds the cube is √3 times as wide as its side.
  const double scale = std::min(ratio * half_side, size.minCoeff() / 14);
  const double radius = 1.74 * scale + ratio * margin;
  const Eigen::Vector2d centre(radius, radius + ratio * room_for_letters);
  impl_->set_faces(faces, centre, scale);
  impl_->edges_actor->GetProperty()->SetLineWidth(static_cast<float>(ratio));
  impl_->set_letters(faces, centre, scale, static_cast<int>(0.9 * scale / ratio));
}

}  // namespace gnathion

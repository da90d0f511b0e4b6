#include "render/face_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLightKit.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTexture.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "render/colour_map.h"
#include "render/pixel_ratio.h"
#include "render/ready_surface.h"
#include "render/scene_renderer.h"
#include "render/texture_image.h"
#include "render/wrapped_words.h"

namespace gnathion {
namespace {

const Eigen::Vector3d background_low{0.71, 0.75, 0.80};
const Eigen::Vector3d background_high{0.93, 0.945, 0.96};
const Eigen::Vector3d ink{0.13, 0.17, 0.22};
constexpr double pi = 3.14159265358979323846;
constexpr double head_height = 255;  // mm, from the vertex to below an adult's chin
constexpr double view_angle = 18;    // degrees: a portrait lens, little perspective distortion

vtkSmartPointer<vtkFloatArray> copy_of(vtkFloatArray* array) {
  auto copy = vtkSmartPointer<vtkFloatArray>::New();
  copy->DeepCopy(array);
  return copy;
}

/// A surface in a scene.
struct ShownSurface {
  const SurfaceArrays& arrays;
  vtkSmartPointer<vtkFloatArray> points, normals;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  /// from: outlives this. moves: with move_to(); otherwise nothing is copied.
  ShownSurface(const SurfaceArrays& from, bool moves)
      : arrays(from),
        points(moves ? copy_of(from.points) : from.points),
        normals(moves ? copy_of(from.normals) : from.normals) {
    vtkNew<vtkPoints> vtk_points;
    vtk_points->SetData(points);
    data->SetPoints(vtk_points);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetTCoords(from.uv);
    data->SetPolys(from.cells);
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToPhong();
  }

  void move_to(const Points& positions, const Points& directions) {
    copy_rows(positions, arrays.vertex, points);
    copy_rows(directions, arrays.vertex, normals);
    data->GetPoints()->Modified();
    data->Modified();
  }
};

/// A part of the face, whole or coarse.
struct ShownPart : ShownSurface {
  vtkSmartPointer<vtkTexture> texture;
  Eigen::Vector3d plain_colour;

  explicit ShownPart(const ReadyFace::Part& part)
      : ShownSurface(part.arrays, true), plain_colour(part.plain_colour) {}
};

void shine(vtkProperty* property, double ambient, double diffuse, double specular) {
  property->SetAmbient(ambient);
  property->SetDiffuse(diffuse);
  property->SetSpecular(specular);
  property->SetSpecularPower(25);
}

void set_colour(vtkProperty* property, const Eigen::Vector3d& rgb) {
  property->SetColor(rgb.x(), rgb.y(), rgb.z());
  property->SetSpecularColor(1, 1, 1);
}

using ShownParts = std::vector<std::unique_ptr<ShownPart>>;

ShownParts shown(const std::vector<ReadyFace::Part>& parts,
                 std::map<vtkImageData*, vtkSmartPointer<vtkTexture>>& textures) {
  ShownParts shown;
  for (const ReadyFace::Part& part : parts) {
    shown.push_back(std::make_unique<ShownPart>(part));
    if (!part.texture) continue;
    vtkSmartPointer<vtkTexture>& texture = textures[part.texture];
    if (!texture) texture = texture_of(part.texture);
    shown.back()->texture = texture;
  }
  return shown;
}

/// Right, up and away-from-viewer of a picture, as rows, in LPS.
Eigen::Matrix3d picture_axes(CameraPreset view) {
  if (view == CameraPreset::top) {
    return Eigen::Vector3d(1, 1, -1).asDiagonal();
  }
  double turn = 0;  // about +z, from the front towards the patient's left
  switch (view) {
    case CameraPreset::front:
      turn = 0;
      break;
    case CameraPreset::left:
      turn = pi / 2;
      break;
    case CameraPreset::right:
      turn = -pi / 2;
      break;
    case CameraPreset::three_quarter:
      turn = 40 * pi / 180;
      break;
    case CameraPreset::top:
      break;
  }
  Eigen::Matrix3d axes;
  axes.row(0) << std::cos(turn), std::sin(turn), 0;
  axes.row(1) << 0, 0, 1;
  axes.row(2) << -std::sin(turn), std::cos(turn), 0;
  return axes;
}

/// The box, in picture axes (right, up, away), of what a preset frames: everything, but of a taller
/// subject only the head.
std::pair<Eigen::RowVector3d, Eigen::RowVector3d> framed_box(const std::vector<Points>& all) {
  double top = all.front()(0, 1);
  for (const Points& points : all) top = std::max(top, points.col(1).maxCoeff());
  Eigen::RowVector3d low = Eigen::RowVector3d::Constant(1e30), high = -low;
  for (const Points& points : all) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (points(i, 1) < top - head_height) continue;
      low = low.cwiseMin(points.row(i));
      high = high.cwiseMax(points.row(i));
    }
  }
  return {low, high};
}

/// The letters of the sides that `direction` (unit, LPS) points to, the larger share first.
std::string side_letters(const Eigen::Vector3d& direction) {
  const char* const letters[3] = {"LR", "PA", "SI"};
  int order[3] = {0, 1, 2};
  std::sort(order, order + 3,
            [&](int a, int b) { return std::abs(direction(a)) > std::abs(direction(b)); });
  std::string text;
  for (const int axis : order) {
    if (std::abs(direction(axis)) > 0.3) text += letters[axis][direction(axis) > 0 ? 0 : 1];
  }
  return text;
}

vtkSmartPointer<vtkTextActor> text_at(double x, double y) {
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(x, y);
  text->GetTextProperty()->SetColor(ink.x(), ink.y(), ink.z());
  text->SetInput("");
  text->PickableOff();
  return text;
}

void style_bar(vtkScalarBarActor* bar) {
  bar->SetOrientationToVertical();
  bar->SetUnconstrainedFontSize(true);
  bar->SetNumberOfLabels(5);
  bar->SetHeight(0.7);
  bar->SetWidth(0.2);  // held to fewer pixels by size_texts()
  bar->SetBarRatio(0.3);
  bar->SetMaximumNumberOfColors(257);
  for (vtkTextProperty* text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()}) {
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
    text->SetColor(ink.x(), ink.y(), ink.z());
  }
  bar->SetVerticalTitleSeparation(8);
  bar->VisibilityOff();
}

}  // namespace

std::string name_of(CameraPreset view) {
  switch (view) {
    case CameraPreset::front:
      return "front";
    case CameraPreset::left:
      return "left";
    case CameraPreset::right:
      return "right";
    case CameraPreset::three_quarter:
      return "three_quarter";
    case CameraPreset::top:
      return "top";
  }
  return "view";
}

namespace {

/// values: mm, of the vertices that the surface's own were copied from.
void colour(ShownSurface& shown, const Eigen::VectorXd& values, vtkLookupTable* table) {
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("mm");
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(shown.arrays.vertex.size()));
  for (size_t i = 0; i < shown.arrays.vertex.size(); ++i) {
    scalars->SetValue(static_cast<vtkIdType>(i),
                      static_cast<float>(values(shown.arrays.vertex[i])));
  }
  shown.data->GetPointData()->SetScalars(scalars);
  shown.mapper->SetLookupTable(table);
  shown.mapper->UseLookupTableScalarRangeOn();
  shown.mapper->InterpolateScalarsBeforeMappingOn();
}

}  // namespace

struct FaceScene::Impl {
  struct Bone {
    std::shared_ptr<const ReadyBone> ready;
    RigidMotion pose;
    std::unique_ptr<ShownSurface> fine;
    std::unique_ptr<ShownSurface> coarse;  // null: none was given
    bool visible = true;
    bool drawn = true;  // here, not by another part of the scene

    std::vector<vtkActor*> actors() const {
      if (coarse) return {fine->actor, coarse->actor};
      return {fine->actor};
    }
  };

  vtkNew<SceneRenderer> renderer;
  vtkNew<vtkLightKit> lights;
  vtkNew<vtkScalarBarActor> bar;
  vtkSmartPointer<vtkTextActor> label = text_at(0.03, 0.97);
  vtkSmartPointer<vtkTextActor> left_letter = text_at(0.025, 0.03);
  vtkSmartPointer<vtkTextActor> right_letter = text_at(0.975, 0.03);
  vtkNew<vtkCallbackCommand> before_render;

  std::string label_words;
  std::shared_ptr<const ReadyFace> ready;  ///< null: no face
  TriangleMesh face;
  TriangleMesh coarse_face;
  ShownParts parts;
  ShownParts coarse_parts;      ///< none: the face is always drawn whole
  bool parts_outdated = false;  ///< the fine ones: the points have moved while coarse was drawn
  std::map<std::string, Bone> bones;
  bool face_visible = true;
  bool face_textured = true;
  bool colour_map = false;
  double face_opacity = 1;
  bool coarse = false;
  bool coarse_bones = false;

  Impl() {
    renderer->SetBackground(background_low.x(), background_low.y(), background_low.z());
    renderer->SetBackground2(background_high.x(), background_high.y(), background_high.z());
    renderer->GradientBackgroundOn();
    renderer->GetActiveCamera()->SetViewAngle(view_angle);
    set_lights();
    style_bar(bar);
    label->GetTextProperty()->SetVerticalJustificationToTop();
    label->GetTextProperty()->SetLineSpacing(1.2);
    right_letter->GetTextProperty()->SetJustificationToRight();
    for (vtkProp* prop : std::initializer_list<vtkProp*>{bar, label, left_letter, right_letter}) {
      renderer->AddViewProp(prop);
    }
    before_render->SetClientData(this);
    before_render->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      static_cast<Impl*>(self)->prepare_frame();
    });
    renderer->AddObserver(vtkCommand::StartEvent, before_render);
  }

  ~Impl() { renderer->RemoveObserver(before_render); }

  void set_lights() {
    renderer->AutomaticLightCreationOff();
    lights->SetKeyLightIntensity(0.72);
    lights->SetKeyLightAngle(38, 14);
    lights->SetKeyToFillRatio(2.0);
    lights->SetKeyToHeadRatio(2.4);
    lights->SetKeyToBackRatio(3.2);
    lights->SetKeyLightWarmth(0.53);
    lights->SetFillLightWarmth(0.48);
    lights->SetHeadLightWarmth(0.5);
    lights->SetBackLightWarmth(0.5);
    lights->AddLightsToRenderer(renderer);
  }

  /// Text grows with the picture, within what can be read and does not shout.
  void size_texts() {
    // Logical pixels, as fonts have them.
    const double ratio = pixel_ratio(renderer);
    const int width = static_cast<int>(renderer->GetSize()[0] / ratio);
    const int height = static_cast<int>(renderer->GetSize()[1] / ratio);
    const int size = std::clamp(std::min(height / 26, width / 42), 13, 24);
    const int small = std::max(11, size * 3 / 4);
    label->GetTextProperty()->SetFontSize(size);
    // A letter is about half as wide as its size; a fifth is left to the marks in the corner.
    const int letters = std::max(static_cast<int>(0.77 * width / (0.52 * size)), 8);
    label->SetInput(wrapped(label_words, letters).c_str());
    left_letter->GetTextProperty()->SetFontSize(small);
    right_letter->GetTextProperty()->SetFontSize(small);
    bar->GetTitleTextProperty()->SetFontSize(small);
    bar->GetLabelTextProperty()->SetFontSize(small);
    const int bar_width = std::clamp(std::min(height / 8, width / 7), 56, 90);
    bar->SetMaximumWidthInPixels(static_cast<int>(bar_width * ratio));
    bar->SetPosition(1 - (bar_width + 4.0) / std::max(width, bar_width + 4), 0.15);
  }

  void prepare_frame() {
    renderer->ResetCameraClippingRange();
    size_texts();
    vtkCamera* camera = renderer->GetActiveCamera();
    Eigen::Vector3d up(camera->GetViewUp());
    Eigen::Vector3d away(camera->GetDirectionOfProjection());
    const Eigen::Vector3d right = away.cross(up).normalized();
    left_letter->SetInput(side_letters(-right).c_str());
    right_letter->SetInput(side_letters(right).c_str());
  }

  bool draws_coarse_face() const { return coarse && !coarse_parts.empty(); }

  std::vector<ShownPart*> all_parts() const {
    std::vector<ShownPart*> all;
    for (const auto& part : parts) all.push_back(part.get());
    for (const auto& part : coarse_parts) all.push_back(part.get());
    return all;
  }

  /// What is drawn goes where the face is; what is not waits until it is drawn.
  void move_face() {
    parts_outdated = draws_coarse_face();
    if (parts_outdated) coarse_face.vertices = face.vertices(ready->coarse_vertex, Eigen::all);
    const TriangleMesh& mesh = parts_outdated ? coarse_face : face;
    const Points normals = vertex_normals(mesh);
    for (const auto& part : parts_outdated ? coarse_parts : parts) {
      part->move_to(mesh.vertices, normals);
    }
  }

  void show_fine_or_coarse_face() {
    const bool shown = face_visible && face_opacity > 0;
    for (const auto& part : parts) part->actor->SetVisibility(shown && !draws_coarse_face());
    for (const auto& part : coarse_parts) {
      part->actor->SetVisibility(shown && draws_coarse_face());
    }
  }

  void refresh_face_look() {
    for (ShownPart* part : all_parts()) {
      vtkProperty* property = part->actor->GetProperty();
      const bool as_taken = face_textured && !colour_map;
      const bool painted = as_taken && !part->texture && part->arrays.vertex_colours;
      const bool photograph = as_taken && (part->texture || painted);
      part->actor->SetTexture(as_taken ? part->texture.Get() : nullptr);
      if (painted) {
        part->data->GetPointData()->SetScalars(part->arrays.vertex_colours);
        part->mapper->InterpolateScalarsBeforeMappingOff();  // they are colours, not values
      }
      part->mapper->SetScalarVisibility(colour_map || painted);
      if (photograph) {
        set_colour(property, Eigen::Vector3d::Ones());
        shine(property, 0.30, 0.78, 0.04);  // much of the light is already in the photograph
      } else {
        set_colour(property, colour_map ? Eigen::Vector3d::Ones().eval() : part->plain_colour);
        shine(property, 0.12, 0.90, colour_map ? 0.0 : 0.08);
      }
      property->SetOpacity(face_opacity);
      property->SetBackfaceCulling(face_opacity < 1);
    }
    for (const auto& part : coarse_parts) {
      // What cannot be seen is half of what a software renderer draws.
      if (ready->is_outward_closed) part->actor->GetProperty()->BackfaceCullingOn();
    }
    show_fine_or_coarse_face();
    bar->SetVisibility(colour_map && face_visible);
  }

  void clear_face() {
    for (const ShownPart* part : all_parts()) renderer->RemoveActor(part->actor);
    parts.clear();
    coarse_parts.clear();
    coarse_face = {};
    face = {};
    ready.reset();
    colour_map = false;
    bar->VisibilityOff();
  }

  static void apply_look(Bone& bone, const BoneLook& look) {
    for (vtkActor* actor : bone.actors()) {
      set_colour(actor->GetProperty(), look.colour);
      shine(actor->GetProperty(), 0.10, 0.88, 0.12);
      actor->GetProperty()->SetOpacity(look.opacity);
    }
    if (bone.coarse && bone.ready->is_outward_closed && look.opacity == 1) {
      bone.coarse->actor->GetProperty()->BackfaceCullingOn();
    }
  }

  void apply_visibility(Bone& bone) {
    const bool show_coarse = (coarse || coarse_bones) && bone.coarse;
    const bool shown = bone.visible && bone.drawn;
    bone.fine->actor->SetVisibility(shown && !show_coarse);
    if (bone.coarse) bone.coarse->actor->SetVisibility(shown && show_coarse);
  }

  static void apply_pose(Bone& bone) {
    vtkNew<vtkMatrix4x4> matrix;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) matrix->SetElement(r, c, bone.pose.rotation(r, c));
      matrix->SetElement(r, 3, bone.pose.translation(r));
    }
    for (vtkActor* actor : bone.actors()) actor->SetUserMatrix(matrix);
  }

  Bone* find_bone(const std::string& name) {
    const auto found = bones.find(name);
    return found == bones.end() ? nullptr : &found->second;
  }

  /// Everything visible, posed, in picture axes (right, up, away).
  std::vector<Points> visible_points(const Eigen::Matrix3d& axes) const {
    std::vector<Points> all;
    if (!parts.empty() && face_visible && face_opacity > 0) {
      all.push_back(face.vertices * axes.transpose());
    }
    for (const auto& [name, bone] : bones) {
      if (!bone.visible) continue;
      all.push_back(moved(bone.ready->vertices, bone.pose) * axes.transpose());
    }
    return all;
  }
};

FaceScene::FaceScene() : impl_(std::make_unique<Impl>()) {}
FaceScene::~FaceScene() = default;

vtkRenderer* FaceScene::renderer() const {
  return impl_->renderer;
}

void FaceScene::set_face(const TexturedMesh& face, const std::string& name,
                         const Points& vertex_colours) {
  set_face(ready_face(face, name, vertex_colours));
}

void FaceScene::set_face(std::shared_ptr<const ReadyFace> face) {
  impl_->clear_face();
  impl_->ready = std::move(face);
  impl_->face = impl_->ready->surface;
  impl_->coarse_face = impl_->ready->coarse_mesh;
  std::map<vtkImageData*, vtkSmartPointer<vtkTexture>> textures;
  impl_->parts = shown(impl_->ready->whole, textures);
  impl_->coarse_parts = shown(impl_->ready->coarse, textures);
  impl_->parts_outdated = false;
  for (const ShownPart* part : impl_->all_parts()) impl_->renderer->AddActor(part->actor);
  impl_->refresh_face_look();
}

void FaceScene::set_face_points(const Points& points) {
  if (points.rows() != impl_->face.vertices.rows()) {
    throw Error(ErrorKind::numeric, "face",
                "got " + std::to_string(points.rows()) + " positions for " +
                    std::to_string(impl_->face.vertices.rows()) + " vertices",
                "compute the prediction again for the face that is shown");
  }
  if (!points.allFinite()) {
    throw Error(ErrorKind::numeric, "face", "a predicted position is infinite or not a number",
                "check the material values and the segment's motion, and predict again");
  }
  impl_->face.vertices = points;
  impl_->move_face();
}

bool FaceScene::has_face() const {
  return !impl_->parts.empty();
}

void FaceScene::remove_face() {
  impl_->clear_face();
}

void FaceScene::set_face_visible(bool visible) {
  impl_->face_visible = visible;
  impl_->refresh_face_look();
}

void FaceScene::set_face_opacity(double opacity) {
  impl_->face_opacity = std::clamp(opacity, 0.0, 1.0);
  impl_->refresh_face_look();
}

void FaceScene::set_face_textured(bool textured) {
  impl_->face_textured = textured;
  impl_->refresh_face_look();
}

bool FaceScene::is_face_textured() const {
  return impl_->face_textured;
}

void FaceScene::show_colour_map(const Eigen::VectorXd& values, double half_range,
                                const std::string& title) {
  if (values.size() != impl_->face.vertices.rows() || impl_->parts.empty()) {
    throw Error(ErrorKind::numeric, "colour map",
                "got " + std::to_string(values.size()) + " values for a face of " +
                    std::to_string(impl_->face.vertices.rows()) + " vertices",
                "compute the values again for the face that is shown");
  }
  const double limit = half_range > 0 ? half_range : round_half_range(values);
  const auto table = diverging_table(limit);
  for (const auto& part : impl_->parts) colour(*part, values, table);
  const Eigen::VectorXd on_coarse = values(impl_->ready->coarse_vertex);
  for (const auto& part : impl_->coarse_parts) colour(*part, on_coarse, table);
  impl_->bar->SetLookupTable(table);
  impl_->bar->SetTitle(title.c_str());
  impl_->bar->SetLabelFormat(limit < 1 ? "%.2f" : "%.1f");
  impl_->colour_map = true;
  impl_->refresh_face_look();
}

void FaceScene::hide_colour_map() {
  impl_->colour_map = false;
  impl_->refresh_face_look();
}

void FaceScene::set_bone(const std::string& name, const TriangleMesh& bone, const BoneLook& look,
                         const Triangles& coarse) {
  set_bone(name, ready_bone(bone, name, coarse), look);
}

void FaceScene::set_bone(const std::string& name, std::shared_ptr<const ReadyBone> bone,
                         const BoneLook& look) {
  Impl::Bone entry;
  entry.ready = std::move(bone);
  entry.fine = std::make_unique<ShownSurface>(entry.ready->whole, false);
  if (entry.ready->coarse.cells) {
    entry.coarse = std::make_unique<ShownSurface>(entry.ready->coarse, false);
  }
  Impl::apply_look(entry, look);
  impl_->apply_visibility(entry);
  remove_bone(name);
  for (vtkActor* actor : entry.actors()) impl_->renderer->AddActor(actor);
  impl_->bones.emplace(name, std::move(entry));
}

void FaceScene::set_bone_pose(const std::string& name, const RigidMotion& pose) {
  if (Impl::Bone* bone = impl_->find_bone(name)) {
    bone->pose = pose;
    Impl::apply_pose(*bone);
  }
}

void FaceScene::set_bone_visible(const std::string& name, bool visible) {
  if (Impl::Bone* bone = impl_->find_bone(name)) {
    bone->visible = visible;
    impl_->apply_visibility(*bone);
  }
}

bool FaceScene::is_bone_visible(const std::string& name) const {
  const Impl::Bone* bone = impl_->find_bone(name);
  return bone != nullptr && bone->visible;
}

void FaceScene::set_bone_drawn(const std::string& name, bool drawn) {
  if (Impl::Bone* bone = impl_->find_bone(name)) {
    bone->drawn = drawn;
    impl_->apply_visibility(*bone);
  }
}

void FaceScene::set_coarse_bones(bool coarse) {
  impl_->coarse_bones = coarse;
  impl_->renderer->set_quick(coarse || impl_->coarse);
  for (auto& [name, bone] : impl_->bones) impl_->apply_visibility(bone);
}

void FaceScene::set_coarse(bool coarse) {
  if (coarse == impl_->coarse) return;
  impl_->coarse = coarse;
  impl_->renderer->set_quick(coarse || impl_->coarse_bones);
  const bool outdated = coarse ? impl_->draws_coarse_face() : impl_->parts_outdated;
  if (outdated) impl_->move_face();
  impl_->show_fine_or_coarse_face();
  for (auto& [name, bone] : impl_->bones) impl_->apply_visibility(bone);
}

bool FaceScene::is_coarse() const {
  return impl_->coarse;
}

void FaceScene::remove_bone(const std::string& name) {
  if (const Impl::Bone* bone = impl_->find_bone(name)) {
    for (vtkActor* actor : bone->actors()) impl_->renderer->RemoveActor(actor);
    impl_->bones.erase(name);
  }
}

void FaceScene::remove_bones() {
  for (const std::string& name : bone_names()) remove_bone(name);
}

std::vector<std::string> FaceScene::bone_names() const {
  std::vector<std::string> names;
  for (const auto& [name, bone] : impl_->bones) names.push_back(name);
  return names;
}

void FaceScene::set_label(const std::string& text) {
  impl_->label_words = text;
}

void FaceScene::set_orientation_letters(bool visible) {
  impl_->left_letter->SetVisibility(visible);
  impl_->right_letter->SetVisibility(visible);
}

void FaceScene::look_from(CameraPreset view, double aspect_ratio) {
  const Eigen::Matrix3d axes = picture_axes(view);
  const std::vector<Points> all = impl_->visible_points(axes);
  if (all.empty()) return;
  const auto [low, high] = framed_box(all);
  const Eigen::RowVector3d centre = (low + high) / 2;
  // Of the half picture; the rest is for the caption above and the scale bar at the side.
  constexpr double filled_height = 0.87, filled_width = 0.78;
  const double half = std::tan(view_angle * pi / 360);
  const double tan_up = filled_height * half;
  const double tan_right = filled_width * half * aspect_ratio;
  double distance = 1;  // of the camera from the centre, so that every point is in the picture
  for (const Points& points : all) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (points(i, 1) < low.y()) continue;
      const Eigen::RowVector3d x = points.row(i) - centre;
      distance =
          std::max({distance, std::abs(x(0)) / tan_right - x(2), std::abs(x(1)) / tan_up - x(2)});
    }
  }
  const Eigen::Vector3d focus = axes.transpose() * centre.transpose();
  const Eigen::Vector3d eye = focus - distance * axes.row(2).transpose();
  vtkCamera* camera = impl_->renderer->GetActiveCamera();
  camera->SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetViewUp(axes(1, 0), axes(1, 1), axes(1, 2));
  camera->SetViewAngle(view_angle);
  impl_->renderer->ResetCameraClippingRange();
}

}  // namespace gnathion

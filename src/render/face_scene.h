#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh_types.h"
#include "geometry/rigid_motion.h"

class vtkRenderer;

namespace gnathion {

struct ReadyBone;
struct ReadyFace;

/// Where the camera stands. Frame: LPS, patient upright (+z up in the picture).
enum class CameraPreset {
  front,          ///< from anterior; the patient's left is on the picture's right
  left,           ///< the patient's left profile; the nose points to the picture's left
  right,          ///< the patient's right profile; the nose points to the picture's right
  three_quarter,  ///< from anterior, 40° round to the patient's left
  top,            ///< from above; the nose points to the picture's lower edge
};

/// A file-name-safe word for a preset: "front", "left", "right", "three_quarter", "top".
std::string name_of(CameraPreset view);

/// How a bone is shown.
struct BoneLook {
  Eigen::Vector3d colour;  ///< RGB, 0..1
  double opacity = 1;      ///< 0..1
};
inline const BoneLook skull_look{{0.93, 0.89, 0.80}, 1};
inline const BoneLook segment_look{{0.36, 0.66, 0.72}, 1};

/// The patient as a picture: textured face, bones, colour map, caption. It knows no window and no
/// toolkit: whoever shows it adds renderer() to a render window (the application's widget, or
/// offscreen/offscreen.h) and renders. All coordinates are mm, LPS. One thread at a time.
class FaceScene {
 public:
  FaceScene();
  ~FaceScene();
  FaceScene(const FaceScene&) = delete;
  FaceScene& operator=(const FaceScene&) = delete;

  /// Belongs to the scene. Add it to one render window at a time.
  vtkRenderer* renderer() const;

  /// Replaces the face, and ends a colour map. Its textures are read here. `name` is the subject of
  /// messages, usually the photograph's file.
  /// Throws Error(input) when the mesh cannot be shown (check_face() in render/split_surface.h) or
  /// a texture is missing or unreadable (naming that file); the scene is then unchanged.
  /// vertex_colours: n×3, sRGB 0..1, shown where there is no texture; no rows: none.
  void set_face(const TexturedMesh& face, const std::string& name = "face",
                const Points& vertex_colours = {});
  /// The same with what ready_face() (render/ready_surface.h) made, on whatever thread: nothing is
  /// left to be computed here.
  void set_face(std::shared_ptr<const ReadyFace> face);

  /// New positions for the face's vertices, for live dragging: positions and normals only, nothing
  /// is rebuilt. points: n×3 as the face's own.
  /// Throws Error(numeric) when the number differs or a coordinate is not finite; the scene is
  /// then unchanged.
  void set_face_points(const Points& points);

  bool has_face() const;
  void remove_face();
  void set_face_visible(bool visible);
  /// 0..1. Below 1 only the side turned to the viewer is drawn, so that bone shows through one
  /// layer of skin.
  void set_face_opacity(double opacity);
  /// false: plain skin colour instead of the photograph, which shows the shape better.
  void set_face_textured(bool textured);
  bool is_face_textured() const;

  /// Colours the face by one signed number a vertex (n, mm; cool = negative = hollow, hot =
  /// positive = bulge; not a number = not measured = grey), symmetric about 0, with a scalar bar.
  /// half_range: mm at the map's ends; 0 chooses a round one (round_half_range()). `title` stands
  /// over the bar.
  /// Throws Error(numeric) when there is no face or the count differs.
  void show_colour_map(const Eigen::VectorXd& values, double half_range = 0,
                       const std::string& title = "mm");
  void hide_colour_map();

  /// Adds or replaces the bone called `name`, at rest. coarse: fewer triangles over the same
  /// vertices for set_coarse(), as coarse_triangles() in render/coarse_surface.h makes them;
  /// none: the bone is always drawn whole. Throws Error(input) as check_surface().
  void set_bone(const std::string& name, const TriangleMesh& bone, const BoneLook& look,
                const Triangles& coarse = {});
  /// The same with what ready_bone() made.
  void set_bone(const std::string& name, std::shared_ptr<const ReadyBone> bone,
                const BoneLook& look);
  /// Names that the scene does not have are ignored, so that a view can be set before a case is.
  void set_bone_pose(const std::string& name, const RigidMotion& pose);
  void set_bone_visible(const std::string& name, bool visible);
  /// false: another part of the scene shows this bone. The camera is still placed as if it were
  /// drawn here.
  void set_bone_drawn(const std::string& name, bool drawn);
  bool is_bone_visible(const std::string& name) const;
  /// true: bones that have coarse triangles, and a face of many, are drawn with fewer. Switch it on
  /// while a segment is dragged or the camera turns, off at rest.
  void set_coarse(bool coarse);
  /// The bones alone: for a stroke on the face, which lies on its own triangles.
  void set_coarse_bones(bool coarse);
  bool is_coarse() const;
  void remove_bone(const std::string& name);
  void remove_bones();
  std::vector<std::string> bone_names() const;

  /// The caption in the upper left corner; empty: none.
  void set_label(const std::string& text);
  /// Letters at the picture's edges for the patient's side that lies there (L, R, A, P, S, I).
  void set_orientation_letters(bool visible);

  /// Places the camera so that everything visible fills a picture of the given width / height; of
  /// a subject taller than a head (255 mm), such as a scan with shoulders, its upper part.
  void look_from(CameraPreset view, double aspect_ratio);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion

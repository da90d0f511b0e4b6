#include "offscreen/comparison_pictures.h"

namespace gnathion {
namespace {

/// Everything that the pictures of one comparison share.
struct Comparison {
  FaceScene& scene;
  const Points& before;
  const Points& after;
  const Eigen::VectorXd& change;
  const ComparisonOptions& options;
  OffscreenRenderer renderer;

  void show_bones(bool visible) {
    for (const std::string& name : scene.bone_names()) scene.set_bone_visible(name, visible);
  }

  /// Before, after, colour map, and the plan where there are bones.
  std::vector<Picture> pictures(CameraPreset view, int width, int height) {
    std::vector<Picture> row;
    const auto take = [&](const std::string& caption) {
      scene.set_label(caption);
      row.push_back(renderer.render(scene, width, height));
    };
    show_bones(false);
    scene.set_face_points(before);
    scene.look_from(view, static_cast<double>(width) / height);
    take(options.before_caption);
    scene.set_face_points(after);
    take(options.after_caption);
    scene.show_colour_map(change, options.half_range);
    take(options.map_caption);
    scene.hide_colour_map();
    show_bones(true);
    if (!scene.bone_names().empty()) {
      scene.set_face_opacity(0.35);
      take(options.plan_caption);
      scene.set_face_opacity(1);
    }
    scene.set_label("");
    return row;
  }
};

}  // namespace

ComparisonFiles write_comparison(FaceScene& scene, const Points& before, const Points& after,
                                 const Eigen::VectorXd& change, const std::filesystem::path& folder,
                                 const ComparisonOptions& options) {
  Comparison comparison{scene, before, after, change, options, {}};
  scene.set_face_visible(true);
  scene.set_face_opacity(1);
  const auto large = comparison.pictures(options.view, options.width, options.height);
  std::vector<std::vector<Picture>> rows;
  for (const CameraPreset view : options.summary_views) {
    rows.push_back(comparison.pictures(view, options.summary_side, options.summary_side));
  }
  ComparisonFiles files{folder / "before.png",
                        folder / "after.png",
                        folder / "colour_map.png",
                        folder / "summary.png",
                        {}};
  write_png(large[0], files.before);
  write_png(large[1], files.after);
  write_png(large[2], files.colour_map);
  write_png(tiled(rows), files.summary);
  if (large.size() > 3) {
    files.plan = folder / "plan.png";
    write_png(large[3], files.plan);
  }
  return files;
}

}  // namespace gnathion

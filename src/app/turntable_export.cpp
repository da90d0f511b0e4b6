#include "app/turntable_export.h"

#include <QFile>
#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <vector>

#include <vtkRenderer.h>

#include "app/hidden_canvas.h"
#include "io/files.h"
#include "render/face_scene.h"
#include "render/movie_file.h"
#include "render/segment_colours.h"
#include "render/turntable.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<FaceScene> scene_of(const LoadedCase& loaded, const Points& face,
                                    const std::vector<RigidMotion>& poses,
                                    const TurntableWish& wish) {
  const Anatomy& anatomy = *loaded.anatomy;
  auto scene = std::make_unique<FaceScene>();
  scene->set_face(anatomy.face.mesh, anatomy.face.document.path().string(),
                  anatomy.face.document.vertex_colours());
  scene->set_face_points(face);
  scene->set_face_textured(wish.textured);
  const auto is_shown = [&wish](const std::string& bone) {
    return std::find(wish.bones.begin(), wish.bones.end(), bone) != wish.bones.end();
  };
  if (is_shown("skull")) scene->set_bone("skull", anatomy.remainder, skull_look);
  for (std::size_t s = 0; s < anatomy.segments.size(); ++s) {
    const std::string name = "segment " + anatomy.segments[s].name;
    if (!is_shown(name)) continue;
    scene->set_bone(name, anatomy.segments[s].mesh, look_of_segment(s));
    scene->set_bone_pose(name, poses[s]);
  }
  return scene;
}

}  // namespace

struct TurntableExport::Work {
  TurntableWish wish;
  // Built one in each turn of the event loop, too.
  std::vector<std::unique_ptr<FaceScene>> scenes;
  std::vector<Turntable> turns;
  std::vector<std::function<std::unique_ptr<FaceScene>()>> to_build;
  std::unique_ptr<HiddenCanvas> canvas;  ///< goes before the scenes
  std::unique_ptr<MovieFile> film;
  std::unique_ptr<NewFolder> folder;
  int drawn = 0;

  explicit Work(const TurntableWish& wanted) : wish(wanted) {}

  void open(std::size_t scene_count) {
    const int width = wish.side * static_cast<int>(scene_count);
    if (wish.form == TurntableWish::Form::pictures) {
      folder = std::make_unique<NewFolder>(wish.target);
    } else {
      if (fs::exists(wish.target)) {
        throw Error(
            ErrorKind::output, wish.target.string(),
            TurntableExport::tr("it exists already").toStdString(),
            TurntableExport::tr("choose another name; nothing was overwritten").toStdString());
      }
      film = std::make_unique<MovieFile>(wish.target, width, wish.side, turntable_rate);
    }
    canvas = std::make_unique<HiddenCanvas>(width, wish.side);
  }

  void build_scene() {
    scenes.push_back(to_build[scenes.size()]());
    const auto count = static_cast<double>(to_build.size());
    const auto place = static_cast<double>(scenes.size() - 1);
    vtkRenderer* renderer = scenes.back()->renderer();
    renderer->SetViewport(place / count, 0, (place + 1) / count, 1);
    renderer->UseFXAAOn();
    canvas->add(renderer);
    turns.emplace_back(*scenes.back(), 1.0);
  }

  void draw() {
    for (Turntable& turn : turns) turn.turn_to(360.0 * drawn / wish.pictures);
    const Picture picture = canvas->picture();
    ++drawn;
    if (film) {
      film->add(picture);
      return;
    }
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "turn_%04d.png", drawn);
    write_png(picture, folder->path() / name.data());
  }

  void finish() {
    if (film) film->finish();
    if (folder) folder->publish();
  }
};

TurntableExport::TurntableExport(QObject* parent) : QObject(parent) {
  turn_.setInterval(0);
  connect(&turn_, &QTimer::timeout, this, &TurntableExport::step);
}

TurntableExport::~TurntableExport() = default;

void TurntableExport::start(const std::shared_ptr<const LoadedCase>& loaded,
                            const Response& response, const QString& caption,
                            const TurntableWish& wish) {
  if (is_running()) return;
  auto work = std::make_unique<Work>(wish);
  const auto scene = [loaded, wish](const Points& face, const std::vector<RigidMotion>& poses,
                                    const QString& words) {
    return [loaded, wish, face, poses, words] {
      auto built = scene_of(*loaded, face, poses, wish);
      built->set_label(words.toStdString());
      return built;
    };
  };
  if (wish.show == TurntableWish::Show::before_and_predicted) {
    work->to_build.emplace_back(scene(loaded->anatomy->face.mesh.surface.vertices,
                                      std::vector<RigidMotion>(response.poses.size()),
                                      tr("Before")));
  }
  work->to_build.emplace_back(scene(response.face, response.poses, caption));
  try {
    work->open(work->to_build.size());
  } catch (const Error& error) {
    emit failed(failure_of(error));
    return;
  }
  work_ = std::move(work);
  turn_.start();
}

void TurntableExport::cancel() {
  if (!is_running()) return;
  turn_.stop();
  work_.reset();
  emit cancelled();
}

void TurntableExport::step() {
  try {
    if (work_->scenes.size() < work_->to_build.size()) {
      work_->build_scene();
      return;
    }
    work_->draw();
    if (work_->drawn < work_->wish.pictures) {
      emit picture_written(work_->drawn);
      return;
    }
    work_->finish();
  } catch (const Error& error) {
    turn_.stop();
    work_.reset();
    emit failed(failure_of(error));
    return;
  }
  turn_.stop();
  const QString target = QFile::decodeName(work_->wish.target.c_str());
  work_.reset();
  emit finished(target);
}

}  // namespace gnathion

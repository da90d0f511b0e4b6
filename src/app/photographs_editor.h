#pragma once

#include <QObject>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/background_task.h"
#include "app/case_controller.h"
#include "io/obj_document.h"
#include "projection/projection.h"

namespace gnathion {

/// An ordinary photograph, its landmarks, and the camera that they give.
struct EditedPhoto {
  std::filesystem::path file;
  std::shared_ptr<const Photo> photo;
  std::map<std::string, Eigen::Vector2d> pixels;
  CameraOptions camera;
  std::optional<CameraFit> fit;    ///< of the landmarks as they are
  std::optional<Failure> problem;  ///< why there is none, where there are enough landmarks
};

/// Ordinary photographs for the CT's skin: what is picked on either, the cameras that follow, and
/// the painted skin. Works beside the window; knows no widget. Lives on the window's thread.
class PhotographsEditor : public QObject {
  Q_OBJECT
 public:
  /// The controller must outlive the editor.
  explicit PhotographsEditor(CaseController& controller, QObject* parent = nullptr);

  /// While active the skin is made ready and cameras are found; when not, nothing is computed.
  void set_active(bool active);
  /// Whether there is a skin to paint: the case's face is the CT's skin.
  bool has_skin() const { return skin_ != nullptr; }
  /// mm, LPS. \pre has_skin()
  const TriangleMesh& skin() const;

  /// Reads it beside the window; ends with photo_added() or failed().
  void add(const std::filesystem::path& file);
  void remove(std::size_t photo);
  const std::vector<EditedPhoto>& photos() const { return photos_; }

  static const std::vector<std::string>& landmarks();
  std::optional<Eigen::Vector3d> place(const std::string& landmark) const;  ///< LPS mm
  void set_place(const std::string& landmark, const Eigen::Vector3d& lps);
  void set_pixel(std::size_t photo, const std::string& landmark, const Eigen::Vector2d& pixel);
  /// Forgets its place on the skin, or in a photograph.
  void clear_place(const std::string& landmark);
  void clear_pixel(std::size_t photo, const std::string& landmark);
  /// mm on 35 mm film; none: not known.
  void set_focal(std::size_t photo, std::optional<double> focal_35mm);
  /// Where the line meets the skin first, mm, LPS; nothing before the skin is ready.
  std::optional<Eigen::Vector3d> place_in_sight(const Eigen::Vector3d& eye,
                                                const Eigen::Vector3d& direction) const;
  /// How many landmarks of a photograph are known on the skin, too.
  std::size_t pairs(std::size_t photo) const;

  /// Whether there is a photograph and each has its camera.
  bool is_ready() const;
  bool is_fitting() const { return fitting_.is_running(); }
  bool is_projecting() const { return projecting_.is_running(); }
  /// Paints the skin; ends with changed() and preview(), or failed(). \pre is_ready()
  void project();
  /// The painted skin, until anything changes; null: none.
  const ObjDocument* preview() const;
  const PaintedSkin* painted() const;
  /// Paints the skin where that is to be done, writes it into a new folder, and makes that the
  /// case's photograph: a step of the history. Ends with applied() or failed(). \pre is_ready()
  void apply(const std::filesystem::path& folder);
  void cancel();

 signals:
  void changed();
  void photo_added();
  void applied();
  void stage_began(const QString& stage);
  void failed(const gnathion::Failure& failure);

 private:
  struct Preview;
  static std::shared_ptr<const Preview> painted_preview(const SkinSight& sight,
                                                        const std::vector<MarkedPhoto>& photos,
                                                        Progress& progress);
  void take_case();
  void changed_picks();
  void fit();
  std::vector<PhotoLandmark> paired(const EditedPhoto& photo) const;
  std::vector<MarkedPhoto> marked() const;

  CaseController& controller_;
  bool active_ = false;
  std::shared_ptr<const CtVolume> ct_;
  SkinSurfaceOptions skin_options_;
  std::shared_ptr<const LoadedCase> skin_;  ///< whose face is the skin; null: there is none such
  std::shared_ptr<const SkinSight> sight_;  ///< of that skin; null: not made yet
  std::vector<EditedPhoto> photos_;
  std::map<std::string, Eigen::Vector3d> places_;
  std::shared_ptr<const Preview> preview_;
  BackgroundTask reading_;  // last: their workers stop first
  BackgroundTask fitting_;
  BackgroundTask projecting_;
};

}  // namespace gnathion

#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "app/background_task.h"
#include "app/case_controller.h"
#include "app/view_tool.h"
#include "bone/cut_presets.h"
#include "bone/cut_preview.h"
#include "render/cut_handle.h"
#include "render/cut_preview.h"

namespace gnathion {

class FaceView;

/// A cut while it is placed: its grips in the view, the bone coloured by what would come off, and
/// what is told of that. One cut at a time; nothing of the case changes before apply().
class CutEditor : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive the editor.
  CutEditor(CaseController& controller, FaceView& view, QObject* parent = nullptr);
  ~CutEditor() override;

  // Each closes a cut that is open; opened() or failed() follows when the bone has been looked at
  // beside the window. \pre controller.has_case()
  void start(CutPreset preset);
  void start_box();
  void start_blade();
  /// The cut of a segment that the case has, to be changed.
  void start_change(std::size_t segment);
  void close();
  bool is_open() const { return previewer_ != nullptr; }
  bool is_starting() const { return starting_.is_running(); }
  bool is_blade() const { return std::holds_alternative<PlateCut>(cut_); }

  // \pre is_open() for what follows.
  const BoundedCut& cut() const { return cut_; }
  const CutPreview& preview() const { return preview_; }
  const QString& name() const { return name_; }
  void set_name(const QString& name) { name_ = name; }
  /// How far the cut has been moved and turned about its centre since it was opened.
  JawMotion placement() const;
  void set_placement(const JawMotion& placement);
  /// Half of width, depth and height (of a blade: width, length and kerf), mm.
  Eigen::Vector3d half_extents() const;
  void set_half_extents(const Eigen::Vector3d& half_extents);
  /// Of a blade: the piece on its other side is the one to take, and so on in turns.
  void take_other_side();
  /// Whether apply() may be asked: nothing is refused, and the name is free.
  bool can_apply() const;
  /// Whether another segment has the name, or it is empty.
  bool is_name_taken() const;
  /// Makes the segment, as a step of the history; the editor closes when the case has changed.
  void apply();

 signals:
  void opened();
  void changed();  ///< the cut, and with it the preview
  void closed();
  void failed(const gnathion::Failure& failure);

 private:
  struct Begun;
  /// The left button is the camera's, and the segment's grips are away.
  struct CameraOnly : ViewTool {
    bool pressed(const ViewPoint&) override { return false; }
    void dragged(const ViewPoint&) override {}
    void released(const ViewPoint&) override {}
    void hovered(const ViewPoint&) override {}
  };
  using MakeCut = std::function<PresetCut(const CutPreviewer& previewer, Progress& progress)>;
  void begin(std::size_t segment, MakeCut make);
  void open(const Begun& begun);
  void show_cut(const BoundedCut& cut);
  void show_preview();
  QString free_name(const std::string& wanted) const;

  CaseController& controller_;
  FaceView& view_;
  CameraOnly camera_only_;
  CutHandle handle_;
  CutPreviewLayer layer_;
  std::shared_ptr<const CutPreviewer> previewer_;  ///< null: closed
  std::size_t segment_ = 0;                        ///< of the plan; one behind the last: a new one
  BoundedCut begun_;
  BoundedCut cut_;
  CutPreview preview_;
  QString name_;
  BackgroundTask starting_;
};

}  // namespace gnathion

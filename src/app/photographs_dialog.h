#pragma once

#include <QDialog>
#include <memory>

#include "app/photographs_editor.h"
#include "app/view_tool.h"
#include "render/landmark_marks.h"

namespace Ui {
class PhotographsDialog;
}

namespace gnathion {

class FaceView;

/// Ordinary photographs beside the 3D view: landmarks are clicked in the one and in the other, and
/// the CT's skin gets its colours. Not modal, for the view is clicked meanwhile.
class PhotographsDialog : public QDialog, private ViewTool {
  Q_OBJECT
 public:
  /// Both must outlive the dialog.
  PhotographsDialog(CaseController& controller, FaceView& view, QWidget* parent = nullptr);
  ~PhotographsDialog() override;

  const PhotographsEditor& editor() const { return editor_; }

 signals:
  void failed(const gnathion::Failure& failure);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  bool pressed(const ViewPoint& at) override;
  void dragged(const ViewPoint& at) override;
  void released(const ViewPoint& at) override;
  void hovered(const ViewPoint&) override {}
  bool pick(const ViewPoint& at);

  void set_up_table();
  void connect_widgets();
  void connect_editor();
  const std::string& landmark() const;
  const EditedPhoto* photo() const;
  std::size_t photo_index() const;
  void choose_next(bool on_skin);
  void ask_photo();
  void ask_folder();
  void show_state();
  void show_photos();
  void show_table();
  void show_picture();
  void show_marks();
  void show_skin();
  void set_bones_drawn(bool drawn);
  void update_enabled();
  QString state_words() const;

  std::unique_ptr<Ui::PhotographsDialog> ui_;
  CaseController& controller_;
  FaceView& view_;
  PhotographsEditor editor_;
  LandmarkMarks marks_;
  bool has_view_ = false;                       ///< the 3D view shows the skin at rest, for picks
  const ObjDocument* shown_preview_ = nullptr;  ///< and this in place of its colours
};

}  // namespace gnathion

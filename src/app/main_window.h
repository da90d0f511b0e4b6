#pragma once

#include <QMainWindow>
#include <filesystem>
#include <memory>

#include "app/case_controller.h"
#include "app/case_opener.h"
#include "app/case_saver.h"
#include "app/motion_player.h"
#include "app/recent_cases.h"
#include "app/recovery.h"

class QFileDialog;
class QLabel;
class QProgressBar;
class QSlider;
class QToolButton;
namespace Ui {
class MainWindow;
}

namespace gnathion {

class BonePanel;
class ComparePanel;
class Exports;
class FaceView;
class MotionPanel;
class RegionPanel;
class RegistrationPanel;

/// The window: it shows the controller's model and turns what the user does into calls of it.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  CaseController& controller() { return controller_; }
  MotionPlayer& player() { return player_; }
  FaceView& face_view();
  /// At once, whatever becomes of the case that is open.
  void open_case(const QString& file);
  void open_demo_case();
  /// A case, a DICOM folder, a volume or a photograph, as if it were dropped on the window.
  void take(const QString& path) { opener_.take(path); }

 private:
  void add_tools();
  void add_status();
  void add_steps();
  void connect_file_actions();
  void connect_welcome_page();
  void connect_edit_actions();
  void connect_view_actions();
  void connect_grid_actions();
  void connect_motion();
  void connect_refinement();
  void connect_player();
  void connect_work();
  void update_enabled();
  void enable_views(bool any);

  void show_recent();
  void ask_export();
  void ask_picture();
  void save_picture(const QString& file, int scale);
  void ask_tissue();
  void show_about();

  void show_case();
  void show_changed_case();
  void show_history();
  void show_step();
  void show_motion();
  void show_active_segment();
  void show_response();
  void show_refinement();
  void show_answer_words();
  void show_film_frame(const Points& face, double time_s);
  void play_or_stop();
  void cancel();
  void drag_segment(const Eigen::Vector3d& translation);

  std::unique_ptr<Ui::MainWindow> ui_;
  MotionPanel* panel_ = nullptr;
  RegistrationPanel* registration_panel_ = nullptr;
  BonePanel* bone_panel_ = nullptr;
  RegionPanel* region_panel_ = nullptr;
  ComparePanel* compare_panel_ = nullptr;
  QSlider* opacity_slider_ = nullptr;
  QLabel* stage_label_ = nullptr;
  QProgressBar* progress_bar_ = nullptr;
  QToolButton* cancel_button_ = nullptr;
  QLabel* model_label_ = nullptr;
  QString refinement_stage_;
  // Last: their workers stop before any widget goes.
  CaseController controller_;
  MotionPlayer player_;
  RecentCases recent_;
  CaseSaver saver_;
  CaseOpener opener_;
  Recovery recovery_;
  std::unique_ptr<Exports> exports_;
};

}  // namespace gnathion

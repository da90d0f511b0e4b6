#include "app/main_window.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QProgressBar>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "app/answer_words.h"
#include "app/bone_panel.h"
#include "app/camera_mouse.h"
#include "app/compare_panel.h"
#include "app/exports.h"
#include "app/face_view.h"
#include "app/file_dialogs.h"
#include "app/language.h"
#include "app/motion_panel.h"
#include "app/region_panel.h"
#include "app/registration_panel.h"
#include "app/theme.h"
#include "app/tissue_dialog.h"
#include "app/view_grid.h"
#include "base/error.h"
#include "render/picture.h"
#include "ui_main_window.h"

namespace gnathion {
namespace {

std::filesystem::path path_of(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

bool has_texture(const LoadedCase& loaded) {
  if (loaded.anatomy->face.document.vertex_colours().rows() > 0) return true;
  const std::vector<Material>& materials = loaded.anatomy->face.mesh.materials;
  return std::any_of(materials.begin(), materials.end(),
                     [](const Material& material) { return !material.texture.empty(); });
}

/// What a drag is rounded to, so that the numbers shown are the numbers computed with.
double to_tenth(double value) {
  return std::round(10 * value) / 10;
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      ui_(std::make_unique<Ui::MainWindow>()),
      saver_(controller_, *this),
      opener_(controller_, saver_, recent_, *this),
      recovery_(controller_, Recovery::default_root()) {
  ui_->setupUi(this);
  panel_ = ui_->motion_panel;
  add_steps();
  add_tools();
  add_status();
  connect_file_actions();
  connect_welcome_page();
  connect_edit_actions();
  connect_view_actions();
  connect_grid_actions();
  connect_motion();
  connect_refinement();
  connect_player();
  connect_work();
  update_enabled();
  show_answer_words();
}

MainWindow::~MainWindow() {
  // While the view lives, which goes with the other widgets.
  panel_->set_active(false);
  registration_panel_->set_active(false);
  bone_panel_->set_active(false);
  region_panel_->set_active(false);
  compare_panel_->set_active(false);
}

FaceView& MainWindow::face_view() {
  return *ui_->face_view;
}

/// The steps of planning, each with its panel; what a panel adds to the view is there while its
/// step is chosen.
void MainWindow::add_steps() {
  registration_panel_ = new RegistrationPanel(controller_, *ui_->face_view, this);
  bone_panel_ = new BonePanel(controller_, *ui_->face_view, this);
  region_panel_ = new RegionPanel(controller_, *ui_->face_view, this);
  compare_panel_ = new ComparePanel(controller_, *ui_->face_view, this);
  ui_->steps->insertTab(0, registration_panel_, tr("Ph&otograph"));
  ui_->steps->insertTab(1, bone_panel_, tr("&Bone"));
  connect(bone_panel_, &BonePanel::failed, ui_->message_bar, &MessageBar::show_failure);
  ui_->steps->insertTab(2, region_panel_, tr("&Region"));
  ui_->steps->addTab(compare_panel_, tr("&Compare"));
  ui_->steps->setCurrentIndex(ui_->steps->indexOf(ui_->motion_page));
  connect(ui_->steps, &QTabWidget::currentChanged, this, &MainWindow::show_step);
}

void MainWindow::show_step() {
  const QWidget* step = controller_.has_case() ? ui_->steps->currentWidget() : nullptr;
  // First the one that leaves: the view has one tool at a time.
  panel_->set_active(step == ui_->motion_page);
  if (step != registration_panel_) registration_panel_->set_active(false);
  if (step != bone_panel_) bone_panel_->set_active(false);
  if (step != region_panel_) region_panel_->set_active(false);
  if (step != compare_panel_) compare_panel_->set_active(false);
  if (step == registration_panel_) {
    player_.stop();
    registration_panel_->set_active(true);
  }
  if (step == bone_panel_) bone_panel_->set_active(true);
  if (step == region_panel_) region_panel_->set_active(true);
  if (step == compare_panel_) compare_panel_->set_active(true);
}

void MainWindow::add_tools() {
  auto* label = new QLabel(tr("Opacity"), ui_->view_toolbar);
  label->setObjectName("opacity_label");
  label->setContentsMargins(8, 0, 4, 0);
  opacity_slider_ = new QSlider(Qt::Horizontal, ui_->view_toolbar);
  opacity_slider_->setObjectName("opacity_slider");
  opacity_slider_->setRange(0, 100);
  opacity_slider_->setValue(100);
  opacity_slider_->setPageStep(25);
  opacity_slider_->setFixedWidth(90);
  opacity_slider_->setToolTip(tr("How opaque the face is, 0 to 100 %: less shows the bone below"));
  label->setBuddy(opacity_slider_);
  ui_->view_toolbar->addWidget(label);
  ui_->view_toolbar->addWidget(opacity_slider_);
  ui_->view_menu->addSeparator();
  ui_->view_menu->addAction(ui_->steps_dock->toggleViewAction());
}

void MainWindow::add_status() {
  stage_label_ = new QLabel(this);
  stage_label_->setObjectName("stage_label");
  progress_bar_ = new QProgressBar(this);
  progress_bar_->setObjectName("progress_bar");
  progress_bar_->setRange(0, 0);
  progress_bar_->setFixedWidth(120);
  cancel_button_ = new QToolButton(this);
  cancel_button_->setObjectName("cancel_button");
  cancel_button_->setText(tr("Cancel"));
  model_label_ = new QLabel(this);
  model_label_->setObjectName("model_label");
  auto* research = new QLabel(tr("<b>Research use only</b>"), this);
  research->setObjectName("research_label");
  research->setToolTip(tr("Not a medical device: not for decisions about a patient's treatment"));
  // A long path or remark is cut at the window's width instead of stretching it.
  for (QLabel* label : {stage_label_, model_label_}) {
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  }
  for (QWidget* widget :
       std::initializer_list<QWidget*>{progress_bar_, cancel_button_, stage_label_, model_label_}) {
    statusBar()->addWidget(widget, widget == stage_label_ || widget == model_label_ ? 1 : 0);
  }
  statusBar()->addPermanentWidget(research);
}

void MainWindow::connect_file_actions() {
  connect(ui_->open_action, &QAction::triggered, &opener_, &CaseOpener::ask_case);
  connect(ui_->demo_action, &QAction::triggered, &opener_, &CaseOpener::open_demo);
  connect(ui_->import_folder_action, &QAction::triggered, &opener_, &CaseOpener::ask_dicom_folder);
  connect(ui_->import_volume_action, &QAction::triggered, &opener_, &CaseOpener::ask_volume);
  connect(&opener_, &CaseOpener::failed, ui_->message_bar, &MessageBar::show_failure);
  connect(registration_panel_, &RegistrationPanel::photograph_wanted, &opener_,
          &CaseOpener::ask_photograph_file);
  connect(registration_panel_, &RegistrationPanel::failed, ui_->message_bar,
          &MessageBar::show_failure);
  connect(registration_panel_, &RegistrationPanel::fit_began, ui_->message_bar, &QWidget::hide);
  connect(&opener_, &CaseOpener::photograph_added, this,
          [this](const std::filesystem::path& file, bool to_be_fitted) {
            if (!to_be_fitted) return;
            registration_panel_->fit_when_added(file);
            ui_->steps->setCurrentWidget(registration_panel_);
          });
  connect(&recent_, &RecentCases::changed, this, &MainWindow::show_recent);
  connect(ui_->export_action, &QAction::triggered, this, &MainWindow::ask_export);
  connect(ui_->picture_action, &QAction::triggered, this, &MainWindow::ask_picture);
  exports_ = std::make_unique<Exports>(controller_, *ui_->face_view, this);
  connect(ui_->bones_action, &QAction::triggered, exports_.get(), &Exports::ask_bones);
  connect(ui_->turntable_action, &QAction::triggered, exports_.get(), &Exports::ask_turntable);
  connect(exports_.get(), &Exports::failed, ui_->message_bar, &MessageBar::show_failure);
  connect(exports_.get(), &Exports::exported, this,
          [this](const QString& words) { ui_->message_bar->show_notice(tr("Exported"), words); });
  connect(ui_->quit_action, &QAction::triggered, this, &QWidget::close);
  connect(ui_->about_action, &QAction::triggered, this, &MainWindow::show_about);
}

void MainWindow::connect_welcome_page() {
  WelcomePage* page = ui_->welcome_page;
  connect(page, &WelcomePage::demo_wanted, ui_->demo_action, &QAction::trigger);
  connect(page, &WelcomePage::case_wanted, ui_->open_action, &QAction::trigger);
  connect(page, &WelcomePage::dicom_folder_wanted, ui_->import_folder_action, &QAction::trigger);
  connect(page, &WelcomePage::volume_wanted, ui_->import_volume_action, &QAction::trigger);
  connect(page, &WelcomePage::recent_wanted, &opener_, &CaseOpener::take);
  connect(page, &WelcomePage::forget_wanted, &recent_, &RecentCases::forget);
  connect(page, &WelcomePage::clear_wanted, &recent_, &RecentCases::clear);
  connect(page, &WelcomePage::recover_wanted, &recovery_, &Recovery::recover);
  connect(page, &WelcomePage::discard_wanted, &recovery_, &Recovery::discard);
  connect(&opener_, &CaseOpener::drop_hovers, page, &WelcomePage::set_drop_welcome);
  connect(&recovery_, &Recovery::left_behind_changed, page,
          [this, page] { page->show_left_behind(recovery_.left_behind()); });
  connect(&recovery_, &Recovery::noticed, &controller_, &CaseController::noticed);
  page->show_left_behind(recovery_.left_behind());
  show_recent();
}

void MainWindow::show_recent() {
  const QStringList files = recent_.files();
  ui_->welcome_page->show_recent(files);
  ui_->recent_menu->clear();
  ui_->recent_menu->setEnabled(!files.isEmpty());
  for (const QString& file : files) {
    QAction* action = ui_->recent_menu->addAction(QFileInfo(file).fileName().replace("&", "&&"),
                                                  this, [this, file] { opener_.take(file); });
    action->setToolTip(file);
    action->setEnabled(RecentCases::problem_of(file).isEmpty());
  }
  ui_->recent_menu->addSeparator();
  ui_->recent_menu->addAction(tr("&Clear list"), &recent_, &RecentCases::clear)
      ->setObjectName("clear_recent_action");
}

void MainWindow::connect_edit_actions() {
  connect(ui_->save_action, &QAction::triggered, &saver_, &CaseSaver::save);
  connect(ui_->save_as_action, &QAction::triggered, &saver_, &CaseSaver::save_as);
  connect(ui_->tissue_action, &QAction::triggered, this, &MainWindow::ask_tissue);
  connect(ui_->undo_action, &QAction::triggered, &controller_, &CaseController::undo);
  connect(ui_->redo_action, &QAction::triggered, &controller_, &CaseController::redo);
  connect(&controller_, &CaseController::history_changed, this, &MainWindow::show_history);
  connect(&controller_, &CaseController::saved, this, [this](const QString& file) {
    ui_->message_bar->show_notice(tr("Saved"), tr("The case is %1").arg(file));
  });
}

void MainWindow::show_history() {
  const PlanHistory& history = controller_.history();
  ui_->undo_action->setText(history.can_undo()
                                ? tr("&Undo: %1").arg(QString::fromStdString(history.undo_name()))
                                : tr("&Undo"));
  ui_->redo_action->setText(history.can_redo()
                                ? tr("&Redo: %1").arg(QString::fromStdString(history.redo_name()))
                                : tr("&Redo"));
  const QString name = QString::fromStdString(controller_.plan().name);
  setWindowTitle(tr("%1[*] – Gnathion").arg(name.isEmpty() ? tr("Case without a name") : name));
  setWindowModified(controller_.is_modified());
  update_enabled();
}

void MainWindow::connect_view_actions() {
  FaceView* view = ui_->face_view;
  const std::pair<QAction*, CameraPreset> presets[] = {
      {ui_->front_action, CameraPreset::front},
      {ui_->left_action, CameraPreset::left},
      {ui_->right_action, CameraPreset::right},
      {ui_->three_quarter_action, CameraPreset::three_quarter},
      {ui_->top_action, CameraPreset::top},
      {ui_->reset_view_action, CameraPreset::three_quarter}};
  for (const auto& [action, preset] : presets) {
    connect(action, &QAction::triggered, view,
            [view, preset = preset] { view->look_from(preset); });
  }
  connect(ui_->textured_action, &QAction::toggled, view, &FaceView::set_face_textured);
  connect(ui_->bone_action, &QAction::toggled, view, &FaceView::set_bone_visible);
  connect(ui_->colour_map_action, &QAction::toggled, view, &FaceView::set_colour_map_visible);
  connect(view, &FaceView::colour_map_switched, ui_->colour_map_action, &QAction::setChecked);
  connect(ui_->before_action, &QAction::toggled, view, &FaceView::set_before_visible);
  connect_theme_actions(*ui_->system_theme_action, *ui_->light_theme_action,
                        *ui_->dark_theme_action);
  connect_language_actions(
      *ui_->system_language_action, *ui_->english_action, *ui_->german_action,
      [this](const QString& words) { ui_->message_bar->show_notice(tr("Language"), words); });
  connect(opacity_slider_, &QSlider::valueChanged, view,
          [view](int percent) { view->set_face_opacity(percent / 100.0); });
}

void MainWindow::connect_grid_actions() {
  ViewGrid* grid = ui_->view_grid;
  grid->set_up(controller_, *ui_->face_view);
  connect(ui_->reset_view_action, &QAction::triggered, grid, &ViewGrid::fit_slices);
  connect(ui_->slices_action, &QAction::toggled, grid, &ViewGrid::set_slices_visible);
  connect(ui_->outlines_action, &QAction::toggled, grid, &ViewGrid::set_outlines_visible);
  connect(grid, &ViewGrid::outlines_toggled, ui_->outlines_action, &QAction::setChecked);
  connect(ui_->maximise_action, &QAction::triggered, grid, &ViewGrid::toggle_maximised);
  connect(grid, &ViewGrid::maximised_changed, ui_->maximise_action, &QAction::setChecked);
  const std::pair<QAction*, HuWindow> windows[] = {
      {ui_->bone_window_action, bone_window},
      {ui_->soft_tissue_window_action, soft_tissue_window},
      {ui_->skin_window_action, skin_window}};
  for (const auto& [action, window] : windows) {
    connect(action, &QAction::triggered, grid,
            [grid, window = window] { grid->set_hu_window(window); });
  }
  connect(ui_->zoom_in_action, &QAction::triggered, grid, [grid] { grid->zoom(1.25); });
  connect(ui_->zoom_out_action, &QAction::triggered, grid, [grid] { grid->zoom(1 / 1.25); });
  constexpr double turn_deg = 15;
  const std::tuple<QAction*, double, double> turns[] = {{ui_->turn_left_action, -turn_deg, 0},
                                                        {ui_->turn_right_action, turn_deg, 0},
                                                        {ui_->turn_up_action, 0, turn_deg},
                                                        {ui_->turn_down_action, 0, -turn_deg}};
  CameraMouse* camera = &ui_->face_view->camera_mouse();
  for (const auto& [action, right, up] : turns) {
    connect(action, &QAction::triggered, camera,
            [camera, right = right, up = up] { camera->turn(right, up); });
  }
}

void MainWindow::connect_motion() {
  panel_->connect_to(controller_, *ui_->face_view);
  connect(panel_, &MotionPanel::motion_edited, this,
          [this](const JawMotion& motion) { controller_.set_motion(motion); });
  connect(ui_->face_view, &FaceView::segment_dragged, this, &MainWindow::drag_segment);
  connect(ui_->face_view, &FaceView::drag_ended, this, [this] {
    controller_.hold_motion(false);
    show_motion();
  });
  connect(&controller_, &CaseController::case_changed, this, &MainWindow::show_changed_case);
  connect(&controller_, &CaseController::case_opened, this, &MainWindow::show_case);
  connect(&controller_, &CaseController::motion_changed, this, &MainWindow::show_motion);
  connect(panel_, &MotionPanel::segment_chosen, this, [this](int segment) {
    controller_.set_active_segment(static_cast<std::size_t>(segment));
  });
  connect(&controller_, &CaseController::active_segment_changed, this,
          &MainWindow::show_active_segment);
}

void MainWindow::connect_refinement() {
  connect(&controller_, &CaseController::refinement_changed, this, &MainWindow::show_refinement);
  connect(&controller_, &CaseController::refinement_stage, this, [this](const QString& stage) {
    refinement_stage_ = stage;
    show_answer_words();
  });
}

void MainWindow::connect_player() {
  connect(ui_->play_action, &QAction::triggered, this, &MainWindow::play_or_stop);
  connect(&player_, &MotionPlayer::frame_due, this, &MainWindow::show_film_frame);
  connect(&player_, &MotionPlayer::failed, ui_->message_bar, &MessageBar::show_failure);
  for (const auto changed : {&MotionPlayer::began, &MotionPlayer::playing_began}) {
    connect(&player_, changed, this, [this] {
      show_answer_words();
      update_enabled();
    });
  }
  connect(&player_, &MotionPlayer::ended, this, [this] {
    ui_->face_view->end_film();
    show_answer_words();
    update_enabled();
  });
  connect(&controller_, &CaseController::motion_changed, &player_, &MotionPlayer::stop);
}

void MainWindow::connect_work() {
  connect(cancel_button_, &QToolButton::clicked, this, &MainWindow::cancel);
  connect(&controller_, &CaseController::work_began, this, [this](const QString& what) {
    ui_->message_bar->hide();
    stage_label_->setText(what);
    update_enabled();
  });
  connect(&controller_, &CaseController::work_stage, stage_label_, &QLabel::setText);
  connect(&controller_, &CaseController::work_ended, this, &MainWindow::update_enabled);
  connect(&controller_, &CaseController::failed, ui_->message_bar, &MessageBar::show_failure);
  connect(&controller_, &CaseController::noticed, this, [this](const QString& notice) {
    ui_->message_bar->add_notice(tr("Please note"), notice);
  });
  connect(&controller_, &CaseController::exported, this, [this](const QString& folder) {
    ui_->message_bar->show_notice(tr("Exported"),
                                  tr("The predicted face and its report are in %1").arg(folder));
  });
  // An export may end while an opening goes on, and with it no work_ended comes.
  connect(&controller_, &CaseController::exported, this, &MainWindow::update_enabled);
  connect(&controller_, &CaseController::failed, this, &MainWindow::update_enabled);
}

void MainWindow::update_enabled() {
  const bool any = controller_.has_case();
  enable_views(any);
  ui_->export_action->setEnabled(controller_.has_model() && !controller_.is_exporting());
  for (QAction* action : {ui_->picture_action, ui_->bones_action, ui_->turntable_action,
                          ui_->save_action, ui_->save_as_action, ui_->tissue_action}) {
    action->setEnabled(any);
  }
  ui_->undo_action->setEnabled(any && controller_.history().can_undo());
  ui_->redo_action->setEnabled(any && controller_.history().can_redo());
  const auto moves = [](const JawMotion& motion) { return motion != JawMotion{}; };
  const bool any_motion =
      controller_.has_model() &&
      std::any_of(controller_.motions().begin(), controller_.motions().end(), moves);
  ui_->play_action->setEnabled(any_motion);
  ui_->play_action->setChecked(player_.is_running());
  ui_->steps->setEnabled(any);
  panel_->setEnabled(controller_.has_segments());
  const bool working = controller_.is_working();
  const bool refining = any && controller_.refinement() == Refinement::running;
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_bar_, cancel_button_}) {
    widget->setVisible(working || refining || player_.is_computing());
  }
  stage_label_->setVisible(working);
  model_label_->setVisible(!working);
}

/// What looks at a case from another side, or shows other parts of it.
void MainWindow::enable_views(bool any) {
  for (QAction* action : {ui_->front_action,       ui_->left_action,
                          ui_->right_action,       ui_->three_quarter_action,
                          ui_->top_action,         ui_->reset_view_action,
                          ui_->bone_action,        ui_->colour_map_action,
                          ui_->before_action,      ui_->turn_left_action,
                          ui_->turn_right_action,  ui_->turn_up_action,
                          ui_->turn_down_action,   ui_->zoom_in_action,
                          ui_->zoom_out_action,    ui_->maximise_action,
                          ui_->slices_action,      ui_->outlines_action,
                          ui_->bone_window_action, ui_->soft_tissue_window_action,
                          ui_->skin_window_action}) {
    action->setEnabled(any);
  }
  ui_->textured_action->setEnabled(any && has_texture(controller_.loaded()));
  opacity_slider_->setEnabled(any);
}

/// What the status line says is being done.
void MainWindow::cancel() {
  if (controller_.is_working()) {
    controller_.cancel();
  } else if (player_.is_computing()) {
    player_.stop();
  } else {
    controller_.stop_refining();
  }
}

void MainWindow::open_case(const QString& file) {
  controller_.open_case(path_of(file));
}

void MainWindow::open_demo_case() {
  controller_.open_demo_case(CaseOpener::demo_cache());
}

// Dialogs are opened, not executed: no event loop within another, so that the window may close.

void MainWindow::ask_export() {
  QFileDialog* dialog = new_folder_dialog(
      this, "export_dialog", tr("Export the predicted face into a new folder"), "predicted_face");
  dialog->setLabelText(QFileDialog::FileType, tr("Face as:"));
  // In the order of the formats below; they tell what is written, not which names are shown.
  dialog->setNameFilters({tr("OBJ with its materials and pictures (*)"),
                          tr("GLB, one file with pictures (*)"),
                          tr("PLY, one file with coloured vertices (*)")});
  connect(dialog, &QFileDialog::fileSelected, this, [this, dialog](const QString& folder) {
    constexpr std::array formats{"obj", "glb", "ply"};
    const auto format = dialog->nameFilters().indexOf(dialog->selectedNameFilter());
    controller_.export_face(path_of(folder), formats.at(static_cast<std::size_t>(format)));
  });
  dialog->open();
}

void MainWindow::ask_picture() {
  QFileDialog* dialog = new_file_dialog(this, "picture_dialog", tr("Save the picture"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QString large = tr("Pictures with twice as many pixels each way (*.png)");
  dialog->setNameFilters({tr("Pictures (*.png)"), large});
  dialog->setDefaultSuffix("png");
  dialog->setDirectory(QDir::homePath());
  dialog->selectFile("face.png");
  connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, large](const QString& file) {
    save_picture(file, dialog->selectedNameFilter() == large ? 2 : 1);
  });
  dialog->open();
}

void MainWindow::save_picture(const QString& file, int scale) {
  try {
    write_png(ui_->face_view->picture(scale), path_of(file));
    ui_->message_bar->show_notice(tr("Saved"), tr("The picture is %1").arg(file));
  } catch (const Error& error) {
    ui_->message_bar->show_failure(failure_of(error));
  }
}

void MainWindow::ask_tissue() {
  auto* dialog = new TissueDialog(controller_.plan().tissue, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    SurgicalCase plan = controller_.plan();
    plan.tissue = dialog->model();
    controller_.edit(tr("Change the tissue model"), std::move(plan));
  });
  dialog->open();
}

void MainWindow::show_about() {
  auto* box = new QMessageBox(
      QMessageBox::NoIcon, tr("About Gnathion"),
      tr("<h3>Gnathion %1</h3>"
         "<p>Predicts a face after an operation on the jaw, from a CT, a 3D photograph and the "
         "planned motion of a bone segment.</p>"
         "<p><b>Research use only.</b> Gnathion is not a medical device. Its predictions have not "
         "been validated on patients and must not be used for decisions about diagnosis or "
         "treatment.</p>"
         "<p>Free software under the GNU General Public License, version 3 or later, without any "
         "warranty. It uses Qt, VTK, CGAL, GDCM, OpenCV, Eigen and SuiteSparse.</p>")
          .arg(GNATHION_VERSION),
      QMessageBox::Close, this);
  box->setObjectName("about_box");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::show_case() {
  show_changed_case();
  ui_->face_view->look_from(CameraPreset::three_quarter);
}

void MainWindow::show_changed_case() {
  player_.stop();
  const LoadedCase& loaded = controller_.loaded();
  ui_->pages->setCurrentWidget(ui_->view_page);
  ui_->face_view->show_case(loaded);
  QStringList names;
  for (const BoneSegment& segment : loaded.anatomy->segments) {
    names << QString::fromStdString(segment.name);
  }
  panel_->set_segments(names);
  panel_->set_turns_enabled(loaded.plan.tissue.load == LoadModel::displacement);
  show_step();
  show_history();
}

void MainWindow::show_motion() {
  if (controller_.refined() == nullptr) {
    refinement_stage_.clear();
    ui_->face_view->mark_change_outdated();
  }
  if (controller_.has_segments()) panel_->show_motion(controller_.motion());
  show_response();
  update_enabled();
}

void MainWindow::show_active_segment() {
  panel_->show_active_segment(static_cast<int>(controller_.active_segment()));
  panel_->show_motion(controller_.motion());
  ui_->face_view->set_active_segment(controller_.active_segment());
  show_response();
}

void MainWindow::show_response() {
  const JawMotion motion = controller_.has_segments() ? controller_.motion() : JawMotion{};
  panel_->show_response(controller_.response());
  ui_->face_view->show_response(controller_.response(),
                                {motion.left_mm, -motion.forward_mm, motion.up_mm});
  show_answer_words();
}

void MainWindow::show_refinement() {
  if (const Prediction* refined = controller_.refined()) {
    show_response();
    ui_->face_view->set_change(refined->signed_distance);
  }
  show_answer_words();
  update_enabled();
}

void MainWindow::show_answer_words() {
  if (!controller_.has_case()) {
    model_label_->setText(tr("No case is open"));
    return;
  }
  const AnswerWords words = answer_words(controller_, refinement_stage_);
  ui_->face_view->set_caption(predicted_words(controller_) + "\n" + words.caption);
  QString status = words.status.toHtmlEscaped();
  if (words.warning)
    status = QString("<b style='color:%1'>%2</b>").arg(warning_colour(palette()).name(), status);
  if (player_.is_computing()) status = tr("Computing the motion in time");
  if (player_.is_playing()) status = tr("Playing the damped motion of the linear model");
  model_label_->setText(status);
  model_label_->setToolTip(words.explanation);
}

void MainWindow::play_or_stop() {
  if (player_.is_running()) {
    player_.stop();
  } else {
    player_.start(controller_.shared_case(), controller_.response().poses);
  }
}

void MainWindow::show_film_frame(const Points& face, double time_s) {
  const DynamicsOptions& dynamics = player_.options().dynamics;
  ui_->face_view->show_film(
      face, tr("%1 ms after the bone moved, played %2 times slower\n"
               "damped motion, alpha %3/s, beta %4 s, linear model on linear elements")
                .arg(1000 * time_s, 0, 'f', 0)
                .arg(MotionPlayer::slower)
                .arg(dynamics.alpha)
                .arg(dynamics.beta));
}

void MainWindow::drag_segment(const Eigen::Vector3d& translation) {
  JawMotion motion = controller_.motion();
  motion.left_mm = to_tenth(translation.x());
  motion.forward_mm = to_tenth(-translation.y());
  motion.up_mm = to_tenth(translation.z());
  controller_.hold_motion(true);
  controller_.set_motion(motion);
}

}  // namespace gnathion

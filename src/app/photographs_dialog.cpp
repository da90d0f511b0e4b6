#include "app/photographs_dialog.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QHideEvent>
#include <QLocale>
#include <QShowEvent>
#include <QSignalBlocker>
#include <algorithm>

#include "app/face_view.h"
#include "app/file_dialogs.h"
#include "app/theme.h"
#include "ui_photographs_dialog.h"

namespace gnathion {
namespace {

using Eigen::Vector2d;

enum Column { name_column, skin_column, photo_column, pixels_column, mm_column, columns };

QString words_for(const std::string& landmark) {
  const std::pair<const char*, QString> words[] = {
      {"nasion", PhotographsDialog::tr("Nasion")},
      {"nose_tip", PhotographsDialog::tr("Nose tip")},
      {"subnasale", PhotographsDialog::tr("Subnasale")},
      {"canthus_outer_right", PhotographsDialog::tr("Outer canthus R")},
      {"canthus_inner_right", PhotographsDialog::tr("Inner canthus R")},
      {"canthus_inner_left", PhotographsDialog::tr("Inner canthus L")},
      {"canthus_outer_left", PhotographsDialog::tr("Outer canthus L")},
      {"mouth_corner_right", PhotographsDialog::tr("Mouth corner R")},
      {"mouth_corner_left", PhotographsDialog::tr("Mouth corner L")},
      {"pogonion", PhotographsDialog::tr("Pogonion (chin)")},
      {"tragus_right", PhotographsDialog::tr("Tragus (ear) R")},
      {"tragus_left", PhotographsDialog::tr("Tragus (ear) L")}};
  const auto* found = std::find_if(std::begin(words), std::end(words),
                                   [&](const auto& word) { return landmark == word.first; });
  return found->second;
}

QString name_of(const std::filesystem::path& file) {
  return QFile::decodeName(file.filename().c_str());
}

QString number(double value, int digits) {
  return QLocale().toString(value, 'f', digits);
}

}  // namespace

PhotographsDialog::PhotographsDialog(CaseController& controller, FaceView& view, QWidget* parent)
    : QDialog(parent),
      ui_(std::make_unique<Ui::PhotographsDialog>()),
      controller_(controller),
      view_(view),
      editor_(controller) {
  ui_->setupUi(this);
  // Enter in a field must not paint anything.
  for (QPushButton* button : findChildren<QPushButton*>()) button->setAutoDefault(false);
  set_up_table();
  connect_widgets();
  connect_editor();
  show_state();
}

PhotographsDialog::~PhotographsDialog() {
  hide();
}

void PhotographsDialog::set_up_table() {
  QTableWidget* table = ui_->photographs_table;
  const auto& names = PhotographsEditor::landmarks();
  table->setColumnCount(columns);
  table->setHorizontalHeaderLabels(
      {tr("Landmark"), tr("Skin"), tr("Photo"), tr("Pixels"), tr("mm")});
  table->setRowCount(static_cast<int>(names.size()));
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(name_column, QHeaderView::Stretch);
  table->horizontalHeader()->setHighlightSections(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setTabKeyNavigation(false);
  for (int row = 0; row < table->rowCount(); ++row) {
    for (int column = 0; column < columns; ++column) {
      auto* item = new QTableWidgetItem(
          column == name_column ? words_for(names[static_cast<std::size_t>(row)]) : QString());
      if (column > photo_column) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table->setItem(row, column, item);
    }
  }
  table->setCurrentCell(0, 0);
}

void PhotographsDialog::connect_widgets() {
  connect(ui_->photographs_add_button, &QAbstractButton::clicked, this,
          &PhotographsDialog::ask_photo);
  connect(ui_->photographs_remove_button, &QAbstractButton::clicked, this,
          [this] { editor_.remove(photo_index()); });
  connect(ui_->photographs_box, qOverload<int>(&QComboBox::currentIndexChanged), this,
          &PhotographsDialog::show_state);
  connect(ui_->photographs_focal_box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double mm) {
            const bool known = mm > ui_->photographs_focal_box->minimum();
            if (photo()) editor_.set_focal(photo_index(), known ? std::optional(mm) : std::nullopt);
          });
  connect(ui_->photographs_picture, &PicturePane::clicked, this, [this](const Vector2d& pixel) {
    editor_.set_pixel(photo_index(), landmark(), pixel);
    choose_next(false);
  });
  connect(ui_->photographs_table, &QTableWidget::currentCellChanged, this,
          &PhotographsDialog::show_state);
  connect(ui_->photographs_clear_pixel_button, &QAbstractButton::clicked, this,
          [this] { editor_.clear_pixel(photo_index(), landmark()); });
  connect(ui_->photographs_clear_place_button, &QAbstractButton::clicked, this,
          [this] { editor_.clear_place(landmark()); });
  connect(ui_->photographs_cancel_button, &QAbstractButton::clicked, &editor_,
          &PhotographsEditor::cancel);
  connect(ui_->photographs_preview_button, &QAbstractButton::clicked, &editor_,
          &PhotographsEditor::project);
  connect(ui_->photographs_apply_button, &QAbstractButton::clicked, this,
          &PhotographsDialog::ask_folder);
  connect(ui_->photographs_close_button, &QAbstractButton::clicked, this, &QDialog::close);
}

void PhotographsDialog::connect_editor() {
  connect(&editor_, &PhotographsEditor::changed, this, &PhotographsDialog::show_state);
  connect(&editor_, &PhotographsEditor::failed, this, &PhotographsDialog::failed);
  connect(&editor_, &PhotographsEditor::applied, this, &QDialog::close);
  connect(&editor_, &PhotographsEditor::photo_added, this, [this] {
    ui_->photographs_box->setCurrentIndex(static_cast<int>(editor_.photos().size()) - 1);
    ui_->photographs_table->setCurrentCell(0, 0);
  });
  connect(&editor_, &PhotographsEditor::stage_began, this,
          [this](const QString& stage) { ui_->photographs_stage_label->setText(stage); });
  // What is shown in the view was replaced by the case's own.
  connect(&view_, &FaceView::case_shown, this, [this] {
    has_view_ = false;
    shown_preview_ = nullptr;
    if (isVisible()) show_state();
  });
}

const std::string& PhotographsDialog::landmark() const {
  const int row = std::max(0, ui_->photographs_table->currentRow());
  return PhotographsEditor::landmarks()[static_cast<std::size_t>(row)];
}

std::size_t PhotographsDialog::photo_index() const {
  return static_cast<std::size_t>(std::max(0, ui_->photographs_box->currentIndex()));
}

const EditedPhoto* PhotographsDialog::photo() const {
  const std::size_t index = photo_index();
  return index < editor_.photos().size() ? &editor_.photos()[index] : nullptr;
}

/// The next landmark that is not picked there yet, from the chosen one on and around; where all
/// are, the chosen one stays.
void PhotographsDialog::choose_next(bool on_skin) {
  const auto& names = PhotographsEditor::landmarks();
  const auto row = static_cast<std::size_t>(ui_->photographs_table->currentRow());
  for (std::size_t i = 1; i < names.size(); ++i) {
    const std::size_t next = (row + i) % names.size();
    const bool known = on_skin ? editor_.place(names[next]).has_value()
                               : photo() && photo()->pixels.count(names[next]) > 0;
    if (known) continue;
    ui_->photographs_table->setCurrentCell(static_cast<int>(next), 0);
    return;
  }
}

bool PhotographsDialog::pick(const ViewPoint& at) {
  const auto place = editor_.place_in_sight(at.eye, at.direction);
  if (place) editor_.set_place(landmark(), *place);
  return place.has_value();
}

bool PhotographsDialog::pressed(const ViewPoint& at) {
  return pick(at);
}

void PhotographsDialog::dragged(const ViewPoint& at) {
  pick(at);
}

void PhotographsDialog::released(const ViewPoint& at) {
  pick(at);
  choose_next(true);
}

void PhotographsDialog::ask_photo() {
  QFileDialog* dialog =
      new_file_dialog(this, "photographs_file_dialog", tr("Add a photograph of the face"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilters(
      {tr("Pictures (*.jpg *.jpeg *.png *.tif *.tiff *.bmp *.webp)"), tr("All files (*)")});
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& file) { editor_.add(QFile::encodeName(file).toStdString()); });
  dialog->open();
}

void PhotographsDialog::ask_folder() {
  QFileDialog* dialog =
      new_folder_dialog(this, "photographs_folder_dialog",
                        tr("Write the painted skin into a new folder"), "projected_photograph");
  dialog->setLabelText(QFileDialog::Accept, tr("Apply"));
  if (!controller_.file().empty()) {
    dialog->setDirectory(QFile::decodeName(controller_.file().parent_path().c_str()));
  }
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    if (editor_.is_ready()) editor_.apply(QFile::encodeName(folder).toStdString());
  });
  dialog->open();
}

void PhotographsDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  if (event->spontaneous()) return;  // only brought back from the desktop's bar
  marks_.attach(view_.renderer());
  editor_.set_active(true);
  show_state();
}

void PhotographsDialog::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  if (event->spontaneous()) return;
  editor_.set_active(false);
  if (view_.tool() == this) view_.set_tool(nullptr);
  marks_.detach();
  show_skin();
  view_.render_soon();
}

void PhotographsDialog::show_state() {
  show_photos();
  show_table();
  show_picture();
  update_enabled();
  ui_->photographs_state_label->setText(state_words());
  if (!isVisible()) return;
  if (!editor_.has_skin()) {
    close();
    return;
  }
  view_.set_tool(this);
  show_marks();
  show_skin();
  view_.render_soon();
}

void PhotographsDialog::show_photos() {
  QComboBox* box = ui_->photographs_box;
  const QSignalBlocker silent(box);
  const int index = box->currentIndex();
  box->clear();
  for (const EditedPhoto& photo : editor_.photos()) box->addItem(name_of(photo.file));
  box->setCurrentIndex(std::clamp(index, box->count() > 0 ? 0 : -1, box->count() - 1));
  const QSignalBlocker quiet(ui_->photographs_focal_box);
  ui_->photographs_focal_box->setValue(
      photo() ? photo()->camera.focal_35mm.value_or(ui_->photographs_focal_box->minimum())
              : ui_->photographs_focal_box->minimum());
}

void PhotographsDialog::show_table() {
  const auto& names = PhotographsEditor::landmarks();
  for (int row = 0; row < ui_->photographs_table->rowCount(); ++row) {
    const std::string& name = names[static_cast<std::size_t>(row)];
    const auto cell = [&](Column column) { return ui_->photographs_table->item(row, column); };
    cell(skin_column)->setText(editor_.place(name) ? "✓" : "–");
    cell(photo_column)->setText(photo() && photo()->pixels.count(name) > 0 ? "✓" : "–");
    const CameraFit::Residual* residual = nullptr;
    if (photo() && photo()->fit) {
      const auto found = photo()->fit->residuals.find(name);
      if (found != photo()->fit->residuals.end()) residual = &found->second;
    }
    cell(pixels_column)->setText(residual ? number(residual->pixels, 1) : "–");
    cell(mm_column)->setText(residual ? number(residual->mm, 1) : "–");
  }
}

void PhotographsDialog::show_picture() {
  PicturePane* pane = ui_->photographs_picture;
  pane->show_photo(photo() ? photo()->photo : nullptr,
                   tr("Add a photograph of the face from the front, then the profiles if there are "
                      "any."));
  std::vector<PicturePane::Mark> marks;
  if (photo()) {
    for (const auto& [name, pixel] : photo()->pixels) {
      PicturePane::Mark mark{pixel, words_for(name), name == landmark(), {}};
      const auto place = editor_.place(name);
      if (place && photo()->fit) mark.computed = photo()->fit->camera.pixel(*place);
      marks.push_back(mark);
    }
  }
  pane->show_marks(std::move(marks));
}

void PhotographsDialog::show_marks() {
  std::vector<LandmarkMark> marks;
  for (const std::string& name : PhotographsEditor::landmarks()) {
    const auto place = editor_.place(name);
    if (!place) continue;
    marks.push_back(
        {*place, LandmarkMark::Kind::ct, words_for(name).toStdString(), name == landmark()});
  }
  marks_.show(marks, {});
}

void PhotographsDialog::set_bones_drawn(bool drawn) {
  for (const std::string& name : view_.scene().bone_names()) {
    view_.scene().set_bone_drawn(name, drawn);
  }
}

/// While the window is open the skin at rest, where the picks lie, painted as far as it is; then
/// the case as it was.
void PhotographsDialog::show_skin() {
  const bool wanted = isVisible() && editor_.has_skin();
  const ObjDocument* preview = wanted ? editor_.preview() : nullptr;
  if (!controller_.has_case() || (wanted == has_view_ && preview == shown_preview_)) return;
  const Face& face = controller_.loaded().anatomy->face;
  try {
    if (preview != nullptr) {
      view_.scene().set_face(preview->mesh(), "photograph");
    } else if (shown_preview_ != nullptr) {
      view_.scene().set_face(face.mesh, face.document.path().filename().string(),
                             face.document.vertex_colours());
    }
  } catch (const Error& error) {
    emit failed(failure_of(error));
  }
  has_view_ = wanted;
  shown_preview_ = preview;
  set_bones_drawn(!wanted);
  if (wanted) {
    view_.show_film(editor_.skin().vertices,
                    preview != nullptr
                        ? tr("Preview: the photographs on the CT's skin, not applied yet")
                        : tr("The CT's skin: click the chosen landmark"));
  } else {
    view_.end_film();
  }
}

void PhotographsDialog::update_enabled() {
  const bool busy = editor_.is_projecting();
  const bool ready = editor_.is_ready() && !busy && !controller_.is_editing();
  ui_->photographs_add_button->setEnabled(editor_.has_skin());
  for (QWidget* widget :
       std::initializer_list<QWidget*>{ui_->photographs_remove_button, ui_->photographs_focal_box,
                                       ui_->photographs_focal_label}) {
    widget->setEnabled(photo() != nullptr);
  }
  ui_->photographs_clear_pixel_button->setEnabled(photo() && photo()->pixels.count(landmark()) > 0);
  ui_->photographs_clear_place_button->setEnabled(editor_.place(landmark()).has_value());
  ui_->photographs_preview_button->setEnabled(ready && editor_.preview() == nullptr);
  ui_->photographs_apply_button->setEnabled(ready);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{ui_->photographs_progress, ui_->photographs_stage_label,
                                       ui_->photographs_cancel_button}) {
    widget->setVisible(busy);
  }
}

QString PhotographsDialog::state_words() const {
  if (!photo()) return {};
  const std::size_t pairs = editor_.pairs(photo_index());
  const int least = least_landmarks(photo()->camera);
  if (pairs < static_cast<std::size_t>(least)) {
    return tr("Picked on both: %1 of at least %2.").arg(pairs).arg(least);
  }
  if (photo()->problem) {
    return QString("<b style='color:%1'>%2</b>")
        .arg(
            warning_colour(palette()).name(),
            tr("%1 %2. What to do: %3.")
                .arg(photo()->problem->subject, photo()->problem->problem, photo()->problem->remedy)
                .toHtmlEscaped());
  }
  if (!photo()->fit) return tr("Finding the camera…");
  const CameraFit& fit = *photo()->fit;
  QString words =
      tr("Camera found: landmarks off by %1 pixels, %2 mm RMS. The picture's place on "
         "the skin is sure to %3 mm.")
          .arg(number(fit.rms_pixels, 1), number(fit.rms_mm, 1), number(fit.uncertainty_mm, 1));
  if (const PaintedSkin* painted = editor_.painted()) {
    words += "<br>" + tr("The photographs show %1 of %2 cm² of the head's skin; %3 cm² beside are "
                         "made up, the rest has one colour.")
                          .arg(number(painted->seen_cm2, 0), number(painted->skin_cm2, 0),
                               number(painted->inpainted_cm2, 0));
  }
  return words;
}

}  // namespace gnathion

#include "app/welcome_page.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>

#include "app/recent_cases.h"
#include "ui_welcome_page.h"

namespace gnathion {
namespace {

constexpr int subject_role = Qt::UserRole;      ///< the file, or the key
constexpr int problem_role = Qt::UserRole + 1;  ///< why it cannot be opened; empty: it can

QString chosen(const QListWidget* list) {
  const QListWidgetItem* item = list->currentItem();
  return item == nullptr ? QString() : item->data(subject_role).toString();
}

QString folder_words(const QString& file) {
  const QString folder = QFileInfo(file).path();
  const QString home = QDir::homePath();
  return folder.startsWith(home + "/") ? "~" + folder.mid(home.size()) : folder;
}

/// As high as its rows, up to `most` of them, beyond which it is scrolled.
void fit_height(QListWidget* list, int most) {
  int height = 2 * list->frameWidth() + 2;
  for (int row = 0; row < std::min(list->count(), most); ++row) {
    height += list->sizeHintForRow(row) + 2 * list->spacing();
  }
  list->setFixedHeight(height);
}

}  // namespace

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent), ui_(std::make_unique<Ui::WelcomePage>()) {
  ui_->setupUi(this);
  connect_buttons();
  connect_recent();
  connect_left_behind();
  show_drop_frame();
  show_recent({});
  show_left_behind({});
}

WelcomePage::~WelcomePage() = default;

void WelcomePage::connect_buttons() {
  connect(ui_->welcome_demo_button, &QPushButton::clicked, this, &WelcomePage::demo_wanted);
  connect(ui_->welcome_open_button, &QPushButton::clicked, this, &WelcomePage::case_wanted);
  auto* menu = new QMenu(ui_->welcome_import_button);
  menu->setObjectName("welcome_import_menu");
  QAction* folder =
      menu->addAction(tr("A DICOM &folder…"), this, &WelcomePage::dicom_folder_wanted);
  folder->setObjectName("welcome_folder_action");
  QAction* volume = menu->addAction(tr("An image &volume…"), this, &WelcomePage::volume_wanted);
  volume->setObjectName("welcome_volume_action");
  ui_->welcome_import_button->setMenu(menu);
}

void WelcomePage::connect_recent() {
  const auto open = [this] { emit recent_wanted(chosen(ui_->recent_list)); };
  connect(ui_->recent_list, &QListWidget::itemActivated, this, open);
  connect(ui_->recent_open_button, &QPushButton::clicked, this, open);
  connect(ui_->recent_forget_button, &QPushButton::clicked, this,
          [this] { emit forget_wanted(chosen(ui_->recent_list)); });
  connect(ui_->recent_clear_button, &QPushButton::clicked, this, &WelcomePage::clear_wanted);
  connect(ui_->recent_list, &QListWidget::currentItemChanged, this, &WelcomePage::update_buttons);
}

void WelcomePage::connect_left_behind() {
  const auto recover = [this] { emit recover_wanted(chosen(ui_->left_behind_list)); };
  connect(ui_->left_behind_list, &QListWidget::itemActivated, this, recover);
  connect(ui_->recover_button, &QPushButton::clicked, this, recover);
  connect(ui_->discard_button, &QPushButton::clicked, this,
          [this] { emit discard_wanted(chosen(ui_->left_behind_list)); });
}

void WelcomePage::show_recent(const QStringList& files) {
  QListWidget* list = ui_->recent_list;
  list->clear();
  for (const QString& file : files) {
    const QString problem = RecentCases::problem_of(file);
    const QString below = problem.isEmpty() ? folder_words(file) : problem;
    auto* item = new QListWidgetItem(QFileInfo(file).fileName() + "\n" + below, list);
    item->setData(subject_role, file);
    item->setData(problem_role, problem);
    item->setToolTip(problem.isEmpty() ? file : tr("%1: %2").arg(file, problem));
    // Greyed, yet to be chosen: it can still be forgotten.
    if (!problem.isEmpty()) item->setForeground(QColor(128, 134, 140));
  }
  if (list->count() > 0) list->setCurrentRow(0);
  fit_height(list, 5);
  ui_->recent_group->setVisible(list->count() > 0);
  update_buttons();
}

void WelcomePage::update_buttons() {
  const QListWidgetItem* item = ui_->recent_list->currentItem();
  ui_->recent_open_button->setEnabled(item != nullptr &&
                                      item->data(problem_role).toString().isEmpty());
  ui_->recent_forget_button->setEnabled(item != nullptr);
}

void WelcomePage::show_left_behind(const std::vector<LeftBehind>& cases) {
  QListWidget* list = ui_->left_behind_list;
  list->clear();
  for (const LeftBehind& found : cases) {
    const QString name = found.name.isEmpty() ? tr("Case without a name") : found.name;
    const QString file = found.file.isEmpty() ? tr("was not saved yet")
                                              : tr("of %1").arg(QFileInfo(found.file).fileName());
    const QString kept = QLocale().toString(found.kept, tr("d MMMM yyyy, hh:mm"));
    auto* item = new QListWidgetItem(tr("%1\nkept %2, %3").arg(name, kept, file), list);
    item->setData(subject_role, found.key);
    item->setToolTip(found.file);
  }
  if (list->count() > 0) list->setCurrentRow(0);
  fit_height(list, 3);
  ui_->left_behind_group->setVisible(list->count() > 0);
}

void WelcomePage::set_drop_welcome(bool welcome) {
  drop_welcome_ = welcome;
  show_drop_frame();
}

void WelcomePage::show_drop_frame() {
  const QPalette::ColorRole role = drop_welcome_ ? QPalette::Highlight : QPalette::PlaceholderText;
  ui_->drop_label->setStyleSheet(
      QString("border: %1px dashed %2; border-radius: 8px; padding: 8px;")
          .arg(drop_welcome_ ? 3 : 1)
          .arg(palette().color(role).name()));
}

void WelcomePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) show_drop_frame();
  QWidget::changeEvent(event);
}

}  // namespace gnathion

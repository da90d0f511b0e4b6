#include "app/message_bar.h"

#include <QScrollArea>
#include <algorithm>

#include "ui_message_bar.h"

namespace gnathion {
namespace {

constexpr int most_lines = 6;  // beyond these a message is scrolled: the view keeps its place

/// As high as its label needs at its width, up to most_lines.
class TextArea : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override {
    return std::min(widget()->heightForWidth(width), most_lines * fontMetrics().lineSpacing());
  }
  QSize sizeHint() const override { return {widget()->sizeHint().width(), minimum_height()}; }
  QSize minimumSizeHint() const override { return {1, minimum_height()}; }

 private:
  int minimum_height() const { return fontMetrics().lineSpacing(); }
};

}  // namespace

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), ui_(std::make_unique<Ui::MessageBar>()) {
  ui_->setupUi(this);
  connect(ui_->message_close, &QToolButton::clicked, this, &QWidget::hide);
  for (QLabel* label : {ui_->message_title, ui_->message_text, ui_->message_remedy}) {
    label->setMinimumWidth(1);  // a long path, which cannot be wrapped, must not stretch the window
  }
  text_area_ = new TextArea(this);
  text_area_->setFrameShape(QFrame::NoFrame);
  text_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  text_area_->setWidgetResizable(true);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  text_area_->setSizePolicy(policy);
  delete ui_->message_lines->replaceWidget(ui_->message_text, text_area_);
  text_area_->setWidget(ui_->message_text);
  hide();
}

MessageBar::~MessageBar() = default;

void MessageBar::show_failure(const Failure& failure) {
  show_text("#c0392b", failure.subject, tr("Problem: %1").arg(failure.problem),
            tr("What to do: %1").arg(failure.remedy));
}

void MessageBar::show_notice(const QString& title, const QString& text) {
  show_text("#2c7fb8", title, text, QString());
}

void MessageBar::add_notice(const QString& title, const QString& text) {
  const bool joins = !isHidden() && ui_->message_title->text() == title;
  show_notice(title, joins ? ui_->message_text->text() + "\n" + text : text);
}

void MessageBar::show_text(const QString& colour, const QString& title, const QString& text,
                           const QString& remedy) {
  ui_->message_stripe->setStyleSheet(QString("background: %1;").arg(colour));
  ui_->message_title->setText(title);
  ui_->message_title->setToolTip(title);
  ui_->message_text->setText(text);
  text_area_->updateGeometry();
  ui_->message_remedy->setText(remedy);
  ui_->message_remedy->setVisible(!remedy.isEmpty());
  show();
}

}  // namespace gnathion

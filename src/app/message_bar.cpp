#include "app/message_bar.h"

#include "ui_message_bar.h"

namespace gnathion {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), ui_(std::make_unique<Ui::MessageBar>()) {
  ui_->setupUi(this);
  connect(ui_->message_close, &QToolButton::clicked, this, &QWidget::hide);
  for (QLabel* label : {ui_->message_title, ui_->message_text, ui_->message_remedy}) {
    label->setMinimumWidth(1);  // a long path, which cannot be wrapped, must not stretch the window
  }
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

void MessageBar::show_text(const QString& colour, const QString& title, const QString& text,
                           const QString& remedy) {
  ui_->message_stripe->setStyleSheet(QString("background: %1;").arg(colour));
  ui_->message_title->setText(title);
  ui_->message_title->setToolTip(title);
  ui_->message_text->setText(text);
  ui_->message_remedy->setText(remedy);
  ui_->message_remedy->setVisible(!remedy.isEmpty());
  show();
}

}  // namespace gnathion

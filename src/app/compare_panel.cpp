#include "app/compare_panel.h"

#include "app/case_controller.h"
#include "app/face_view.h"
#include "ui_compare_panel.h"

namespace gnathion {

ComparePanel::ComparePanel(CaseController& controller, FaceView& view, QWidget* parent)
    : QWidget(parent),
      ui_(std::make_unique<Ui::ComparePanel>()),
      controller_(controller),
      view_(view) {
  ui_->setupUi(this);
}

ComparePanel::~ComparePanel() = default;

void ComparePanel::set_active(bool) {}

}  // namespace gnathion

#include "app/bone_panel.h"

#include "app/case_controller.h"
#include "app/face_view.h"
#include "ui_bone_panel.h"

namespace gnathion {

BonePanel::BonePanel(CaseController& controller, FaceView& view, QWidget* parent)
    : QWidget(parent),
      ui_(std::make_unique<Ui::BonePanel>()),
      controller_(controller),
      view_(view) {
  ui_->setupUi(this);
}

BonePanel::~BonePanel() = default;

void BonePanel::set_active(bool) {}

}  // namespace gnathion

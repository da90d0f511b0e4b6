#include "app/region_panel.h"

#include "app/case_controller.h"
#include "app/face_view.h"
#include "ui_region_panel.h"

namespace gnathion {

RegionPanel::RegionPanel(CaseController& controller, FaceView& view, QWidget* parent)
    : QWidget(parent),
      ui_(std::make_unique<Ui::RegionPanel>()),
      controller_(controller),
      view_(view) {
  ui_->setupUi(this);
}

RegionPanel::~RegionPanel() = default;

void RegionPanel::set_active(bool) {}

}  // namespace gnathion

#include "app/landmark_tool.h"

namespace gnathion {

LandmarkTool::LandmarkTool(RegistrationEditor& editor, QObject* parent)
    : QObject(parent), editor_(editor) {}

bool LandmarkTool::pick(const ViewPoint& at) {
  const auto place = editor_.place_in_sight(surface_, at.eye, at.direction);
  if (!place) return false;
  editor_.set_landmark(landmark_, surface_, *place);
  return true;
}

bool LandmarkTool::pressed(const ViewPoint& at) {
  return picking_ && pick(at);
}

void LandmarkTool::dragged(const ViewPoint& at) {
  pick(at);
}

void LandmarkTool::released(const ViewPoint& at) {
  pick(at);
  editor_.keep_landmarks();
  emit picked();
}

}  // namespace gnathion

#pragma once

#include <QString>

#include "app/case_controller.h"

namespace gnathion {

/// What the window says of the answer that it shows: which model it is of, and how good.
struct AnswerWords {
  QString caption;      ///< for the picture, one line
  QString status;       ///< for the status line
  QString explanation;  ///< whole sentences
  bool warning = false;
};

/// Of the present response. stage: what a refinement under way is doing. \pre model.has_case().
AnswerWords answer_words(const CaseController& model, const QString& stage);

/// What the picture shows: the segments' motions, a line each and named where there are several.
QString predicted_words(const CaseController& model);

}  // namespace gnathion

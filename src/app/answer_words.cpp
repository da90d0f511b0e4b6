#include "app/answer_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "app/core_words.h"
#include "app/motion_words.h"

namespace gnathion {
namespace {

QString words(const char* text) {
  return QCoreApplication::translate("answer", text);
}

QString mm(double value) {
  return QLocale().toString(value, 'f', 2) + " mm";
}

QString model_name(ElementOrder order, bool large_strain) {
  const bool quadratic = order == ElementOrder::quadratic;
  if (large_strain) {
    return quadratic ? words(QT_TRANSLATE_NOOP("answer", "neo-Hookean model on quadratic elements"))
                     : words(QT_TRANSLATE_NOOP("answer", "neo-Hookean model on linear elements"));
  }
  return quadratic ? words(QT_TRANSLATE_NOOP("answer", "linear model on quadratic elements"))
                   : words(QT_TRANSLATE_NOOP("answer", "linear model on linear elements"));
}

QString capitalised(QString text) {
  text[0] = text[0].toUpper();
  return text;
}

AnswerWords words_of(const Prediction& prediction, const CaseController& model) {
  const Answer& answer = prediction.answer;
  const double tolerance = model.loaded().plan.tissue.tolerance_mm;
  const QString name = model_name(answer.order, answer.large_strain);
  const QString error =
      words(QT_TRANSLATE_NOOP("answer", "estimated error %1")).arg(mm(answer.error.total.p95));
  AnswerWords said;
  said.caption = name + ", " + error;
  said.status = capitalised(name) + QString::fromUtf8(" · ") + error +
                words(QT_TRANSLATE_NOOP("answer", " on 95 % of the face"));
  if (!answer.error.within(tolerance)) {
    said.warning = true;
    said.caption += words(QT_TRANSLATE_NOOP("answer", ", above the tolerance"));
    said.status +=
        words(QT_TRANSLATE_NOOP("answer", ", above the tolerance of %1")).arg(mm(tolerance));
  }
  QStringList sentences{
      capitalised(core_words(answer.why)) + ".",
      words(
          QT_TRANSLATE_NOOP(
              "answer", "The quick answer shown while dragging differs by %1 on 95 % of the face."))
          .arg(mm(prediction.quick_mm))};
  if (prediction.inverted_after > 0) {
    const QString inverted =
        words(QT_TRANSLATE_NOOP("answer", "%1 tetrahedra are turned inside out"))
            .arg(prediction.inverted_after);
    said.warning = true;
    said.status += ", " + inverted;
    sentences << inverted + ".";
  }
  sentences << words(QT_TRANSLATE_NOOP(
                         "answer", "%1 tetrahedra, relative residual of the linear solution %2."))
                   .arg(prediction.answer.tissue->tissue.mesh.tets.rows())
                   .arg(prediction.relative_residual, 0, 'e', 0);
  said.explanation = sentences.join("\n");
  return said;
}

/// Why no face follows.
AnswerWords words_without_model(const CaseController& model) {
  AnswerWords said;
  const auto& why = model.loaded().no_model;
  said.warning = why.has_value();
  said.status =
      why ? words(QT_TRANSLATE_NOOP("answer", "The face cannot follow: %1"))
                .arg(core_words(why->problem()))
          : words(QT_TRANSLATE_NOOP(
                "answer", "Nothing is cut yet: the step Bone makes a segment that can move"));
  said.explanation = why ? core_words(why->remedy()) : QString();
  return said;
}

/// Of the answer that a drag shows. stage: of its refinement.
AnswerWords quick_words(const CaseController& model, const QString& stage) {
  AnswerWords said;
  const QString name = model_name(model.quick_model().order(), false);
  const QString quick = words(QT_TRANSLATE_NOOP("answer", "quick answer, %1")).arg(name);
  const auto say = [&](const QString& state, const QString& sentence) {
    said.caption = quick + state;
    said.status = capitalised(quick) + state;
    said.explanation = sentence;
  };
  switch (model.refinement()) {
    case Refinement::none:
    case Refinement::waiting:
    case Refinement::done:
      say({}, words(QT_TRANSLATE_NOOP(
                  "answer",
                  "Its error is estimated, and a better model asked, when the motion rests.")));
      break;
    case Refinement::running:
      say(words(QT_TRANSLATE_NOOP("answer", ", being refined")),
          words(QT_TRANSLATE_NOOP("answer", "Its error is estimated, and a better model asked.")));
      if (!stage.isEmpty()) said.status += QString::fromUtf8(" · ") + stage;
      break;
    case Refinement::refused:
      say(words(QT_TRANSLATE_NOOP("answer", ", not refined")),
          words(QT_TRANSLATE_NOOP(
              "answer",
              "The refinement failed, see the message; the error of what is shown is not "
              "known.")));
      said.warning = true;
      break;
    case Refinement::stopped:
      say(words(QT_TRANSLATE_NOOP("answer", ", not refined")),
          words(QT_TRANSLATE_NOOP(
              "answer",
              "The refinement was cancelled; the error of what is shown is not known. It begins "
              "again with the next motion.")));
      said.warning = true;
      break;
  }
  return said;
}

}  // namespace

AnswerWords answer_words(const CaseController& model, const QString& stage) {
  if (const Prediction* prediction = model.refined()) return words_of(*prediction, model);
  return model.has_model() ? quick_words(model, stage) : words_without_model(model);
}

QString predicted_words(const CaseController& model) {
  const std::vector<JawMotion>& motions = model.motions();
  if (motions.empty()) return words(QT_TRANSLATE_NOOP("answer", "Before any cut"));
  if (motions.size() == 1)
    return words(QT_TRANSLATE_NOOP("answer", "Predicted: %1")).arg(motion_words(motions[0]));
  QStringList lines{words(QT_TRANSLATE_NOOP("answer", "Predicted"))};
  for (std::size_t s = 0; s < motions.size(); ++s) {
    lines << words(QT_TRANSLATE_NOOP("answer", "%1: %2"))
                 .arg(QString::fromStdString(model.loaded().anatomy->segments[s].name),
                      motion_words(motions[s]));
  }
  return lines.join("\n");
}

}  // namespace gnathion

#include "app/motion_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

namespace gnathion {
namespace {

QString words(const char* text) {
  return QCoreApplication::translate("motion", text);
}

}  // namespace

QString motion_words(const JawMotion& motion) {
  struct Part {
    double value;
    const char* positive;
    const char* negative;
  };
  const Part parts[] = {
      {motion.forward_mm, QT_TRANSLATE_NOOP("motion", "%1 mm forward"),
       QT_TRANSLATE_NOOP("motion", "%1 mm back")},
      {motion.up_mm, QT_TRANSLATE_NOOP("motion", "%1 mm up"),
       QT_TRANSLATE_NOOP("motion", "%1 mm down")},
      {motion.left_mm, QT_TRANSLATE_NOOP("motion", "%1 mm to the left"),
       QT_TRANSLATE_NOOP("motion", "%1 mm to the right")},
      {motion.pitch_deg, QT_TRANSLATE_NOOP("motion", "%1° chin up"),
       QT_TRANSLATE_NOOP("motion", "%1° chin down")},
      {motion.roll_deg, QT_TRANSLATE_NOOP("motion", "%1° left side up"),
       QT_TRANSLATE_NOOP("motion", "%1° right side up")},
      {motion.yaw_deg, QT_TRANSLATE_NOOP("motion", "%1° chin to left"),
       QT_TRANSLATE_NOOP("motion", "%1° chin to right")},
  };
  QStringList said;
  for (const Part& part : parts) {
    if (part.value == 0) continue;
    const QString number = QLocale().toString(std::abs(part.value), 'g', 4);
    said << words(part.value > 0 ? part.positive : part.negative).arg(number);
  }
  return said.isEmpty() ? words("not moved") : said.join(QStringLiteral(", "));
}

QString landmark_words(const std::string& key) {
  QString text = QString::fromStdString(key).replace('_', ' ');
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace gnathion

#include "app/motion_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

#include "app/core_words.h"

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
    const double rounded = std::round(100 * std::abs(part.value)) / 100;
    if (rounded == 0) continue;
    const QString number = QLocale().toString(rounded, 'g', 6);
    said << words(part.value > 0 ? part.positive : part.negative).arg(number);
  }
  return said.isEmpty() ? words(QT_TRANSLATE_NOOP("motion", "not moved"))
                        : said.join(QStringLiteral(", "));
}

namespace {

/// Where a collision is, and whether the other side has one at least half as deep.
QString side_words(const Collision& collision, double middle_x) {
  constexpr double beside = 8;  // mm from the middle
  bool left = false, right = false;
  for (Eigen::Index i = 0; i < collision.places.rows(); ++i) {
    if (collision.depths[i] < collision.depth / 2) continue;
    left = left || collision.places(i, 0) > middle_x + beside;
    right = right || collision.places(i, 0) < middle_x - beside;
  }
  if (left && right) return words(QT_TRANSLATE_NOOP("motion", "both sides"));
  if (left) return words(QT_TRANSLATE_NOOP("motion", "left"));
  if (right) return words(QT_TRANSLATE_NOOP("motion", "right"));
  return words(QT_TRANSLATE_NOOP("motion", "in the middle"));
}

}  // namespace

QString collision_words(const Collision& collision, const QStringList& segments, double middle_x) {
  const QString who = landmark_words(segments[collision.segment].toStdString());
  const QString depth = QLocale().toString(collision.depth, 'f', 1);
  const QString side = side_words(collision, middle_x);
  if (collision.other < 0) {
    return words(QT_TRANSLATE_NOOP("motion", "%1 runs %2 mm into the fixed bone (%3)"))
        .arg(who, depth, side);
  }
  return words(QT_TRANSLATE_NOOP("motion", "%1 and %2 run %3 mm into each other (%4)"))
      .arg(who, segments[collision.other], depth, side);
}

QString landmark_words(const std::string& key) {
  QString text = core_words(QString::fromStdString(key).replace('_', ' '));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace gnathion

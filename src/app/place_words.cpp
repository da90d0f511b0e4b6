#include "app/place_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

namespace gnathion {
namespace {

QString words(const char* text) {
  return QCoreApplication::translate("place", text);
}

}  // namespace

QString direction_words(const Eigen::Vector3d& lps) {
  constexpr const char* names[3][2] = {
      {QT_TRANSLATE_NOOP("place", "%1 mm left"), QT_TRANSLATE_NOOP("place", "%1 mm right")},
      {QT_TRANSLATE_NOOP("place", "%1 mm back"), QT_TRANSLATE_NOOP("place", "%1 mm forward")},
      {QT_TRANSLATE_NOOP("place", "%1 mm up"), QT_TRANSLATE_NOOP("place", "%1 mm down")}};
  constexpr int spoken_order[] = {0, 1, 2};
  QStringList said;
  for (const int axis : spoken_order) {
    if (std::abs(lps[axis]) < 0.05) continue;
    said << words(names[axis][lps[axis] > 0 ? 0 : 1])
                .arg(QLocale().toString(std::abs(lps[axis]), 'f', 1));
  }
  return said.isEmpty() ? mm_words(0) : said.join(QStringLiteral(", "));
}

QString mm_words(double mm, bool with_sign) {
  const double shown = std::abs(mm) < 0.05 ? 0 : mm;
  const QString sign = with_sign && shown > 0 ? QStringLiteral("+") : QString();
  return words(QT_TRANSLATE_NOOP("place", "%1 mm"))
      .arg(sign + QLocale().toString(shown, 'f', 1).replace('-', QChar(0x2212)));
}

}  // namespace gnathion

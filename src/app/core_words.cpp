#include "app/core_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <vector>

namespace gnathion {
namespace {

// What the core says, with %1, %2 … for the numbers and names in it. Elsewhere in the program these
// words are made without Qt, so that lupdate finds them here only; translation_test sees to it that
// the core still says so.
// NOLINTBEGIN(bugprone-suspicious-missing-comma): long lines are cut in two
constexpr const char* said[] = {
    // Stages of long work.
    QT_TRANSLATE_NOOP("core", "read DICOM series"),
    QT_TRANSLATE_NOOP("core", "read volume file"),
    QT_TRANSLATE_NOOP("core", "bone surface"),
    QT_TRANSLATE_NOOP("core", "skin surface"),
    QT_TRANSLATE_NOOP("core", "read photograph"),
    QT_TRANSLATE_NOOP("core", "look at the scan"),
    QT_TRANSLATE_NOOP("core", "register photograph"),
    QT_TRANSLATE_NOOP("core", "find the photograph's place"),
    QT_TRANSLATE_NOOP("core", "the CT's skin"),
    QT_TRANSLATE_NOOP("core", "fitting the photograph"),
    QT_TRANSLATE_NOOP("core", "place the cut"),
    QT_TRANSLATE_NOOP("core", "osteotomy"),
    QT_TRANSLATE_NOOP("core", "search trees"),
    QT_TRANSLATE_NOOP("core", "region"),
    QT_TRANSLATE_NOOP("core", "bone below the face"),
    QT_TRANSLATE_NOOP("core", "ST Generator"),
    QT_TRANSLATE_NOOP("core", "bone map"),
    QT_TRANSLATE_NOOP("core", "tissue from the CT"),
    QT_TRANSLATE_NOOP("core", "supports"),
    QT_TRANSLATE_NOOP("core", "assemble stiffness"),
    QT_TRANSLATE_NOOP("core", "factorise"),
    QT_TRANSLATE_NOOP("core", "response basis"),
    QT_TRANSLATE_NOOP("core", "response basis on quadratic elements"),
    QT_TRANSLATE_NOOP("core", "bones for quick frames"),
    QT_TRANSLATE_NOOP("core", "predict and check"),
    QT_TRANSLATE_NOOP("core", "estimate the error"),
    QT_TRANSLATE_NOOP("core", "quadratic elements for the error"),
    QT_TRANSLATE_NOOP("core", "large strain"),
    QT_TRANSLATE_NOOP("core", "neo-Hookean"),
    QT_TRANSLATE_NOOP("core", "damped motion"),
    QT_TRANSLATE_NOOP("core", "export"),
    QT_TRANSLATE_NOOP("core", "bones as STL"),
    QT_TRANSLATE_NOOP("core", "default case"),
    QT_TRANSLATE_NOOP("core", "painting the skin"),
    QT_TRANSLATE_NOOP("core", "showing the painted skin"),
    QT_TRANSLATE_NOOP("core", "writing the photograph"),
    QT_TRANSLATE_NOOP("core", "pictures"),
    QT_TRANSLATE_NOOP("core", "phantom CT"),
    QT_TRANSLATE_NOOP("core", "phantom DICOM"),
    QT_TRANSLATE_NOOP("core", "phantom photograph"),
    QT_TRANSLATE_NOOP("core", "phantom texture"),
    // Segments of the presets, landmarks.
    QT_TRANSLATE_NOOP("core", "chin"),
    QT_TRANSLATE_NOOP("core", "mandible body"),
    QT_TRANSLATE_NOOP("core", "maxilla"),
    QT_TRANSLATE_NOOP("core", "segment"),
    QT_TRANSLATE_NOOP("core", "pogonion soft"),
    QT_TRANSLATE_NOOP("core", "menton soft"),
    QT_TRANSLATE_NOOP("core", "nasion soft"),
    QT_TRANSLATE_NOOP("core", "mentolabial fold"),
    QT_TRANSLATE_NOOP("core", "lower lip"),
    QT_TRANSLATE_NOOP("core", "upper lip"),
    QT_TRANSLATE_NOOP("core", "stomion"),
    QT_TRANSLATE_NOOP("core", "mouth corner left"),
    QT_TRANSLATE_NOOP("core", "mouth corner right"),
    QT_TRANSLATE_NOOP("core", "subnasale"),
    QT_TRANSLATE_NOOP("core", "nose tip"),
    // Why an answer was chosen, in parts.
    QT_TRANSLATE_NOOP("core",
                      "linear model on %1 linear tetrahedra, estimated error %2 on 95 % of the "
                      "face (tolerance %3)"),
    QT_TRANSLATE_NOOP("core",
                      "linear model on %1 quadratic tetrahedra, estimated error %2 on 95 % of the "
                      "face (tolerance %3)"),
    QT_TRANSLATE_NOOP("core",
                      "neo-Hookean model on %1 linear tetrahedra, estimated error %2 on 95 % of "
                      "the face (tolerance %3)"),
    QT_TRANSLATE_NOOP("core",
                      "neo-Hookean model on %1 quadratic tetrahedra, estimated error %2 on 95 % of "
                      "the face (tolerance %3)"),
    QT_TRANSLATE_NOOP("core", "the error of elements is not estimated for force transfer"),
    QT_TRANSLATE_NOOP(
        "core",
        "the linear model on linear ones would be off by %1 (elements) and %2 (small strain)"),
    QT_TRANSLATE_NOOP("core", "large strain could not follow the motion: %1"),
    QT_TRANSLATE_NOOP("core", "on a finer mesh: %1"),
    QT_TRANSLATE_NOOP("core", "the case or the program allows no better model"),
    QT_TRANSLATE_NOOP("core",
                      "the tissue could follow only %1 % of the motion: beyond, tet %2 near (%3) "
                      "mm is compressed to %4 % of its volume"),
    QT_TRANSLATE_NOOP("core",
                      "the tissue could follow only %1 % of the motion: beyond, tet %2 near (%3) "
                      "mm is turned inside out"),
    QT_TRANSLATE_NOOP(
        "core", "move the bone less, or choose a region with more free tissue around the bone"),
    // Cuts that are refused.
    QT_TRANSLATE_NOOP("core", "cut"),
    QT_TRANSLATE_NOOP("core", "preset"),
    QT_TRANSLATE_NOOP("core", "the blade does not touch the bone"),
    QT_TRANSLATE_NOOP("core", "the box does not touch the bone"),
    QT_TRANSLATE_NOOP("core", "move it onto the bone"),
    QT_TRANSLATE_NOOP("core", "the box holds too little bone to be moved"),
    QT_TRANSLATE_NOOP("core", "the piece to take is too small to be moved"),
    QT_TRANSLATE_NOOP("core", "enlarge the box or move it so that the segment lies in it"),
    QT_TRANSLATE_NOOP("core", "move the blade deeper into the bone"),
    QT_TRANSLATE_NOOP("core", "the blade passes through, but nothing comes apart"),
    QT_TRANSLATE_NOOP("core", "move or turn the blade so that it parts the bone in two"),
    QT_TRANSLATE_NOOP("core",
                      "the blade does not pass through the whole bone: it ends within it, and "
                      "nothing comes apart"),
    QT_TRANSLATE_NOOP("core", "enlarge the blade"),
    QT_TRANSLATE_NOOP("core", "enlarge the blade or move it %1"),
    QT_TRANSLATE_NOOP("core", "to the patient's right"),
    QT_TRANSLATE_NOOP("core", "to the patient's left"),
    QT_TRANSLATE_NOOP("core", "forward"),
    QT_TRANSLATE_NOOP("core", "back"),
    QT_TRANSLATE_NOOP("core", "down"),
    QT_TRANSLATE_NOOP("core", "up"),
    QT_TRANSLATE_NOOP("core",
                      "the blade also cuts bone that does not belong to the segment: %1 cm² %2 it"),
    QT_TRANSLATE_NOOP("core",
                      "the box also cuts bone that does not belong to the segment: %1 cm³ %2 it"),
    QT_TRANSLATE_NOOP("core", "on the patient's right of"),
    QT_TRANSLATE_NOOP("core", "on the patient's left of"),
    QT_TRANSLATE_NOOP("core", "in front of"),
    QT_TRANSLATE_NOOP("core", "behind"),
    QT_TRANSLATE_NOOP("core", "below"),
    QT_TRANSLATE_NOOP("core", "above"),
    QT_TRANSLATE_NOOP("core", "make the blade smaller on that side, or move or turn it"),
    QT_TRANSLATE_NOOP("core", "make the box smaller on that side, or move or turn it"),
    QT_TRANSLATE_NOOP("core", "no such cut was found on this bone: %1"),
    QT_TRANSLATE_NOOP("core", "place a blade or a box by hand"),
    QT_TRANSLATE_NOOP("core", "the chin was not found on the bone"),
    QT_TRANSLATE_NOOP("core", "the bite was not found on the bone"),
    QT_TRANSLATE_NOOP("core", "a jaw was not found on the bone"),
    QT_TRANSLATE_NOOP("core", "choose another HU level"),
    QT_TRANSLATE_NOOP("core", "give the landmark \"stomion\" on the skin, or place a box by hand"),
    QT_TRANSLATE_NOOP(
        "core", "segment empty after the cut: the largest piece of bone in the box has %1 mm3"),
    QT_TRANSLATE_NOOP("core", "move or enlarge the box so that the jaw lies in it (LPS mm)"),
    QT_TRANSLATE_NOOP("core", "segment empty after the cut: the piece at the seed has %1 mm3"),
    QT_TRANSLATE_NOOP("core", "move the seed into the piece to take, or move the plate"),
    QT_TRANSLATE_NOOP("core", "the plate does not touch the bone"),
    QT_TRANSLATE_NOOP(
        "core",
        "the plate is too small to separate anything: the bone at the seed stays in one piece"),
    QT_TRANSLATE_NOOP("core",
                      "enlarge the plate or move it so that it passes right through the jaw"),
    QT_TRANSLATE_NOOP("core", "the bone surface cuts itself where the osteotomy goes"),
    QT_TRANSLATE_NOOP("core", "make the bone surface again from the CT, at another HU level"),
    QT_TRANSLATE_NOOP("core", "the cut would leave a surface that is no two-manifold"),
    QT_TRANSLATE_NOOP("core", "move or turn the cut a little"),
    // The hinge axis.
    QT_TRANSLATE_NOOP("core", "condyles"),
    QT_TRANSLATE_NOOP("core", "there is no bone"),
    QT_TRANSLATE_NOOP("core", "the lower jaw has one side only"),
    QT_TRANSLATE_NOOP("core", "the ends of this piece of bone do not lie as two condyles do"),
    QT_TRANSLATE_NOOP("core", "the lower jaw and the skull are one piece at this bone level"),
    QT_TRANSLATE_NOOP("core", "the CT ends below the condyles"),
    QT_TRANSLATE_NOOP("core",
                      "type two points of the hinge axis, or choose a bone level (HU) at which the "
                      "lower jaw stands alone and a CT that holds both joints"),
    // The region, its tissue, the line between the lips.
    QT_TRANSLATE_NOOP("core", "all of it was erased"),
    QT_TRANSLATE_NOOP("core",
                      "paint the part of the face that may move, or take the suggested one"),
    QT_TRANSLATE_NOOP("core", "no bone of a segment lies under it, so nothing would move the face"),
    QT_TRANSLATE_NOOP("core", "choose a region over the segment, or raise tissue.bone_reach_mm"),
    QT_TRANSLATE_NOOP(
        "core", "it has no rim: the whole surface was chosen, so nothing would hold the face"),
    QT_TRANSLATE_NOOP("core", "choose a smaller region (region.reach_mm, or fewer vertices)"),
    QT_TRANSLATE_NOOP("core", "no part of the face is within %1 mm of the bone segment"),
    QT_TRANSLATE_NOOP("core",
                      "check the photograph's transform and unit, or raise region.reach_mm"),
    QT_TRANSLATE_NOOP("core", "it is in %1 pieces"),
    QT_TRANSLATE_NOOP("core", "choose one connected region around the segment"),
    QT_TRANSLATE_NOOP("core", "its vertices span no triangle of the face"),
    QT_TRANSLATE_NOOP("core", "choose a patch of neighbouring vertices"),
    QT_TRANSLATE_NOOP("core", "its surface touches itself at a vertex of triangle %1"),
    QT_TRANSLATE_NOOP("core", "choose a region without pieces that hang together by a corner only"),
    QT_TRANSLATE_NOOP("core", "only %1 triangles are left at edges of %2 mm"),
    QT_TRANSLATE_NOOP("core", "ask for shorter edges, or choose a larger region"),
    QT_TRANSLATE_NOOP("core", "no point of the tissue is fixed or attached"),
    QT_TRANSLATE_NOOP("core", "choose a region with a rim, so that the face does not float"),
    QT_TRANSLATE_NOOP("core", "the two sides of the face are too different to be mirrored"),
    QT_TRANSLATE_NOOP("core",
                      "paint the other side by hand, or check that the photograph stands upright "
                      "in the patient's frame"),
    QT_TRANSLATE_NOOP("core", "it has fewer than two points"),
    QT_TRANSLATE_NOOP("core", "trace it from corner to corner"),
    QT_TRANSLATE_NOOP("core", "it leaves the region at %1"),
    QT_TRANSLATE_NOOP("core",
                      "trace it on the skin, with more points where the lips curve, or paint the "
                      "region there; where the mouth of the scan is open, no line is needed"),
    QT_TRANSLATE_NOOP("core", "it ends at the region's rim, at %1"),
    QT_TRANSLATE_NOOP("core", "end it at the corner of the mouth, or paint a larger region"),
    QT_TRANSLATE_NOOP("core",
                      "it crosses the region's rim, so that no way along the region follows it"),
    QT_TRANSLATE_NOOP("core",
                      "trace it where the lips are joined; where the mouth of the scan is open, no "
                      "line is needed"),
    QT_TRANSLATE_NOOP("core", "it is too short: it spans %1 edges of the region"),
    QT_TRANSLATE_NOOP("core", "trace it from one corner of the mouth to the other, or remove it"),
    QT_TRANSLATE_NOOP("core", "The profile does not show nose, lips and chin clearly."),
    QT_TRANSLATE_NOOP("core",
                      "The corners of the mouth are not marked as landmarks; the line ends where "
                      "the groove between the lips fades."),
    QT_TRANSLATE_NOOP("core", "Its two halves are not equally long."),
    QT_TRANSLATE_NOOP("core", "There is no face."),
    QT_TRANSLATE_NOOP("core", "No mouth was found below the tip of the nose."),
    QT_TRANSLATE_NOOP("core", "There is no face at the mouth's landmarks."),
    QT_TRANSLATE_NOOP("core", "The groove between the lips hardly shows in the shape."),
    // Doubts about where a photograph lies, and what its size says.
    QT_TRANSLATE_NOOP("core", "only %1 % of the stable region lies near the CT's skin"),
    QT_TRANSLATE_NOOP("core", "only %1 cm² of the photograph lie on the CT's skin"),
    QT_TRANSLATE_NOOP("core", "only %1 % of the photograph near the CT's skin lies on it"),
    QT_TRANSLATE_NOOP("core", "pick landmarks, or check the photograph's unit"),
    QT_TRANSLATE_NOOP("core", "the fit has not come to rest after %1 steps"),
    QT_TRANSLATE_NOOP("core", "begin nearer, from landmarks"),
    QT_TRANSLATE_NOOP("core",
                      "the surfaces lie %1 mm apart where they fit best: another person, another "
                      "expression or another scale"),
    QT_TRANSLATE_NOOP("core", "look at the colour map"),
    QT_TRANSLATE_NOOP("core", "the part that decides is as smooth as a ball and could slide"),
    QT_TRANSLATE_NOOP("core", "paint more of the nose and the brows as stable, or pick landmarks"),
    QT_TRANSLATE_NOOP("core", "the landmarks are %1 mm apart (RMS) where the surfaces fit"),
    QT_TRANSLATE_NOOP("core",
                      "look for one that was picked elsewhere, or begin from the landmarks"),
    QT_TRANSLATE_NOOP(
        "core", "upper and lower face do not fit together (%1 mm), as with another expression"),
    QT_TRANSLATE_NOOP("core", "look whether forehead and nose fit, and paint them as stable"),
    QT_TRANSLATE_NOOP("core", "nothing of the photograph's shape is like the CT's face"),
    QT_TRANSLATE_NOOP("core", "pick landmarks"),
    QT_TRANSLATE_NOOP("core", "it fits elsewhere nearly as well"),
    QT_TRANSLATE_NOOP("core", "pick landmarks to say where it belongs"),
    QT_TRANSLATE_NOOP("core", "the fit has moved the face %1 mm from its start"),
    QT_TRANSLATE_NOOP("core", "look whether it slid, or let it be found from shape alone"),
    QT_TRANSLATE_NOOP(
        "core", "the photograph is in no usual unit: %1 mm a unit were estimated from its shape"),
    QT_TRANSLATE_NOOP("core", "measure it, or give the scale"),
    QT_TRANSLATE_NOOP("core",
                      "in no usual unit is the scan as large as a head; with %1 mm a unit its "
                      "longest side is that of one"),
    QT_TRANSLATE_NOOP("core",
                      "in %1 the scan is %2 mm along its longest side, as a face or head is"),
    QT_TRANSLATE_NOOP(
        "core", "in %1 the scan is %2 mm along its longest side, as a head with shoulders is"),
    QT_TRANSLATE_NOOP("core", "few scanners use inches, and some use no unit at all"),
    // Files that cannot be opened or written.
    QT_TRANSLATE_NOOP("core", "does not exist or cannot be reached"),
    QT_TRANSLATE_NOOP("core", "check the name, its rights, and that its disk is connected"),
    QT_TRANSLATE_NOOP("core", "does not exist or cannot be opened"),
    QT_TRANSLATE_NOOP("core", "check the path and its permissions"),
    QT_TRANSLATE_NOOP("core", "the file does not exist or cannot be reached"),
    QT_TRANSLATE_NOOP("core", "the file cannot be opened"),
    QT_TRANSLATE_NOOP("core", "check its name and rights"),
    QT_TRANSLATE_NOOP("core", "check the file's name and rights"),
    QT_TRANSLATE_NOOP("core", "the file is empty"),
    QT_TRANSLATE_NOOP("core", "the file is larger than 2 GiB"),
    QT_TRANSLATE_NOOP("core", "choose another file"),
    QT_TRANSLATE_NOOP("core", "reduce the scan"),
    QT_TRANSLATE_NOOP("core", "the file cannot be read to its end"),
    QT_TRANSLATE_NOOP("core", "check the disk and the file's rights"),
    QT_TRANSLATE_NOOP("core", "is one file of a DICOM series"),
    QT_TRANSLATE_NOOP("core", "give the folder that holds the series"),
    QT_TRANSLATE_NOOP("core", "is nothing that Gnathion can open"),
    QT_TRANSLATE_NOOP(
        "core",
        "give a folder with DICOM files, a volume (%1), a photograph (%2) or a case (.json)"),
    QT_TRANSLATE_NOOP("core", "it is not a file"),
    QT_TRANSLATE_NOOP("core", "choose a face scan"),
    QT_TRANSLATE_NOOP("core", "export the scan again, reduced or in another format"),
    QT_TRANSLATE_NOOP("core", "it cannot be written"),
    QT_TRANSLATE_NOOP("core", "it cannot be written (%1); what was there is unchanged"),
    QT_TRANSLATE_NOOP("core", "check free space and rights, or choose another place"),
    QT_TRANSLATE_NOOP("core", "it exists already, and nothing is overwritten"),
    QT_TRANSLATE_NOOP("core", "name a new folder"),
    QT_TRANSLATE_NOOP("core", "no folder can be made here (%1)"),
    QT_TRANSLATE_NOOP("core", "choose an existing place that you may write to"),
    QT_TRANSLATE_NOOP(
        "core",
        "choose a folder that exists and may be written, and see that the disk is not full"),
    // Notices, and what a CT or a photograph may lack.
    QT_TRANSLATE_NOOP("core",
                      "no teeth as dense as enamel or metal are in the CT, so no tissue slides on "
                      "teeth; mark it with tissue.sliding_vertices where it should"),
    QT_TRANSLATE_NOOP(
        "core",
        "the fixed rim of the region comes within %1 mm of the moving bone, so the face is held "
        "back there; a larger region or a photograph that reaches farther would be better"),
    QT_TRANSLATE_NOOP("core",
                      "%1 % of the tissue is neither skin, fat nor muscle in the CT and was "
                      "counted as muscle; check that photograph and CT fit together"),
    QT_TRANSLATE_NOOP("core",
                      "tissue on \"%1\" is let go within %2 mm of other bone only "
                      "(tissue.released_mm): it is small"),
    QT_TRANSLATE_NOOP("core", "%1 files repeat a slice exactly and were left out"),
    QT_TRANSLATE_NOOP(
        "core", "slice positions scatter by up to %1 mm about even steps; even steps are used"),
    QT_TRANSLATE_NOOP("core",
                      "the gantry is tilted by %1 degrees; the slices keep their true places, "
                      "nothing is resampled"),
    QT_TRANSLATE_NOOP("core", "%1 names no unit of length: mm are assumed"),
    QT_TRANSLATE_NOOP("core", "%1 voxels are not a number and count as air"),
    QT_TRANSLATE_NOOP("core", "holds no bone at %1 HU"),
    QT_TRANSLATE_NOOP("core", "holds no skin at %1 HU"),
    QT_TRANSLATE_NOOP("core", "choose another HU level, or another CT"),
    QT_TRANSLATE_NOOP("core", "holds no readable DICOM file"),
    QT_TRANSLATE_NOOP("core", "give the folder that holds the DICOM files"),
    QT_TRANSLATE_NOOP("core", "is a photograph, and no case is open to add it to"),
    QT_TRANSLATE_NOOP("core", "open a case or import a CT first, then drop the photograph again"),
};
// NOLINTEND(bugprone-suspicious-missing-comma)

struct Pattern {
  QRegularExpression english;
  QString source;
};

/// Those of `said` that hold a number or a name.
const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> made = [] {
    std::vector<Pattern> found;
    static const QRegularExpression place("%[1-9]");
    for (const char* source : said) {
      QStringList parts;
      for (const QString& part : QString::fromUtf8(source).split(place)) {
        parts << QRegularExpression::escape(part);
      }
      if (parts.size() == 1) continue;
      const QString whole = QRegularExpression::anchoredPattern(parts.join("(.+?)"));
      found.push_back({QRegularExpression(whole), QString::fromUtf8(source)});
    }
    return found;
  }();
  return made;
}

QString translated(const QString& english) {
  return QCoreApplication::translate("core", english.toUtf8().constData());
}

}  // namespace

QString core_words(const QString& english) {
  QString whole = translated(english);
  if (whole != english) return whole;
  for (const Pattern& pattern : patterns()) {
    const QRegularExpressionMatch match = pattern.english.match(english);
    if (!match.hasMatch()) continue;
    QString text = translated(pattern.source);
    if (text == pattern.source) return english;
    for (int i = 1; i <= match.lastCapturedIndex(); ++i) {
      text.replace("%" + QString::number(i), core_words(match.captured(i)));
    }
    return text;
  }
  QStringList parts = english.split("; ");
  if (parts.size() == 1) return english;
  for (QString& part : parts) part = core_words(part);
  return parts.join("; ");
}

QString core_words(const std::string& english) {
  return core_words(QString::fromStdString(english));
}

}  // namespace gnathion

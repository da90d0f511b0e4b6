#pragma once

#include <string>

#include "base/progress.h"
#include "bone/cut_preview.h"
#include "bone/jaw_anatomy.h"

namespace gnathion {

/// The usual operations, as bounded cuts to begin with.
enum class CutPreset {
  /// Genioplasty: a blade from below the roots of the lower front teeth, down and back to the lower
  /// border of the jaw.
  chin,
  /// Sagittal split of both sides: a box that takes the tooth-bearing part. Simplified: the jaw is
  /// parted straight behind the last molars, where a surgeon splits the ramus lengthwise, and both
  /// sides at the same distance.
  mandible_body,
  /// Le Fort I: a box from the bite to above the floor of the nose, back to the tuberosities.
  /// Simplified: its roof is one plane without steps, and the pterygoids are parted by its back.
  maxilla,
};

/// A cut and what the piece is called.
struct PresetCut {
  std::string name;  ///< "chin", "mandible body", "maxilla"
  BoundedCut cut;
};

/// The preset on this head, made smaller or larger until its preview on `bone` has nothing to
/// refuse. jaw: as find_jaw() gives it for the whole bone, before any cut.
/// Throws Error(anatomy) that says why when no such cut was found, and Error(cancelled).
PresetCut preset_cut(CutPreset preset, const JawAnatomy& jaw, const CutPreviewer& bone,
                     Progress& progress);

}  // namespace gnathion

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.h"
#include "bone/osteotomy.h"

namespace gnathion {

/// Where a triangle of the bone would be after a cut.
enum class CutPart : std::uint8_t {
  kept,       ///< on bone that stays
  segment,    ///< on the piece that comes off and is moved
  loose,      ///< on another piece that comes apart by the same cut, and is not moved
  forbidden,  ///< cut through without being part of the segment's separation
};

struct PreviewedBone;

/// What a cut would do.
struct CutPreview {
  std::vector<CutPart> part;      ///< m; a triangle that the cut divides goes with its larger part
  double segment_mm3 = 0;         ///< of the piece that comes off; 0: none does
  std::vector<double> loose_mm3;  ///< of the other pieces that come apart
  double sawn_mm2 = 0;            ///< area of bone that the blade or the box's sides go through
  std::optional<Error> refusal;   ///< why this cut should not be made, and what to do
};

/// Tells what a cut would do while it is still being placed: which piece comes off, what else comes
/// apart, and why it would be refused. Tens of milliseconds on 500 000 triangles, without making a
/// surface: the bone's triangles are joined where the cut does not pass, and the sawn areas, in
/// rows of spans 0.5 mm apart, join what hangs together inside the bone. Volumes agree with
/// cut_segment() within 1 %.
///
/// Refused are: a cut through which nothing comes off, and one that goes through bone without
/// bordering on the segment there (the spine behind the chin, the other jaw's teeth): only the bone
/// that the segment is taken from is selected for the saw, and only where it comes off.
class CutPreviewer {
 public:
  /// bone: closed, outward, LPS mm, as of cut_segment(). Some 0.3 s on 500 000 triangles.
  explicit CutPreviewer(TriangleMesh bone);
  ~CutPreviewer();
  CutPreviewer(const CutPreviewer&) = delete;
  CutPreviewer& operator=(const CutPreviewer&) = delete;

  const TriangleMesh& bone() const;
  /// From any number of threads. Throws Error(anatomy) as box_of() (bone/cut_box.h).
  CutPreview preview(const BoundedCut& cut, const CutOptions& options = {}) const;

 private:
  std::unique_ptr<const PreviewedBone> bone_;
};

}  // namespace gnathion

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "plan/surgical_case.h"
#include "projection/skin_painting.h"

namespace gnathion {

/// A photograph of the patient and the landmarks picked in it.
struct MarkedPhoto {
  std::string name;  ///< for messages and the report: the file's name
  std::shared_ptr<const Photo> photo;
  std::vector<PhotoLandmark> landmarks;
  CameraOptions camera;
};

/// The CT's skin with the colours of ordinary photographs.
struct ProjectedPhotographs {
  std::vector<CameraFit> cameras;  ///< of the photographs, in their order
  PaintedSkin painted;
};

/// Finds each photograph's camera and paints the skin with all of them. The first sets the colours:
/// that from the front. Throws Error(input) naming the photograph, as fit_camera() and
/// paint_skin(), and when there is none; Error(cancelled).
ProjectedPhotographs project_photographs(const std::vector<MarkedPhoto>& photos,
                                         const SkinSight& skin, const PaintOptions& options,
                                         Progress& progress);

/// Writes into an existing folder what the case then takes as its photograph: photograph.obj in LPS
/// mm with the skin's vertices in order, photograph.mtl, photograph.png; and projection.json, how
/// well the photographs fit, in their order, and what they show. Nothing of the photographs' files
/// is carried over, their names neither. Throws Error(output).
void write_projection(const ProjectedPhotographs& projected, const TriangleMesh& skin,
                      const std::filesystem::path& folder);

/// The plan with that photograph as its face. Vertices that it lists of the face stay where its
/// face was the CT's skin, whose vertices these are; those of another photograph go.
SurgicalCase with_projection(SurgicalCase plan, const std::filesystem::path& folder);

}  // namespace gnathion

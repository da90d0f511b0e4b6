#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh_types.h"

class vtkRenderer;

namespace gnathion {

/// A word in the picture at a place of the patient.
struct PlacedWord {
  Eigen::Vector3d place;  ///< mm, LPS
  std::string text;
};

/// Red dots where bone runs into bone, with how deep, before everything else. One thread, the
/// window's own.
class CollisionMarks {
 public:
  CollisionMarks();
  ~CollisionMarks();
  CollisionMarks(const CollisionMarks&) = delete;
  CollisionMarks& operator=(const CollisionMarks&) = delete;

  void attach(vtkRenderer* renderer);
  void detach();
  /// places: k×3, mm, LPS; none: nothing is shown.
  void show(const Points& places, const std::vector<PlacedWord>& words);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion

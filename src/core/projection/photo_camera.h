#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "geometry/rigid_motion.h"
#include "projection/skin_sight.h"

namespace gnathion {

/// The same place of the face on the CT's skin and in a photograph.
struct PhotoLandmark {
  std::string name;
  Eigen::Vector3d lps;    ///< mm
  Eigen::Vector2d pixel;  ///< right and down; the middle of the upper left pixel is (0, 0)
};

/// Where a photograph was taken from: a pinhole camera with square pixels, without distortion, its
/// axis through the picture's middle.
struct PhotoCamera {
  /// From LPS to the camera's own frame: x to the picture's right, y down, z into the picture, mm.
  RigidMotion camera_from_lps;
  double focal = 0;        ///< pixels
  Eigen::Vector2d centre;  ///< where the axis meets the picture, pixels

  Eigen::Vector3d eye() const;                     ///< LPS mm
  double depth(const Eigen::Vector3d& lps) const;  ///< mm along the axis
  /// \pre depth(lps) > 0
  Eigen::Vector2d pixel(const Eigen::Vector3d& lps) const;
  /// Of unit length, LPS: from the eye through a place of the picture.
  Eigen::Vector3d direction(const Eigen::Vector2d& pixel) const;
};

/// What is known of a camera beforehand.
struct CameraOptions {
  /// Focal length as of a film of 36 x 24 mm (by the diagonal), as cameras write it into their
  /// pictures, for the picture as a whole. None: estimated.
  std::optional<double> focal_35mm;
};

/// A camera found from landmarks, and how well it explains them.
struct CameraFit {
  struct Residual {
    double pixels = 0;
    double mm = 0;  ///< at the landmark, across the line of sight
  };
  PhotoCamera camera;
  std::map<std::string, Residual> residuals;
  double rms_pixels = 0;
  double rms_mm = 0;
  double focal_35mm = 0;
  /// How far the picture may lie from its true place on the skin, mm: standard deviation when each
  /// landmark is picked to a millimetre (or to what the residuals say, where they say more), the
  /// 95th percentile over the skin that the camera sees within 50 mm of a landmark.
  double uncertainty_mm = 0;
};

/// How many landmarks a camera needs: six, or five when its focal length is known.
int least_landmarks(const CameraOptions& options);

/// The camera with the least squares of the landmarks' distances in the picture: pose and focal
/// length, by Levenberg and Marquardt from poses for seven focal lengths (cv::solvePnP). Without a
/// known focal length a weak belief in a 60 mm lens (by a factor of 1.6) decides what the landmarks
/// leave open: focal length and distance can hardly be told apart in a portrait, and hardly matter.
/// width, height: of the picture, pixels. skin: mm, LPS, on which the landmarks lie.
/// Throws Error(input) naming the landmark: too few (least_landmarks()), a name given twice, a
/// coordinate that is not finite, a place outside the picture, two landmarks at one place (mm or
/// pixels), all of them on a line or on a plane (then the tilt is left to chance), left and right
/// exchanged or the picture mirrored, landmarks on the side that is turned away, residuals above
/// 6 mm RMS, an uncertainty above 8 mm; also for a focal length outside 8..2000 mm.
CameraFit fit_camera(std::span<const PhotoLandmark> landmarks, int width, int height,
                     const SkinSight& skin, const CameraOptions& options = {});

}  // namespace gnathion

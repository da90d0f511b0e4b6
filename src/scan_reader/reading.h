#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scan_stream/scan_stream.h"

namespace gnathion {

/// More than any scanner makes of a head; a file that asks for more is refused before it is built.
inline constexpr std::size_t kMostTriangles = 20'000'000, kMostVertices = 60'000'000;

/// A PLY file, ASCII or binary of either byte order: numbers in full precision, every vertex in
/// order, vertex colours, texture coordinates of corners or vertices, several pictures. Throws
/// ScanFailure.
RawScan read_ply(const std::filesystem::path& file);

/// Any other format, through assimp: by default all vertices of all its meshes in order, each at
/// its place in the scene; where the format or assimp splits every corner, each place once. Throws
/// ScanFailure.
RawScan read_by_assimp(const std::filesystem::path& file);

/// The picture that a scan names, as a path relative to the scan's folder: as it is named, or
/// beside the scan, where another computer's folders are named. Throws ScanFailure when there is
/// none, or it lies outside the folder.
std::string picture_beside(const std::filesystem::path& scan, const std::string& name);

/// Rows for corners that have the same coordinate are made one, in order of first appearance.
void unite_texture_coordinates(RawScan& scan);

/// Vertices at exactly the same place become one, in order of first appearance; triangles that this
/// leaves without area go.
void unite_vertices(RawScan& scan);

/// For what is read piece by piece: triangles with their corners.
class TriangleList {
 public:
  void add(const Eigen::RowVector3i& vertices, const Eigen::RowVector3i& texture, int material);
  /// Throws ScanFailure when there are none.
  void move_into(RawScan& scan);

 private:
  std::vector<int> vertices_, texture_, material_;
};

}  // namespace gnathion

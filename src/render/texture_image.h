#pragma once

#include <filesystem>

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkTexture;

namespace gnathion {

/// A photograph's texture image, as it lies in the file: an EXIF rotation is not applied, because
/// texture coordinates refer to the stored pixels. 8-bit RGB; images wider or higher than 8192
/// pixels are made smaller, since not every driver takes them.
/// For any thread. Throws Error(input) naming the file when it is missing or cannot be read as a
/// picture.
vtkSmartPointer<vtkImageData> read_texture(const std::filesystem::path& path);

/// The image on a surface. For one render window.
vtkSmartPointer<vtkTexture> texture_of(vtkImageData* image);

}  // namespace gnathion

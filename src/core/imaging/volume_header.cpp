#include "imaging/volume_header.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using Fields = std::map<std::string, std::string>;

[[noreturn]] void refuse(const fs::path& path, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ErrorKind::input, path.string(), problem, remedy);
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n\"");
  const auto last = text.find_last_not_of(" \t\r\n\"");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The field's numbers; brackets and commas count as blanks. Refuses anything else than `count`.
template <std::size_t count>
std::array<double, count> numbers(const Fields& fields, const std::string& key,
                                  const fs::path& path) {
  std::string text = fields.at(key);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  std::array<double, count> values{};
  std::string rest;
  for (double& value : values) in >> value;
  const bool read_all = !in.fail();
  if (!read_all || (in >> rest) ||
      !std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
    refuse(path, "field \"" + key + "\" is not " + std::to_string(count) + " numbers: " + text,
           "write the file again as a three-dimensional volume");
  }
  return values;
}

Eigen::Vector3i whole_sizes(const std::array<double, 3>& sizes, const fs::path& path) {
  Eigen::Vector3i dims;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = sizes[static_cast<std::size_t>(axis)];
    if (size != std::floor(size) || size < 2 || size > 65536) {
      refuse(path, "has a size along axis " + std::to_string(axis) + " that no CT has",
             "write the file again with sizes from 2 to 65536");
    }
    dims[axis] = static_cast<int>(size);
  }
  return dims;
}

double millimetres_in(const std::string& unit, const fs::path& path) {
  static const Fields same = {{"millimeter", "mm"}, {"millimeters", "mm"}, {"meter", "m"},
                              {"meters", "m"},      {"centimeter", "cm"},  {"micron", "um"},
                              {"microns", "um"},    {"µm", "um"}};
  const std::string given = lower(trimmed(unit));
  const std::string name = same.contains(given) ? same.at(given) : given;
  if (name == "mm") return 1;
  if (name == "m") return 1000;
  if (name == "cm") return 10;
  if (name == "um") return 1e-3;
  refuse(path, "gives its lengths in \"" + unit + "\"", "write it in mm");
}

Eigen::Matrix4d affine(const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = axes;
  matrix.topRightCorner<3, 1>() = origin;
  return matrix;
}

const std::string* first_of(const Fields& fields, std::initializer_list<const char*> keys,
                            std::string* found = nullptr) {
  for (const char* key : keys) {
    const auto it = fields.find(key);
    if (it == fields.end()) continue;
    if (found) *found = key;
    return &it->second;
  }
  return nullptr;
}

bool is_true(const Fields& fields, std::initializer_list<const char*> keys) {
  const std::string* value = first_of(fields, keys);
  return value && (lower(*value) == "true" || *value == "1");
}

/// "key = value" lines up to and with ElementDataFile, after which the data may begin.
Fields meta_fields(const std::string& bytes, const fs::path& path, std::size_t* end) {
  Fields fields;
  std::size_t at = 0;
  while (at < bytes.size() && at < 65536) {
    const std::size_t line_end = bytes.find('\n', at);
    const std::string line = bytes.substr(at, line_end - at);
    const auto equals = line.find('=');
    if (equals == std::string::npos) break;
    const std::string key = trimmed(line.substr(0, equals));
    fields[key] = trimmed(line.substr(equals + 1));
    at = line_end == std::string::npos ? bytes.size() : line_end + 1;
    if (key == "ElementDataFile") {
      *end = at;
      return fields;
    }
  }
  refuse(path, "is no MetaImage: its header has no ElementDataFile", "write the file again");
}

void meta_storage(const Fields& fields, const fs::path& path, std::size_t header_end,
                  VolumeHeader* header) {
  static const std::map<std::string, VoxelType> types = {
      {"MET_CHAR", VoxelType::int8},     {"MET_UCHAR", VoxelType::uint8},
      {"MET_SHORT", VoxelType::int16},   {"MET_USHORT", VoxelType::uint16},
      {"MET_INT", VoxelType::int32},     {"MET_UINT", VoxelType::uint32},
      {"MET_FLOAT", VoxelType::float32}, {"MET_DOUBLE", VoxelType::float64}};
  const auto type = fields.find("ElementType");
  if (type == fields.end() || !types.contains(type->second)) {
    refuse(path,
           "has element type " + (type == fields.end() ? "(none)" : type->second) +
               ", which no CT has",
           "write it as MET_SHORT");
  }
  header->type = types.at(type->second);
  if (fields.contains("BinaryData") && !is_true(fields, {"BinaryData"})) {
    refuse(path, "holds its voxels as text", "write it with BinaryData = True");
  }
  header->big_endian = is_true(fields, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
  header->compressed = is_true(fields, {"CompressedData"});
  const std::string data = fields.at("ElementDataFile");
  if (data == "LOCAL") {
    header->data_offset = static_cast<long long>(header_end);
    return;
  }
  if (data.empty() || data.starts_with("LIST") || data.find('%') != std::string::npos) {
    refuse(path, "spreads its voxels over several files", "write it as one .mha file");
  }
  header->data_file = path.parent_path() / data;
  if (fields.contains("HeaderSize")) {
    header->data_offset = static_cast<long long>(numbers<1>(fields, "HeaderSize", path)[0]);
  }
}

/// "key: value" lines up to a blank line (or the end, for a detached header).
Fields nrrd_fields(const std::string& bytes, const fs::path& path, std::size_t* end) {
  if (!bytes.starts_with("NRRD000")) refuse(path, "is no NRRD file", "write the file again");
  Fields fields;
  std::size_t at = bytes.find('\n');
  while (at != std::string::npos && at + 1 < bytes.size() && at < 1048576) {
    const std::size_t begin = at + 1;
    at = bytes.find('\n', begin);
    const std::string line = bytes.substr(begin, at == std::string::npos ? at : at - begin);
    if (trimmed(line).empty()) {
      *end = at == std::string::npos ? bytes.size() : at + 1;
      return fields;
    }
    const auto colon = line.find(": ");
    if (line[0] == '#' || colon == std::string::npos) continue;
    fields[lower(trimmed(line.substr(0, colon)))] = trimmed(line.substr(colon + 2));
  }
  *end = bytes.size();
  return fields;
}

void nrrd_storage(const Fields& fields, const fs::path& path, std::size_t header_end,
                  VolumeHeader* header) {
  static const std::map<std::string, VoxelType> types = {{"signed char", VoxelType::int8},
                                                         {"int8", VoxelType::int8},
                                                         {"int8_t", VoxelType::int8},
                                                         {"uchar", VoxelType::uint8},
                                                         {"unsigned char", VoxelType::uint8},
                                                         {"uint8", VoxelType::uint8},
                                                         {"uint8_t", VoxelType::uint8},
                                                         {"short", VoxelType::int16},
                                                         {"short int", VoxelType::int16},
                                                         {"signed short", VoxelType::int16},
                                                         {"signed short int", VoxelType::int16},
                                                         {"int16", VoxelType::int16},
                                                         {"int16_t", VoxelType::int16},
                                                         {"ushort", VoxelType::uint16},
                                                         {"unsigned short", VoxelType::uint16},
                                                         {"unsigned short int", VoxelType::uint16},
                                                         {"uint16", VoxelType::uint16},
                                                         {"uint16_t", VoxelType::uint16},
                                                         {"int", VoxelType::int32},
                                                         {"signed int", VoxelType::int32},
                                                         {"int32", VoxelType::int32},
                                                         {"int32_t", VoxelType::int32},
                                                         {"uint", VoxelType::uint32},
                                                         {"unsigned int", VoxelType::uint32},
                                                         {"uint32", VoxelType::uint32},
                                                         {"uint32_t", VoxelType::uint32},
                                                         {"float", VoxelType::float32},
                                                         {"double", VoxelType::float64}};
  const std::string type = lower(fields.at("type"));
  if (!types.contains(type)) refuse(path, "has type " + type + ", which no CT has", "write short");
  header->type = types.at(type);
  const std::string encoding = lower(fields.at("encoding"));
  header->compressed = encoding == "gzip" || encoding == "gz";
  if (!header->compressed && encoding != "raw") {
    refuse(path, "has encoding " + encoding, "write it with encoding raw or gzip");
  }
  if (byte_size(header->type) > 1) {
    const std::string endian = fields.contains("endian") ? lower(fields.at("endian")) : "(none)";
    if (endian != "little" && endian != "big") {
      refuse(path, "has endian " + endian, "write it with endian little or big");
    }
    header->big_endian = endian == "big";
  }
  if (fields.contains("line skip") && numbers<1>(fields, "line skip", path)[0] != 0) {
    refuse(path, "skips lines before its data", "write it as one .nrrd file");
  }
  const double skip = fields.contains("byte skip") ? numbers<1>(fields, "byte skip", path)[0] : 0;
  const std::string* data = first_of(fields, {"data file", "datafile"});
  if (data && (data->starts_with("LIST") || data->find('%') != std::string::npos)) {
    refuse(path, "spreads its voxels over several files", "write it as one .nrrd file");
  }
  if (data) header->data_file = path.parent_path() / *data;
  header->data_offset =
      skip < 0 ? -1
               : static_cast<long long>(skip) + (data ? 0 : static_cast<long long>(header_end));
}

/// The signs that turn the named space into LPS.
Eigen::Vector3d lps_signs(const Fields& fields, const fs::path& path) {
  const std::string space = fields.contains("space") ? lower(fields.at("space")) : "(none)";
  if (space == "left-posterior-superior" || space == "lps") return {1, 1, 1};
  if (space == "right-anterior-superior" || space == "ras") return {-1, -1, 1};
  if (space == "left-anterior-superior" || space == "las") return {1, -1, 1};
  refuse(path, "has space " + space + ", so left and right are not known",
         "write it with space left-posterior-superior or right-anterior-superior");
}

double nrrd_unit(const Fields& fields, const fs::path& path) {
  if (!fields.contains("space units")) return 1;  // the format's custom for medical images: mm
  std::string text = fields.at("space units");
  text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
  std::istringstream in(text);
  std::string first, other;
  in >> first;
  while (in >> other) {
    if (other != first) refuse(path, "gives its axes in different units: " + text, "write mm");
  }
  return millimetres_in(first, path);
}

/// Reads little- or big-endian values from NIfTI's fixed header.
class NiftiBytes {
 public:
  NiftiBytes(const std::string& bytes, bool swap) : bytes_(bytes), swap_(swap) {}
  template <typename T>
  T get(std::size_t at) const {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes_.data() + at, sizeof(T));
    if (swap_) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
  }

 private:
  const std::string& bytes_;
  bool swap_;
};

/// RAS from ijk in the file's unit: sform, else qform (nifti1.h, methods 3 and 2).
Eigen::Matrix4d nifti_place(const NiftiBytes& in, const fs::path& path) {
  Eigen::Matrix4d ras = Eigen::Matrix4d::Identity();
  if (in.get<std::int16_t>(254) > 0) {
    for (int row = 0; row < 3; ++row) {
      for (int col = 0; col < 4; ++col) {
        ras(row, col) = in.get<float>(static_cast<std::size_t>(280 + 16 * row + 4 * col));
      }
    }
    return ras;
  }
  if (in.get<std::int16_t>(252) <= 0) {
    refuse(path, "has neither sform nor qform, so left and right are not known",
           "write it with its orientation");
  }
  const double b = in.get<float>(256), c = in.get<float>(260), d = in.get<float>(264);
  const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
  const Eigen::Matrix3d rotation = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix();
  const double flip = in.get<float>(76) < 0 ? -1 : 1;
  const Eigen::Vector3d steps(in.get<float>(80), in.get<float>(84), flip * in.get<float>(88));
  ras.topLeftCorner<3, 3>() = rotation * steps.asDiagonal();
  ras.topRightCorner<3, 1>() =
      Eigen::Vector3d(in.get<float>(268), in.get<float>(272), in.get<float>(276));
  return ras;
}

double nifti_unit(const NiftiBytes& in, const fs::path& path, Progress& progress) {
  switch (in.get<char>(123) & 7) {
    case 1:
      return 1000;
    case 2:
      return 1;
    case 3:
      return 1e-3;
    default:
      progress.notice(path.string() + " names no unit of length: mm are assumed");
      return 1;
  }
}

VoxelType nifti_type(int code, const fs::path& path) {
  static const std::map<int, VoxelType> types = {
      {2, VoxelType::uint8},    {4, VoxelType::int16},    {8, VoxelType::int32},
      {16, VoxelType::float32}, {64, VoxelType::float64}, {256, VoxelType::int8},
      {512, VoxelType::uint16}, {768, VoxelType::uint32}};
  if (!types.contains(code)) {
    refuse(path, "has datatype " + std::to_string(code) + ", which no CT has",
           "write it as 16-bit signed integers");
  }
  return types.at(code);
}

}  // namespace

int byte_size(VoxelType type) {
  switch (type) {
    case VoxelType::int8:
    case VoxelType::uint8:
      return 1;
    case VoxelType::int16:
    case VoxelType::uint16:
      return 2;
    case VoxelType::int32:
    case VoxelType::uint32:
    case VoxelType::float32:
      return 4;
    case VoxelType::float64:
      break;
  }
  return 8;
}

VolumeHeader parse_meta_image(const std::string& bytes, const fs::path& path, Progress& progress) {
  std::size_t end = 0;
  const Fields fields = meta_fields(bytes, path, &end);
  for (const char* key : {"NDims", "DimSize", "ElementType"}) {
    if (!fields.contains(key)) {
      refuse(path, std::string("has no field ") + key, "write the file again");
    }
  }
  if (fields.at("NDims") != "3" ||
      (fields.contains("ElementNumberOfChannels") && fields.at("ElementNumberOfChannels") != "1")) {
    refuse(path, "is not a three-dimensional volume of single values",
           "write one volume of HU, no vectors and no time series");
  }
  VolumeHeader header;
  header.dims = whole_sizes(numbers<3>(fields, "DimSize", path), path);
  meta_storage(fields, path, end, &header);

  std::string key;
  if (!first_of(fields, {"ElementSpacing", "ElementSize"}, &key)) {
    refuse(path, "has no ElementSpacing", "write it with the voxel size in mm");
  }
  const auto spacing = numbers<3>(fields, key, path);
  // The first three numbers are the direction of the first axis: columns, one after the other.
  std::array<double, 9> direction = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  if (first_of(fields, {"TransformMatrix", "Rotation", "Orientation"}, &key)) {
    direction = numbers<9>(fields, key, path);
  }
  std::array<double, 3> origin = {0, 0, 0};
  if (first_of(fields, {"Offset", "Position", "Origin"}, &key)) {
    origin = numbers<3>(fields, key, path);
  } else {
    progress.notice(path.string() + " has no Offset: its first voxel is put at (0, 0, 0)");
  }
  const std::string* unit = first_of(fields, {"DistanceUnits"});
  const double mm = unit && *unit != "?" ? millimetres_in(*unit, path) : 1;
  const Eigen::Matrix3d axes = Eigen::Map<const Eigen::Matrix3d>(direction.data()) *
                               Eigen::Map<const Eigen::Vector3d>(spacing.data()).asDiagonal();
  header.lps_from_ijk = affine(mm * axes, mm * Eigen::Map<const Eigen::Vector3d>(origin.data()));
  return header;
}

VolumeHeader parse_nrrd(const std::string& bytes, const fs::path& path, Progress&) {
  std::size_t end = 0;
  const Fields fields = nrrd_fields(bytes, path, &end);
  for (const char* key :
       {"type", "dimension", "sizes", "encoding", "space directions", "space origin"}) {
    if (!fields.contains(key)) {
      refuse(path, std::string("has no field \"") + key + "\"",
             "write it with its place in the patient, for instance from 3D Slicer");
    }
  }
  if (fields.at("dimension") != "3") {
    refuse(path, "has dimension " + fields.at("dimension"), "write one three-dimensional volume");
  }
  VolumeHeader header;
  header.dims = whole_sizes(numbers<3>(fields, "sizes", path), path);
  nrrd_storage(fields, path, end, &header);
  const auto directions = numbers<9>(fields, "space directions", path);
  const auto origin = numbers<3>(fields, "space origin", path);
  const Eigen::Vector3d signs = lps_signs(fields, path);
  const double mm = nrrd_unit(fields, path);
  const Eigen::Matrix3d axes =
      mm * signs.asDiagonal() * Eigen::Map<const Eigen::Matrix3d>(directions.data());
  header.lps_from_ijk =
      affine(axes, mm * signs.asDiagonal() * Eigen::Map<const Eigen::Vector3d>(origin.data()));
  return header;
}

VolumeHeader parse_nifti(const std::string& bytes, const fs::path& path, Progress& progress) {
  if (bytes.size() < 348) refuse(path, "is cut short inside its header", "copy the file again");
  const std::int32_t size = NiftiBytes(bytes, false).get<std::int32_t>(0);
  const std::int32_t swapped = NiftiBytes(bytes, true).get<std::int32_t>(0);
  if (size == 540 || swapped == 540) {
    refuse(path, "is NIfTI-2", "write it as NIfTI-1 (.nii or .nii.gz)");
  }
  if ((size != 348 && swapped != 348) || bytes.compare(344, 3, "n+1") != 0) {
    refuse(path, "is no single-file NIfTI-1 volume", "write it as .nii or .nii.gz");
  }
  const NiftiBytes in(bytes, size != 348);
  VolumeHeader header;
  const int axes = in.get<std::int16_t>(40);
  bool is_volume = axes >= 3 && axes <= 7;
  for (int axis = 4; is_volume && axis <= axes; ++axis) {
    is_volume = in.get<std::int16_t>(static_cast<std::size_t>(40 + 2 * axis)) == 1;
  }
  if (!is_volume) refuse(path, "is not three-dimensional", "write one three-dimensional volume");
  header.dims = whole_sizes(
      {static_cast<double>(in.get<std::int16_t>(42)), static_cast<double>(in.get<std::int16_t>(44)),
       static_cast<double>(in.get<std::int16_t>(46))},
      path);
  header.type = nifti_type(in.get<std::int16_t>(70), path);
  header.big_endian = (size != 348) == (std::endian::native == std::endian::little);
  header.data_offset = static_cast<long long>(in.get<float>(108));
  if (header.data_offset < 348) refuse(path, "has a wrong vox_offset", "write the file again");
  const double slope = in.get<float>(112), intercept = in.get<float>(116);
  if (slope != 0 && std::isfinite(slope) && std::isfinite(intercept)) {
    header.slope = slope;  // 0 means: not scaled
    header.intercept = intercept;
  }
  Eigen::Matrix4d ras = nifti_place(in, path);
  ras.topRows<3>() *= nifti_unit(in, path, progress);
  header.lps_from_ijk = Eigen::Vector4d(-1, -1, 1, 1).asDiagonal() * ras;
  return header;
}

}  // namespace gnathion

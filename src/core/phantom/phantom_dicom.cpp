#include <gdcmWriter.h>

#include <cstdio>
#include <initializer_list>

#include "base/error.h"
#include "phantom/phantom_ct.h"
#include "phantom/repeatable_random.h"

namespace gnathion {

namespace {

constexpr const char* ct_image_storage = "1.2.840.10008.5.1.4.1.1.2";
constexpr int intercept = -1024;

/// An identifier under 2.25, the root that needs no registration, so that it can belong to no
/// hospital. `kind` and `index` tell the identifiers of one seed apart.
std::string made_up_uid(unsigned seed, int kind, int index) {
  const std::uint64_t key = mixed(mixed(seed + 0x676e617468ULL) + static_cast<unsigned>(kind)) +
                            static_cast<std::uint64_t>(index);
  return "2.25." + std::to_string(mixed(key) | 1ULL << 63);
}

/// One element whose value is text; DICOM pads to an even length.
void put(gdcm::DataSet& data, std::uint16_t group, std::uint16_t element, gdcm::VR::VRType vr,
         std::string text) {
  if (text.size() % 2 == 1) {
    text += vr == gdcm::VR::UI ? '\0' : ' ';
  }
  gdcm::DataElement item(gdcm::Tag(group, element));
  item.SetVR(vr);
  item.SetByteValue(text.data(), static_cast<std::uint32_t>(text.size()));
  data.Replace(item);
}

/// Decimal strings; 10 digits fit DICOM's 16 characters.
void put_decimals(gdcm::DataSet& data, std::uint16_t group, std::uint16_t element,
                  std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    char number[32];
    std::snprintf(number, sizeof number, "%.10g", value);
    if (!text.empty()) {
      text += '\\';
    }
    text += number;
  }
  put(data, group, element, gdcm::VR::DS, text);
}

void put_short(gdcm::DataSet& data, std::uint16_t group, std::uint16_t element, int value) {
  const char bytes[2] = {static_cast<char>(value & 0xff), static_cast<char>(value >> 8)};
  gdcm::DataElement item(gdcm::Tag(group, element));
  item.SetVR(gdcm::VR::US);
  item.SetByteValue(bytes, 2);
  data.Replace(item);
}

void put_identity(gdcm::DataSet& data, unsigned seed, int k) {
  put(data, 0x0008, 0x0008, gdcm::VR::CS, R"(ORIGINAL\PRIMARY\AXIAL)");
  put(data, 0x0008, 0x0016, gdcm::VR::UI, ct_image_storage);
  put(data, 0x0008, 0x0018, gdcm::VR::UI, made_up_uid(seed, 0, k));
  put(data, 0x0008, 0x0020, gdcm::VR::DA, "20000101");
  put(data, 0x0008, 0x0030, gdcm::VR::TM, "000000");
  put(data, 0x0008, 0x0050, gdcm::VR::SH, "");
  put(data, 0x0008, 0x0060, gdcm::VR::CS, "CT");
  put(data, 0x0008, 0x0070, gdcm::VR::LO, "GNATHION");
  put(data, 0x0008, 0x0090, gdcm::VR::PN, "");
  put(data, 0x0008, 0x103e, gdcm::VR::LO, "Synthetic head, not a patient");
  put(data, 0x0010, 0x0010, gdcm::VR::PN, "GNATHION^SYNTHETIC");
  put(data, 0x0010, 0x0020, gdcm::VR::LO, "GNATHION-PHANTOM-" + std::to_string(seed));
  put(data, 0x0010, 0x0030, gdcm::VR::DA, "20000101");
  put(data, 0x0010, 0x0040, gdcm::VR::CS, "O");
  put(data, 0x0018, 0x5100, gdcm::VR::CS, "HFS");
  put(data, 0x0020, 0x000d, gdcm::VR::UI, made_up_uid(seed, 1, 0));
  put(data, 0x0020, 0x000e, gdcm::VR::UI, made_up_uid(seed, 2, 0));
  put(data, 0x0020, 0x0010, gdcm::VR::SH, "1");
  put(data, 0x0020, 0x0011, gdcm::VR::IS, "1");
  put(data, 0x0020, 0x0013, gdcm::VR::IS, std::to_string(k + 1));
  put(data, 0x0020, 0x0052, gdcm::VR::UI, made_up_uid(seed, 3, 0));
}

void put_geometry(gdcm::DataSet& data, const PhantomVolume& volume, int k) {
  const double z = volume.origin.z() + k * volume.spacing.z();
  put_decimals(data, 0x0018, 0x0050, {volume.spacing.z()});
  put_decimals(data, 0x0020, 0x0032, {volume.origin.x(), volume.origin.y(), z});
  put_decimals(data, 0x0020, 0x0037, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0});
  put_decimals(data, 0x0020, 0x1041, {z});
  put_decimals(data, 0x0028, 0x0030, {volume.spacing.y(), volume.spacing.x()});
}

void put_pixels(gdcm::DataSet& data, const PhantomVolume& volume, int k) {
  put_short(data, 0x0028, 0x0002, 1);
  put(data, 0x0028, 0x0004, gdcm::VR::CS, "MONOCHROME2");
  put_short(data, 0x0028, 0x0010, volume.size.y());
  put_short(data, 0x0028, 0x0011, volume.size.x());
  put_short(data, 0x0028, 0x0100, 16);
  put_short(data, 0x0028, 0x0101, 12);
  put_short(data, 0x0028, 0x0102, 11);
  put_short(data, 0x0028, 0x0103, 0);
  put_decimals(data, 0x0028, 0x1050, {40.0});
  put_decimals(data, 0x0028, 0x1051, {400.0});
  put_decimals(data, 0x0028, 0x1052, {1.0 * intercept});
  put_decimals(data, 0x0028, 0x1053, {1.0});
  put(data, 0x0028, 0x1054, gdcm::VR::LO, "HU");
  const std::size_t count = static_cast<std::size_t>(volume.size.x()) * volume.size.y();
  std::vector<char> bytes(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const int stored = volume.hounsfield[k * count + i] - intercept;
    bytes[2 * i] = static_cast<char>(stored & 0xff);
    bytes[2 * i + 1] = static_cast<char>(stored >> 8);
  }
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetVR(gdcm::VR::OW);
  pixels.SetByteValue(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  data.Replace(pixels);
}

}  // namespace

void write_phantom_dicom(const PhantomVolume& volume, const std::filesystem::path& folder,
                         unsigned seed, Progress& progress) {
  const auto stage = progress.stage("phantom DICOM");
  for (int k = 0; k < volume.size.z(); ++k) {
    progress.check();
    char name[32];
    std::snprintf(name, sizeof name, "slice_%03d.dcm", k);
    gdcm::Writer writer;
    gdcm::File& file = writer.GetFile();
    file.GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
    put_identity(file.GetDataSet(), seed, k);
    put_geometry(file.GetDataSet(), volume, k);
    put_pixels(file.GetDataSet(), volume, k);
    const std::string path = (folder / name).string();
    writer.SetFileName(path.c_str());
    if (!writer.Write()) {
      throw Error(ErrorKind::output, path, "the slice could not be written",
                  "free some space or choose a folder that can be written");
    }
  }
}

}  // namespace gnathion

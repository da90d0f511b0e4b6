#include "scan_stream/scan_stream.h"

#include <cstring>

#include "base/error.h"

namespace gnathion {
namespace {

constexpr std::string_view kMagic = "GNSCAN1\n", kEnd = "THE END\n";

class Writer {
 public:
  explicit Writer(char kind) : bytes_(kMagic) { bytes_ += kind; }
  template <typename T>
  void number(T value) {
    append(&value, sizeof value);
  }
  void text(const std::string& text) {
    number<std::uint64_t>(text.size());
    bytes_ += text;
  }
  template <typename Matrix>
  void matrix(const Matrix& rows) {
    number<std::uint64_t>(static_cast<std::uint64_t>(rows.rows()));
    append(rows.data(), static_cast<std::size_t>(rows.size()) * sizeof *rows.data());
  }
  std::string done() { return std::move(bytes_ += kEnd); }

 private:
  void append(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(ErrorKind::input, name_, "what was read of it does not hold together: " + what,
                "the file is damaged: export the scan again");
  }
  void expect(std::string_view words) {
    if (take(words.size()) != words) refuse("it ends too early");
  }
  template <typename T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  /// A count of things of so many bytes each, all of which are there.
  std::size_t count(std::size_t bytes_each) {
    const auto count = number<std::uint64_t>();
    if (count > rest_.size() / bytes_each) refuse("it ends too early");
    return count;
  }
  /// Of things that a scan has few of, so that making room for them costs nothing.
  std::size_t few() {
    const auto count = number<std::uint64_t>();
    if (count > 65536) refuse("it has too many parts");
    return count;
  }
  std::string text() {
    const std::size_t size = count(1);
    return std::string(take(size));
  }
  template <typename Matrix>
  Matrix matrix() {
    using T = typename Matrix::Scalar;
    constexpr std::size_t kColumns = Matrix::ColsAtCompileTime;
    const std::size_t rows = count(kColumns * sizeof(T));
    if (rows > (1U << 30U)) refuse("it is too large");
    Matrix matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(kColumns));
    const std::string_view bytes = take(rows * kColumns * sizeof(T));
    if (rows > 0) std::memcpy(matrix.data(), bytes.data(), bytes.size());
    return matrix;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) refuse("it ends too early");
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  std::string_view rest_;
  const std::string& name_;
};

using Column = Eigen::Matrix<int, Eigen::Dynamic, 1>;

template <typename Matrix>
void check_rows(const Matrix& indices, int least, Eigen::Index rows, const char* what,
                const Reader& reader) {
  if (indices.size() == 0) return;
  if (indices.minCoeff() < least || indices.maxCoeff() >= rows) {
    reader.refuse(std::string("an index of ") + what + " is out of range");
  }
}

void check(const RawScan& scan, const Reader& reader) {
  const Eigen::Index faces = scan.surface.triangles.rows();
  if (!scan.surface.vertices.allFinite()) reader.refuse("a coordinate is not a finite number");
  if (!scan.texture_coordinates.allFinite()) {
    reader.refuse("a texture coordinate is not a finite number");
  }
  if (!scan.colours.allFinite()) reader.refuse("a colour is not a finite number");
  if (scan.colours.rows() != 0 && scan.colours.rows() != scan.surface.vertices.rows()) {
    reader.refuse("colours and vertices differ in number");
  }
  if (scan.corner_texture.rows() != faces || scan.material.size() != std::size_t(faces)) {
    reader.refuse("triangles and their corners differ in number");
  }
  check_rows(scan.surface.triangles, 0, scan.surface.vertices.rows(), "a vertex", reader);
  check_rows(scan.corner_texture, -1, scan.texture_coordinates.rows(), "a texture coordinate",
             reader);
  check_rows(Eigen::Map<const Column>(scan.material.data(), faces), -1,
             static_cast<Eigen::Index>(scan.materials.size()), "a material", reader);
  for (const ScanMaterial& material : scan.materials) {
    if (material.texture < -1 || material.texture >= static_cast<int>(scan.textures.size())) {
      reader.refuse("an index of a picture is out of range");
    }
    if (!material.diffuse.allFinite()) reader.refuse("a colour is not a finite number");
  }
}

RawScan read_scan_part(Reader& reader) {
  RawScan scan;
  scan.surface.vertices = reader.matrix<Points>();
  scan.colours = reader.matrix<Points>();
  scan.texture_coordinates = reader.matrix<decltype(scan.texture_coordinates)>();
  scan.surface.triangles = reader.matrix<Triangles>();
  scan.corner_texture = reader.matrix<Triangles>();
  const auto material = reader.matrix<Column>();
  scan.material.assign(material.data(), material.data() + material.size());
  scan.materials.resize(reader.few());
  for (ScanMaterial& m : scan.materials) {
    m.name = reader.text();
    for (double& channel : m.diffuse) channel = reader.number<double>();
    m.texture = reader.number<int>();
  }
  scan.textures.resize(reader.few());
  for (ScanTexture& texture : scan.textures) {
    texture.name = reader.text();
    texture.inside = reader.number<char>() != 0;
    texture.bytes = reader.text();
  }
  scan.notices.resize(reader.few());
  for (std::string& notice : scan.notices) notice = reader.text();
  return scan;
}

}  // namespace

std::string scan_bytes(const RawScan& scan) {
  Writer out('S');
  out.matrix(scan.surface.vertices);
  out.matrix(scan.colours);
  out.matrix(scan.texture_coordinates);
  out.matrix(scan.surface.triangles);
  out.matrix(scan.corner_texture);
  out.matrix(Eigen::Map<const Column>(scan.material.data(),
                                      static_cast<Eigen::Index>(scan.material.size())));
  out.number<std::uint64_t>(scan.materials.size());
  for (const ScanMaterial& material : scan.materials) {
    out.text(material.name);
    for (const double channel : material.diffuse) out.number(channel);
    out.number(material.texture);
  }
  out.number<std::uint64_t>(scan.textures.size());
  for (const ScanTexture& texture : scan.textures) {
    out.text(texture.name);
    out.number<char>(texture.inside ? 1 : 0);
    out.text(texture.bytes);
  }
  out.number<std::uint64_t>(scan.notices.size());
  for (const std::string& notice : scan.notices) out.text(notice);
  return out.done();
}

std::string scan_bytes(const ScanFailure& failure) {
  Writer out('F');
  out.text(failure.subject);
  out.text(failure.problem);
  out.text(failure.remedy);
  return out.done();
}

std::variant<RawScan, ScanFailure> scan_of_bytes(std::string_view bytes, const std::string& name) {
  Reader reader(bytes, name);
  reader.expect(kMagic);
  std::variant<RawScan, ScanFailure> result;
  const char kind = reader.number<char>();
  if (kind == 'F') {
    ScanFailure failure;
    failure.subject = reader.text();
    failure.problem = reader.text();
    failure.remedy = reader.text();
    result = std::move(failure);
  } else if (kind == 'S') {
    RawScan scan = read_scan_part(reader);
    check(scan, reader);
    result = std::move(scan);
  } else {
    reader.refuse("its kind is unknown");
  }
  reader.expect(kEnd);
  if (!reader.at_end()) reader.refuse("something follows its end");
  return result;
}

}  // namespace gnathion

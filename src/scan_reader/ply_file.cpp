#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

#include "scan_reader/reading.h"

// PLY as Greg Turk's description of 1994 has it, with the customs that have grown since: `comment
// TextureFile`, lists of texture coordinates a face (MeshLab), s t or u v of a vertex.

namespace gnathion {
namespace {

[[noreturn]] void fail(const std::string& problem,
                       const std::string& remedy = "the file is damaged: export the scan again") {
  throw ScanFailure{"", problem, remedy};
}

enum class Kind { i8, u8, i16, u16, i32, u32, f32, f64 };

Kind kind_of(const std::string& word) {
  static const std::map<std::string, Kind> kinds{
      {"char", Kind::i8},   {"int8", Kind::i8},     {"uchar", Kind::u8},   {"uint8", Kind::u8},
      {"short", Kind::i16}, {"int16", Kind::i16},   {"ushort", Kind::u16}, {"uint16", Kind::u16},
      {"int", Kind::i32},   {"int32", Kind::i32},   {"uint", Kind::u32},   {"uint32", Kind::u32},
      {"float", Kind::f32}, {"float32", Kind::f32}, {"double", Kind::f64}, {"float64", Kind::f64}};
  const auto found = kinds.find(word);
  if (found == kinds.end()) fail("its header names a kind of number \"" + word + "\"");
  return found->second;
}

std::size_t size_of(Kind kind) {
  switch (kind) {
    case Kind::i8:
    case Kind::u8:
      return 1;
    case Kind::i16:
    case Kind::u16:
      return 2;
    case Kind::i32:
    case Kind::u32:
    case Kind::f32:
      return 4;
    case Kind::f64:
      return 8;
  }
  return 8;
}

struct Property {
  std::string name;
  Kind kind = Kind::f32;
  std::optional<Kind> count;  ///< of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  int find(std::initializer_list<const char*> names) const {
    for (const char* wanted : names) {
      for (std::size_t p = 0; p < properties.size(); ++p) {
        if (properties[p].name == wanted) return static_cast<int>(p);
      }
    }
    return -1;
  }
};

enum class Coding { ascii, little, big };

struct Header {
  Coding coding = Coding::ascii;
  std::vector<Element> elements;
  std::vector<std::string> pictures;
  std::size_t end = 0;  ///< where the data begin
};

Coding coding_of(const std::string& word) {
  if (word == "ascii") return Coding::ascii;
  if (word == "binary_little_endian") return Coding::little;
  if (word == "binary_big_endian") return Coding::big;
  fail("its format \"" + word + "\" is unknown");
}

/// words: behind "element", line: whole.
Element read_element(std::istringstream& words, const std::string& line) {
  Element element;
  std::string count;
  if (!(words >> element.name >> count) || count.front() == '-') {
    fail("its header is damaged at \"" + line + "\"");
  }
  const char* end = count.data() + count.size();
  const auto [rest, status] = std::from_chars(count.data(), end, element.count);
  if (status != std::errc() || rest != end) {
    fail("its header gives no number of things at \"" + line + "\"");
  }
  return element;
}

/// words: behind "property", line: whole.
Property read_property(std::istringstream& words, const std::string& line) {
  Property property;
  std::string kind;
  words >> kind;
  if (kind == "list") {
    words >> kind;
    property.count = kind_of(kind);
    words >> kind;
  }
  property.kind = kind_of(kind);
  if (!(words >> property.name)) fail("its header is damaged at \"" + line + "\"");
  return property;
}

void read_header_line(const std::string& line, Header& header) {
  std::istringstream words(line);
  std::string word, second;
  words >> word;
  if (word == "format") {
    words >> second;
    header.coding = coding_of(second);
  } else if (word == "comment" && words >> second && second == "TextureFile") {
    std::string picture;
    std::getline(words >> std::ws, picture);
    header.pictures.push_back(picture);
  } else if (word == "element") {
    header.elements.push_back(read_element(words, line));
  } else if (word == "property") {
    if (header.elements.empty()) fail("its header names a property before any element");
    header.elements.back().properties.push_back(read_property(words, line));
  }
}

Header read_header(const std::string& text) {
  if (text.compare(0, 3, "ply") != 0) {
    fail("it does not begin as a PLY file", "choose a PLY file, or name the file as what it is");
  }
  Header header;
  std::size_t at = 0;
  while (true) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos || end > 100'000) fail("its header has no end");
    std::string line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    at = end + 1;
    if (line == "end_header") break;
    if (line.size() > 4096 || header.elements.size() > 100) fail("its header is too long");
    read_header_line(line, header);
  }
  header.end = at;
  return header;
}

/// The numbers behind the header, one after the other.
class Numbers {
 public:
  Numbers(const std::string& text, std::size_t begin, Coding coding)
      : at_(text.data() + begin), end_(text.data() + text.size()), coding_(coding) {}

  std::uint64_t bytes_left() const { return static_cast<std::uint64_t>(end_ - at_); }
  bool is_ascii() const { return coding_ == Coding::ascii; }

  double next(Kind kind) { return is_ascii() ? word() : binary(kind); }

 private:
  double word() {
    while (at_ < end_ && std::string_view(" \t\r\n").find(*at_) != std::string_view::npos) ++at_;
    if (at_ < end_ && *at_ == '+') ++at_;
    double value = 0;
    const auto [rest, status] = std::from_chars(at_, end_, value);
    if (at_ == end_) fail("it ends before all that its header promises");
    if (status != std::errc()) fail("a number of it cannot be read");
    at_ = rest;
    return value;
  }
  double binary(Kind kind) {
    const std::size_t size = size_of(kind);
    if (bytes_left() < size) fail("it ends before all that its header promises");
    std::uint64_t bits = 0;  // the value's bytes, the lowest first
    for (std::size_t i = 0; i < size; ++i) {
      const auto byte = static_cast<unsigned char>(at_[coding_ == Coding::big ? size - 1 - i : i]);
      bits |= static_cast<std::uint64_t>(byte) << (8 * i);
    }
    at_ += size;
    switch (kind) {
      case Kind::i8:
        return static_cast<std::int8_t>(bits);
      case Kind::u8:
        return static_cast<double>(bits);
      case Kind::i16:
        return static_cast<std::int16_t>(bits);
      case Kind::u16:
        return static_cast<double>(bits);
      case Kind::i32:
        return static_cast<std::int32_t>(bits);
      case Kind::u32:
        return static_cast<double>(bits);
      case Kind::f32:
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
      case Kind::f64:
        return std::bit_cast<double>(bits);
    }
    return 0;
  }

  const char *at_, *end_;
  Coding coding_;
};

/// One element's values: a number, or the numbers of a list, for each property.
using Row = std::vector<std::vector<double>>;

void read_row(const Element& element, Numbers& numbers, Row& row) {
  row.resize(element.properties.size());
  for (std::size_t p = 0; p < row.size(); ++p) {
    const Property& property = element.properties[p];
    row[p].clear();
    double count = 1;
    if (property.count) count = numbers.next(*property.count);
    if (!(count >= 0 && count <= static_cast<double>(numbers.bytes_left()))) {
      fail("a list of it is longer than the file");
    }
    for (int i = 0; i < count; ++i) row[p].push_back(numbers.next(property.kind));
  }
}

/// Before room is made for them.
void check_count(const Element& element, const Numbers& numbers) {
  std::uint64_t least = 0;  // bytes of one
  for (const Property& p : element.properties) {
    least += numbers.is_ascii() ? 2 : size_of(p.count ? *p.count : p.kind);
  }
  if (least == 0 && element.count > 0) fail("its " + element.name + " has no properties");
  // The last number of an ASCII file needs no blank behind it.
  if (element.count > 0 && element.count > (numbers.bytes_left() + 1) / least) {
    fail("its header promises " + std::to_string(element.count) + " of \"" + element.name +
         "\", but the file ends before");
  }
}

double full_scale(Kind kind) {
  return kind == Kind::u8 ? 255 : kind == Kind::u16 ? 65535 : 1;
}

void read_vertices(const Element& element, Numbers& numbers, RawScan& scan, bool& has_texture) {
  const std::array<int, 3> place{element.find({"x"}), element.find({"y"}), element.find({"z"})};
  const std::array<int, 3> colour{element.find({"red", "diffuse_red", "r"}),
                                  element.find({"green", "diffuse_green", "g"}),
                                  element.find({"blue", "diffuse_blue", "b"})};
  const std::array<int, 2> texture{element.find({"s", "u", "texture_u"}),
                                   element.find({"t", "v", "texture_v"})};
  if (place[0] < 0 || place[1] < 0 || place[2] < 0) fail("its vertices have no x, y and z");
  for (const Property& p : element.properties) {
    if (p.count) fail("a vertex has a list \"" + p.name + "\", which is not read");
  }
  const bool coloured = colour[0] >= 0 && colour[1] >= 0 && colour[2] >= 0;
  has_texture = texture[0] >= 0 && texture[1] >= 0;
  const auto count = static_cast<Eigen::Index>(element.count);
  scan.surface.vertices.resize(count, 3);
  if (coloured) scan.colours.resize(count, 3);
  if (has_texture) scan.texture_coordinates.resize(count, 2);
  Row row;
  for (Eigen::Index v = 0; v < count; ++v) {
    read_row(element, numbers, row);
    for (int k = 0; k < 3; ++k) {
      const double x = scan.surface.vertices(v, k) = row[place[k]][0];
      if (!std::isfinite(x)) {
        fail("vertex " + std::to_string(v) + " has a coordinate that is not a finite number");
      }
      if (!coloured) continue;
      scan.colours(v, k) = row[colour[k]][0] / full_scale(element.properties[colour[k]].kind);
    }
    for (int k = 0; k < 2 && has_texture; ++k) {
      scan.texture_coordinates(v, k) = row[texture[k]][0];
    }
  }
}

/// The corners of a polygon's triangles: a quad along its shorter diagonal, more corners as a fan.
std::vector<std::array<int, 3>> triangles_of(const std::vector<int>& corners, const Points& x) {
  const int count = static_cast<int>(corners.size());
  if (count == 4) {
    const double a = (x.row(corners[0]) - x.row(corners[2])).squaredNorm();
    const double b = (x.row(corners[1]) - x.row(corners[3])).squaredNorm();
    if (b < a) return {{0, 1, 3}, {1, 2, 3}};
  }
  std::vector<std::array<int, 3>> fan;
  for (int k = 2; k < count; ++k) fan.push_back({0, k - 1, k});
  return fan;
}

/// Reads faces into triangles.
class FaceReader {
 public:
  FaceReader(const Element& element, RawScan& scan, bool vertex_texture, int pictures)
      : element_(element),
        scan_(scan),
        vertex_texture_(vertex_texture),
        pictures_(pictures),
        corners_at_(element.find({"vertex_indices", "vertex_index"})),
        texture_at_(element.find({"texcoord"})),
        picture_at_(element.find({"texnumber"})) {
    if (corners_at_ < 0) fail("its faces name no vertices");
    if (element.find({"red"}) >= 0) {
      scan.notices.emplace_back("colours of whole faces are not kept, only those of vertices");
    }
  }

  void read(Numbers& numbers, TriangleList& triangles) {
    Row row;
    for (std::uint64_t f = 0; f < element_.count; ++f) {
      read_row(element_, numbers, row);
      add(row, f, triangles);
    }
    if (uv_.empty()) return;
    scan_.texture_coordinates = Eigen::Map<const decltype(scan_.texture_coordinates)>(
        uv_.data(), static_cast<Eigen::Index>(uv_.size() / 2), 2);
  }

 private:
  void add(const Row& row, std::uint64_t f, TriangleList& triangles) {
    std::vector<int> corners;
    for (const double index : row[corners_at_]) {
      if (!(index >= 0 && index < static_cast<double>(scan_.surface.vertices.rows())) ||
          index != std::floor(index)) {
        fail("face " + std::to_string(f) + " names a vertex that does not exist");
      }
      corners.push_back(static_cast<int>(index));
    }
    if (corners.size() < 3) {
      fail("face " + std::to_string(f) + " has fewer than 3 corners");
    }
    const int texture = first_texture(row, f, corners.size());
    int picture = pictures_ > 0 ? 0 : -1;
    if (picture_at_ >= 0 && pictures_ > 0) {
      const double number = row[picture_at_].empty() ? 0 : row[picture_at_][0];
      picture = number >= 0 && number < pictures_ ? static_cast<int>(number) : -1;
    }
    for (const auto& [a, b, c] : triangles_of(corners, scan_.surface.vertices)) {
      const Eigen::RowVector3i v{corners[a], corners[b], corners[c]};
      Eigen::RowVector3i t{-1, -1, -1};
      if (texture >= 0) t = {texture + a, texture + b, texture + c};
      if (texture < 0 && vertex_texture_ && texture_at_ < 0) t = v;
      triangles.add(v, t, picture);
    }
  }

  /// The row of the first of the face's own texture coordinates, −1: none.
  int first_texture(const Row& row, std::uint64_t f, std::size_t corners) {
    if (texture_at_ < 0 || row[texture_at_].empty()) return -1;
    if (row[texture_at_].size() != 2 * corners) {
      fail("face " + std::to_string(f) + " has not two texture coordinates a corner");
    }
    const auto first = static_cast<int>(uv_.size() / 2);
    uv_.insert(uv_.end(), row[texture_at_].begin(), row[texture_at_].end());
    return first;
  }

  const Element& element_;
  RawScan& scan_;
  bool vertex_texture_;
  int pictures_;
  int corners_at_, texture_at_, picture_at_;
  std::vector<double> uv_;
};

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::filesystem::file_size(file), '\0');
  if (!stream.read(text.data(), static_cast<std::streamsize>(text.size()))) {
    fail("the file cannot be read to its end", "check the disk and the file's rights");
  }
  return text;
}

void add_pictures(const std::filesystem::path& file, const Header& header, RawScan& scan) {
  for (const std::string& name : header.pictures) {
    const int row = static_cast<int>(scan.textures.size());
    scan.materials.push_back({"material_" + std::to_string(row), Eigen::Vector3d::Ones(), row});
    scan.textures.push_back({picture_beside(file, name), false, ""});
  }
}

}  // namespace

RawScan read_ply(const std::filesystem::path& file) {
  const std::string text = bytes_of(file);
  const Header header = read_header(text);
  Numbers numbers(text, header.end, header.coding);
  RawScan scan;
  add_pictures(file, header, scan);
  TriangleList triangles;
  bool vertex_texture = false;
  for (const Element& element : header.elements) {
    check_count(element, numbers);
    if (element.name == "vertex") {
      if (element.count > kMostVertices) fail("it has more than 60 million vertices");
      read_vertices(element, numbers, scan, vertex_texture);
    } else if (element.name == "face") {
      FaceReader(element, scan, vertex_texture, static_cast<int>(header.pictures.size()))
          .read(numbers, triangles);
    } else if (element.name == "tristrips") {
      fail("its triangles are in strips, which are not read", "export it with single faces");
    } else {
      Row row;
      for (std::uint64_t i = 0; i < element.count; ++i) read_row(element, numbers, row);
    }
  }
  triangles.move_into(scan);
  unite_texture_coordinates(scan);
  return scan;
}

}  // namespace gnathion

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <functional>

#include "core/scan/scan_files.h"
#include "support/expect_error.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using test::glb;
using test::raw;
using test::SquareGltf;
using test::TemporaryFolder;

/// A file that must be refused by name: what is written, and words of the message.
struct Malformed {
  std::string name;  ///< of the file
  std::string text;
  std::vector<std::string> words;
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("no " + what);
  return text.replace(at, what.size(), by);
}

const std::string kBinaryHead = "ply\nformat binary_little_endian 1.0\n";
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string ascii_ply(const std::string& vertices, const std::string& face) {
  return "ply\nformat ascii 1.0\nelement vertex 3\n" + kXyz + kFace + vertices + face;
}

std::vector<Malformed> of_obj() {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  return {
      {"empty.obj", "", {"empty"}},
      {"no faces.obj", v, {"no faces"}},
      {"index.obj", v + "f 1 2 4\n", {"line 4", "names vertex"}},
      {"zero.obj", v + "f 0 1 2\n", {"line 4"}},
      {"backward.obj", v + "f -1 -2 -9\n", {"line 4"}},
      {"nan.obj", "v 0 0 nan\nf 1 1 1\n", {"line 1", "finite"}},
      {"infinite.obj", "v 0 1e999 0\nf 1 1 1\n", {"line 1", "finite"}},
      {"comma.obj", "v 0,5 0 0\nf 1 1 1\n", {"line 1", "finite"}},
      {"two corners.obj", v + "f 1 2\n", {"fewer than 3"}},
      {"texture.obj", v + "f 1/1 2/1 3/1\n", {"texture coordinate"}},
      {"binary.obj", std::string(4096, '\xff'), {"no vertices"}},
      {"escape.obj", "mtllib ../../../etc/passwd\n" + v + "f 1 2 3\n", {"passwd"}},
      {"missing.obj", "mtllib none of these.mtl\n" + v + "f 1 2 3\n", {"does not exist"}},
      {"folder.obj", "mtllib .\n" + v + "f 1 2 3\n", {"."}},
  };
}

std::vector<Malformed> of_ply() {
  const std::string x = raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string binary = kBinaryHead + "element vertex 3\n" + kXyz + kFace;
  const std::string v = "0 0 0\n1 0 0\n0 1 0\n";
  return {
      {"empty.ply", "", {"empty"}},
      {"magic.ply", "PLYX\n", {"begin as a PLY"}},
      {"no end.ply", "ply\nformat ascii 1.0\n", {"no end"}},
      {"long header.ply", "ply\n" + std::string(3000000, 'a') + "\nend_header\n", {"header"}},
      {"format.ply", "ply\nformat ebcdic 1.0\nend_header\n", {"ebcdic"}},
      {"kind.ply", replaced(ascii_ply(v, ""), "float", "quaternion"), {"quaternion"}},
      {"negative.ply", replaced(ascii_ply(v, ""), "vertex 3", "vertex -3"), {"header"}},
      {"huge.ply", replaced(ascii_ply(v, ""), "vertex 3", "vertex 4000000000"), {"ends before"}},
      {"overflow.ply",
       replaced(ascii_ply(v, ""), "vertex 3", "vertex 99999999999999999999"),
       {"number of things"}},
      {"bomb.ply", replaced(binary, "face 1", "face 18446744073709551615") + x, {"ends before"}},
      {"cut.ply", binary + x.substr(0, 20), {"ends before"}},
      {"cut face.ply", binary + x + "\3" + raw<int>({0, 1}), {"ends before"}},
      {"index.ply", binary + x + "\3" + raw<int>({0, 1, 3}), {"face 0", "does not exist"}},
      {"below zero.ply", binary + x + "\3" + raw<int>({0, 1, -1}), {"face 0", "does not exist"}},
      {"nan.ply",
       replaced(binary, "x", "x") + raw<float>({0, 0, NAN, 1, 0, 0, 0, 1, 0}) + "\3" +
           raw<int>({0, 1, 2}),
       {"vertex 0", "finite"}},
      {"words.ply", ascii_ply("0 0 zero\n1 0 0\n0 1 0\n", "3 0 1 2\n"), {"cannot be read"}},
      {"long list.ply",
       replaced(binary, "list uchar", "list uint") + x + raw<std::uint32_t>({0xfffffff0U}),
       {"longer than the file"}},
      {"no xyz.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float w\nend_header\n1\n",
       {"no x, y and z"}},
      {"points.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\n" + kXyz + "end_header\n" + v,
       {"no faces"}},
      {"edge.ply", ascii_ply(v, "2 0 1\n"), {"fewer than 3"}},
      {"picture.ply",
       replaced(ascii_ply(v, "3 0 1 2\n"), "element", "comment TextureFile a.png\nelement"),
       {"a.png", "does not exist"}},
      {"outside.ply",
       replaced(ascii_ply(v, "3 0 1 2\n"), "element", "comment TextureFile ../a.png\nelement"),
       {"../a.png", "outside"}},
      {"nothing.ply",
       "ply\nformat ascii 1.0\nelement thing 9000000000000000000\nend_header\n",
       {"no properties"}},
  };
}

std::vector<Malformed> of_gltf() {
  const SquareGltf square;
  const std::string good = glb(square.json(), square.bytes());
  const auto with = [&](const std::string& what, const std::string& by) {
    return glb(replaced(square.json(), what, by), square.bytes());
  };
  std::string nan = square.bytes();
  nan.replace(0, 4, raw<float>({NAN}));
  std::string index = square.bytes();
  index.replace(square.positions.size() + square.uv.size() + square.colours.size(), 2,
                raw<std::uint16_t>({60000}));
  SquareGltf no_picture;
  no_picture.image = std::string(300, 'x');
  SquareGltf data_bomb;
  data_bomb.node = R"("mesh":0,"children":[0])";
  std::string nested = std::string(200000, '[') + std::string(200000, ']');
  return {
      {"empty.glb", "", {"empty"}},
      {"magic.glb", replaced(good, "glTF", "JFIF"), {"magic.glb"}},
      {"cut.glb", good.substr(0, good.size() / 2), {"cut.glb"}},
      {"header only.glb", good.substr(0, 12), {"header only.glb"}},
      {"length.glb", std::string(good).replace(12, 4, "\xff\xff\xff\x7f"), {"length.glb"}},
      {"json.glb", glb("{\"asset\":", ""), {"json.glb"}},
      {"nested.gltf", nested, {"nested.gltf"}},
      {"array.gltf", "[]", {"array.gltf"}},
      {"no scene.glb", glb(R"({"asset":{"version":"2.0"}})", ""), {"no scene.glb"}},
      {"count.glb", with(R"("count":6)", R"("count":4000000000)"), {"count.glb"}},
      {"offset.glb", with(R"("byteOffset":0)", R"("byteOffset":99999999)"), {"offset.glb"}},
      {"view.glb", with(R"("bufferView":0)", R"("bufferView":77)"), {"view.glb"}},
      {"negative.glb", with(R"("bufferView":0)", R"("bufferView":-1)"), {"negative.glb"}},
      {"accessor.glb", with(R"("POSITION":0)", R"("POSITION":40)"), {"accessor.glb"}},
      {"mesh.glb", with(R"("mesh":0)", R"("mesh":9)"), {"mesh.glb"}},
      {"nan.glb", glb(square.json(), nan), {"nan.glb"}},
      {"index.glb", glb(square.json(), index), {"index.glb"}},
      {"picture.glb", glb(no_picture.json(), no_picture.bytes()), {"picture", "JPEG"}},
      {"cyclic.glb", glb(data_bomb.json(), data_bomb.bytes()), {"cyclic.glb"}},
      {"missing.gltf", square.json(R"("uri":"nö ne.bin",)"), {"missing.gltf"}},
      {"outside.gltf", square.json(R"("uri":"../../../../../etc/passwd",)"), {"outside.gltf"}},
      {"device.gltf", square.json(R"("uri":"/dev/zero",)"), {"device.gltf"}},
      {"data.gltf",
       square.json(R"("uri":"data:application/octet-stream;base64,!!!!",)"),
       {"data.gltf"}},
      {"huge buffer.gltf",
       replaced(square.json(R"("uri":"skin.bin",)"), R"("byteLength":)", R"("byteLength":1)"),
       {"huge buffer.gltf"}},
  };
}

std::vector<Malformed> of_others() {
  std::string stl(80, ' ');
  stl += raw<std::uint32_t>({4000000000U}) + std::string(100, '\0');
  std::string nan(80, ' ');
  nan += raw<std::uint32_t>({1}) + raw<float>({0, 0, 1, NAN, 0, 0, 1, 0, 0, 0, 1, 0}) +
         std::string(2, '\0');
  std::string deep = "<?xml version=\"1.0\"?><COLLADA>";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  return {
      {"empty.stl", "", {"empty"}},
      {"huge.stl", stl, {"huge.stl"}},
      {"nan.stl", nan, {"nan.stl", "finite"}},
      {"noise.stl", std::string(60, '\x80'), {"noise.stl"}},
      {"words.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", {"words.stl"}},
      {"magic.3ds", "hello there, this is no scan at all", {"magic.3ds"}},
      {"cut.3ds", std::string("\x4d\x4d\xff\xff\xff\x7f\x3d\x3d\xff\xff\xff\x7f", 12), {"cut.3ds"}},
      {"magic.fbx",
       std::string("Kaydara FBX Binary  \0\x1a\0\xe8\x1c\0\0\xff\xff\xff\xff", 31),
       {"magic.fbx"}},
      {"deep.dae", deep, {"deep.dae"}},
      {"entities.dae",
       "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY b \"bbbb\"><!ENTITY c \"&b;&b;&b;\">]>"
       "<COLLADA>&c;</COLLADA>",
       {"entities.dae"}},
      {"index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 900\n", {"index.off"}},
      {"huge.off", "OFF\n4000000000 4000000000 0\n0 0 0\n", {"huge.off"}},
      {"no zip.3mf", "PK\3\4 and no more", {"no zip.3mf"}},
      {"Umläute und Leerzeichen/größe.ply", "ply\n", {"größe.ply", "no end"}},
      {"unknown.docx", "PK", {"unknown.docx", "does not end like"}},
  };
}

/// Each within seconds, with its name, and without much memory of this process.
class MalformedScans : public testing::TestWithParam<int> {};

TEST_P(MalformedScans, AreRefusedByName) {
  const std::vector<Malformed> kinds[] = {of_obj(), of_ply(), of_gltf(), of_others()};
  const TemporaryFolder folder;
  for (const Malformed& bad : kinds[GetParam()]) {
    SCOPED_TRACE(bad.name);
    const fs::path file = folder.write("in/" + bad.name, bad.text);
    if (bad.name == "huge buffer.gltf") folder.write("in/skin.bin", std::string(100, 'x'));
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::string> words = bad.words;
    test::expect_error(ErrorKind::input, words, [&] { test::read(file); });
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 200000) << "kB";
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, MalformedScans, testing::Range(0, 4));

TEST(MalformedScans, AreAtLeastForty) {
  EXPECT_GE(of_obj().size() + of_ply().size() + of_gltf().size() + of_others().size(), 70U);
}

TEST(MalformedScans, OfEveryLengthOfAGoodFileDoNoHarm) {
  const TemporaryFolder folder;
  const SquareGltf square;
  const std::string good = glb(square.json(), square.bytes());
  for (std::size_t length = 1; length < good.size(); length += 97) {
    const fs::path file = folder.write("cut.glb", good.substr(0, length));
    EXPECT_THROW(test::read(file), Error) << length;
  }
}

TEST(MalformedScans, WithAnyByteChangedAreReadOrRefused) {
  const TemporaryFolder folder;
  const SquareGltf square;
  const std::string good = glb(square.json(), square.bytes());
  int refused = 0;
  for (std::size_t at = 0; at < good.size(); at += 61) {
    std::string bad = good;
    bad[at] = static_cast<char>(~bad[at]);
    const fs::path file = folder.write("changed.glb", bad);
    try {
      test::read(file);
    } catch (const Error& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("changed.glb"), std::string::npos);
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(MalformedScans, ThatAreFoldersOrPipesAreRefused) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "folder.ply");
  test::expect_error(ErrorKind::input, {"folder.ply"}, [&] { test::read(folder / "folder.ply"); });
  test::expect_error(ErrorKind::input, {"none.glb"}, [&] { test::read(folder / "none.glb"); });
}

}  // namespace
}  // namespace gnathion

#include "phantom/head_phantom.h"

#include <gdcmImageReader.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <sstream>

#include "base/error.h"
#include "phantom/face_paint.h"
#include "phantom/phantom_ct.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using Eigen::Vector3i;

/// A new folder that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int count = 0;
    path_ = fs::temp_directory_path() /
            ("gnathion phantom " + std::to_string(getpid()) + " " + std::to_string(count++));
    fs::create_directory(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { fs::remove_all(path_); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::map<std::string, std::string> bytes_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      std::ifstream file(entry.path(), std::ios::binary);
      files[fs::relative(entry.path(), folder).string()] =
          std::string(std::istreambuf_iterator<char>(file), {});
    }
  }
  return files;
}

PhantomOptions coarse() {
  PhantomOptions options;
  options.pixel_mm = 3;
  options.slice_step_mm = 3;
  options.photograph_edge_mm = 5;
  options.texture_pixels = 128;
  return options;
}

std::map<std::string, std::string> written(const PhantomOptions& options) {
  const TemporaryFolder folder;
  Progress progress;
  write_phantom_case(folder.path(), options, progress);
  return bytes_of(folder.path());
}

struct Obj {
  std::vector<Vector3d> vertices;
  std::vector<Eigen::Vector2d> texture;
  std::vector<std::vector<std::array<int, 2>>> faces;  // vertex, texture coordinate; from 0
};

Obj read_obj(const fs::path& path) {
  Obj obj;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") {
      Vector3d p;
      words >> p.x() >> p.y() >> p.z();
      obj.vertices.push_back(p);
    } else if (key == "vt") {
      Eigen::Vector2d t;
      words >> t.x() >> t.y();
      obj.texture.push_back(t);
    } else if (key == "f") {
      obj.faces.emplace_back();
      int v = 0;
      int t = 0;
      char slash = 0;
      while (words >> v >> slash >> t) {
        obj.faces.back().push_back({v - 1, t - 1});
      }
    }
  }
  return obj;
}

/// The default case, written once for all tests.
class DefaultCase : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    Progress progress;
    truth_ = new PhantomTruth(write_phantom_case(folder_->path(), {}, progress));
    volume_ = new PhantomVolume(make_phantom_volume(HeadModel(), {}, progress));
    obj_ = new Obj(read_obj(folder_->path() / "photograph/face.obj"));
  }
  static void TearDownTestSuite() {
    delete folder_;
    delete truth_;
    delete volume_;
    delete obj_;
  }
  static Vector3d landmark(const std::string& name) { return truth_->landmarks.at(name); }
  static Vector3i voxel(const Vector3d& p) {
    return (p - volume_->origin).cwiseQuotient(volume_->spacing).array().round().cast<int>();
  }
  static Vector3d position(const Vector3i& v) {
    return volume_->origin + v.cast<double>().cwiseProduct(volume_->spacing);
  }
  static std::size_t index(const Vector3i& v) {
    return (static_cast<std::size_t>(v.z()) * volume_->size.y() + v.y()) * volume_->size.x() +
           v.x();
  }
  static int hounsfield(const Vector3d& p) { return volume_->hounsfield[index(voxel(p))]; }

  /// Voxels of at least `level` joined (26 neighbours) with the one at `seed`, within the box.
  static std::vector<char> component(const Vector3d& seed, int level, const Vector3d& box_min,
                                     const Vector3d& box_max) {
    std::vector<char> found(volume_->hounsfield.size(), 0);
    std::vector<Vector3i> open{voxel(seed)};
    found[index(open.back())] = 1;
    while (!open.empty()) {
      const Vector3i v = open.back();
      open.pop_back();
      for (int n = 0; n < 27; ++n) {
        const Vector3i w = v + Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        if ((w.array() < 0).any() || (w.array() >= volume_->size.array()).any() ||
            (position(w).array() < box_min.array()).any() ||
            (position(w).array() > box_max.array()).any() || found[index(w)] != 0 ||
            volume_->hounsfield[index(w)] < level) {
          continue;
        }
        found[index(w)] = 1;
        open.push_back(w);
      }
    }
    return found;
  }

  static TemporaryFolder* folder_;
  static PhantomTruth* truth_;
  static PhantomVolume* volume_;
  static Obj* obj_;
};
TemporaryFolder* DefaultCase::folder_ = nullptr;
PhantomTruth* DefaultCase::truth_ = nullptr;
PhantomVolume* DefaultCase::volume_ = nullptr;
Obj* DefaultCase::obj_ = nullptr;

TEST(HeadPhantom, SameSeedSameBytesOnAnyNumberOfThreads) {
  PhantomOptions options = coarse();
  options.threads = 1;
  const auto once = written(options);
  options.threads = 3;
  const auto again = written(options);
  ASSERT_GT(once.size(), 80U);
  EXPECT_TRUE(once == again);
}

TEST(HeadPhantom, AnotherSeedGivesAnotherScanOfTheSameHead) {
  PhantomOptions options = coarse();
  const auto one = written(options);
  options.seed = 2;
  const auto two = written(options);
  EXPECT_NE(one.at("ct/slice_030.dcm"), two.at("ct/slice_030.dcm"));
  EXPECT_NE(one.at("photograph/face.png"), two.at("photograph/face.png"));
  EXPECT_EQ(one.at("photograph/face.obj"), two.at("photograph/face.obj"));
}

TEST(HeadPhantom, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  Progress progress;
  PhantomOptions options = coarse();
  const auto kind_of = [&](const fs::path& path) {
    try {
      write_phantom_case(path, options, progress);
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::input;
  };
  EXPECT_EQ(kind_of(folder.path() / "missing"), ErrorKind::output);
  std::ofstream(folder.path() / "occupied") << "x";
  EXPECT_EQ(kind_of(folder.path()), ErrorKind::output);
  fs::remove(folder.path() / "occupied");
  options.pixel_mm = std::nan("");
  EXPECT_EQ(kind_of(folder.path()), ErrorKind::usage);
  EXPECT_TRUE(fs::is_empty(folder.path()));
  options = coarse();
  progress.cancel();
  EXPECT_EQ(kind_of(folder.path()), ErrorKind::cancelled);
}

TEST_F(DefaultCase, LandmarksLieOnTheirSurfaces) {
  const HeadModel head;
  const std::set<std::string> mandible = {"b_point",      "pogonion",      "gnathion",
                                          "menton",       "gonion_left",   "gonion_right",
                                          "condyle_left", "condyle_right", "lower_incisor_edge"};
  const std::set<std::string> skull = {"nasion", "a_point", "upper_incisor_edge"};
  ASSERT_GE(truth_->landmarks.size(), 24U);
  for (const auto& [name, p] : truth_->landmarks) {
    const double d = mandible.count(name) != 0 ? head.mandible(p)
                     : skull.count(name) != 0  ? head.skull(p)
                                               : head.skin(p);
    EXPECT_NEAR(d, 0, 1e-5) << name;
  }
}

TEST_F(DefaultCase, HasAdultProportions) {
  const auto between = [](double value, double low, double high) {
    EXPECT_GE(value, low);
    EXPECT_LE(value, high);
  };
  between(landmark("nasion_soft").z() - landmark("menton_soft").z(), 112, 128);
  between(landmark("pogonion").y() - landmark("pogonion_soft").y(), 9, 13);
  between(landmark("upper_incisor_edge").y() - landmark("upper_lip").y(), 10, 15);
  between(landmark("lower_incisor_edge").y() - landmark("lower_lip").y(), 10, 15);
  between(landmark("b_point").y() - landmark("mentolabial_fold").y(), 7, 13);
  between(landmark("nasion").y() - landmark("nasion_soft").y(), 3, 9);
  between(landmark("mouth_corner_left").x() - landmark("mouth_corner_right").x(), 45, 56);
  between(landmark("gonion_left").x() - landmark("gonion_right").x(), 86, 110);
  between(landmark("condyle_left").x() - landmark("condyle_right").x(), 90, 112);
  EXPECT_LT(landmark("nose_tip").y(), landmark("upper_lip").y());
  EXPECT_LT(landmark("upper_lip").z(), landmark("subnasale").z());
}

TEST(HeadModel, BoneLiesUnderTheSkin) {
  const HeadModel head;
  double thinnest = 1e9;
  for (double z = -90; z < 120; z += 3) {
    for (double y = -120; y < 96; y += 3) {
      for (double x = 0; x < 78; x += 3) {
        if (head.bone({x, y, z}) < 0) {
          thinnest = std::min(thinnest, -head.skin({x, y, z}));
        }
      }
    }
  }
  EXPECT_GT(thinnest, 1.5);
}

TEST_F(DefaultCase, TheMoleIsOnThePatientsLeft) {
  const HeadModel head;
  const FacePaint paint(head, 1);
  const Vector3d mole = landmark("mole");
  EXPECT_GT(mole.x(), 30);
  EXPECT_LT(mole.y(), -60);
  const Vector3d mirrored(-mole.x(), mole.y(), mole.z());
  EXPECT_LT(paint.colour(mole).sum() + 0.8, paint.colour(mirrored).sum());
}

TEST_F(DefaultCase, TheVolumeShowsLeftAndRight) {
  // Just outside the cheek the mole's tissue is on the left only; the septum bends to the left.
  const Vector3d mole = landmark("mole") + Vector3d(0.2, -0.3, 0);
  EXPECT_GT(hounsfield(mole), hounsfield({-mole.x(), mole.y(), mole.z()}) + 100);
  EXPECT_GT(hounsfield({4, -76, -6}), hounsfield({-4, -76, -6}) + 200);
}

TEST_F(DefaultCase, HounsfieldUnitsArePlausible) {
  EXPECT_NEAR(hounsfield({0, -130, 100}), -1000, 40);
  EXPECT_NEAR(hounsfield({0, 20, 70}), 35, 40);
  EXPECT_NEAR(hounsfield({0, -58, -50}), 50, 40);
  EXPECT_GT(hounsfield(landmark("upper_incisor_edge") + Vector3d(0, 0.5, 3)), 1900);
  EXPECT_NEAR(hounsfield({31.5, -77, 15}), 12, 40);
}

TEST_F(DefaultCase, TheMandibleIsSeparateFromTheSkull) {
  const Vector3d everywhere = Vector3d::Constant(1e9);
  const auto bone =
      component(landmark("pogonion") + Vector3d(0, 1.5, 0), 250, -everywhere, everywhere);
  for (const char* name : {"condyle_left", "condyle_right", "gonion_left", "gonion_right"}) {
    const Vector3d inward = name[0] == 'c' ? Vector3d(0, 0, -1.5) : Vector3d(0, -1.5, 1.5);
    EXPECT_TRUE(bone[index(voxel(landmark(name) + inward))]) << name;
  }
  const HeadModel head;
  std::size_t count = 0;
  for (int n = 0; n < static_cast<int>(bone.size()); ++n) {
    if (bone[static_cast<std::size_t>(n)] != 0) {
      ++count;
      const int row = n / volume_->size.x();
      const Vector3d p =
          position({n % volume_->size.x(), row % volume_->size.y(), row / volume_->size.y()});
      ASSERT_LT(head.mandible(p), 1.2) << p.transpose();
    }
  }
  const double millilitres = static_cast<double>(count) * volume_->spacing.prod() / 1000;
  EXPECT_GT(millilitres, 45);
  EXPECT_LT(millilitres, 120);
}

TEST_F(DefaultCase, TheRecommendedBoxHoldsTheMandiblesBodyAndNothingElse) {
  const HeadModel head;
  const auto bone = component(landmark("pogonion") + Vector3d(0, 1.5, 0), 250,
                              truth_->mandible_box_min, truth_->mandible_box_max);
  EXPECT_TRUE(bone[index(voxel(landmark("menton") + Vector3d(0, 0, 1.5)))]);
  for (const double side : {-1, 1}) {
    EXPECT_TRUE(bone[index(voxel({side * 27, -57, -49}))]) << "last molar";
    EXPECT_FALSE(bone[index(voxel({side * 46, -24, -60}))]) << "angle";
  }
  EXPECT_TRUE(bone[index(voxel(landmark("lower_incisor_edge") - Vector3d(0, 0, 3)))]);
  for (int k = 0; k < volume_->size.z(); ++k) {
    for (int j = 0; j < volume_->size.y(); ++j) {
      for (int i = 0; i < volume_->size.x(); ++i) {
        const Vector3i v(i, j, k);
        const Vector3d p = position(v);
        const bool in_box = (p.array() >= truth_->mandible_box_min.array()).all() &&
                            (p.array() <= truth_->mandible_box_max.array()).all();
        if (in_box && volume_->hounsfield[index(v)] >= 250) {
          ASSERT_TRUE(bone[index(v)]) << "a second piece of bone at " << p.transpose();
        }
      }
    }
  }
}

TEST_F(DefaultCase, TheSeriesReadsBackWithItsGeometry) {
  for (const int k : {0, 77, volume_->size.z() - 1}) {
    char name[32];
    std::snprintf(name, sizeof name, "ct/slice_%03d.dcm", k);
    gdcm::ImageReader reader;
    reader.SetFileName((folder_->path() / name).c_str());
    ASSERT_TRUE(reader.Read()) << name;
    const gdcm::Image& image = reader.GetImage();
    EXPECT_EQ(image.GetDimension(0), static_cast<unsigned>(volume_->size.x()));
    EXPECT_EQ(image.GetDimension(1), static_cast<unsigned>(volume_->size.y()));
    for (int a = 0; a < 2; ++a) {
      EXPECT_DOUBLE_EQ(image.GetSpacing(static_cast<unsigned>(a)), volume_->spacing[a]);
      EXPECT_DOUBLE_EQ(image.GetOrigin(static_cast<unsigned>(a)), volume_->origin[a]);
    }
    EXPECT_DOUBLE_EQ(image.GetOrigin(2), volume_->origin.z() + k * volume_->spacing.z());
    const double along[6] = {1, 0, 0, 0, 1, 0};
    EXPECT_TRUE(std::equal(along, along + 6, image.GetDirectionCosines()));
    EXPECT_DOUBLE_EQ(image.GetIntercept(), -1024);
    EXPECT_DOUBLE_EQ(image.GetSlope(), 1);
    std::vector<std::uint16_t> stored(image.GetBufferLength() / 2);
    ASSERT_TRUE(image.GetBuffer(reinterpret_cast<char*>(stored.data())));
    const std::size_t first = index({0, 0, k});
    for (std::size_t i = 0; i < stored.size(); ++i) {
      ASSERT_EQ(stored[i] - 1024, volume_->hounsfield[first + i]);
    }
    const gdcm::ByteValue* patient =
        reader.GetFile().GetDataSet().GetDataElement(gdcm::Tag(0x10, 0x10)).GetByteValue();
    EXPECT_EQ(std::string(patient->GetPointer(), patient->GetLength()), "GNATHION^SYNTHETIC");
  }
}

TEST_F(DefaultCase, ThePhotographIsASoundSurface) {
  ASSERT_GT(obj_->vertices.size(), 8000U);
  ASSERT_EQ(obj_->vertices.size(), obj_->texture.size());
  std::set<std::pair<int, int>> directed;
  std::vector<char> used(obj_->vertices.size(), 0);
  std::size_t quads = 0;
  for (const auto& face : obj_->faces) {
    quads += face.size() == 4 ? 1 : 0;
    for (std::size_t c = 0; c < face.size(); ++c) {
      const int a = face[c][0];
      const int b = face[(c + 1) % face.size()][0];
      ASSERT_GE(a, 0);
      ASSERT_LT(a, static_cast<int>(obj_->vertices.size()));
      ASSERT_LT(face[c][1], static_cast<int>(obj_->texture.size()));
      used[static_cast<std::size_t>(a)] = 1;
      ASSERT_TRUE(directed.insert({a, b}).second) << "edge used twice in one direction";
    }
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
  EXPECT_GT(quads, obj_->faces.size() / 2);
  EXPECT_LT(quads, obj_->faces.size());
  for (const Eigen::Vector2d& t : obj_->texture) {
    ASSERT_TRUE((t.array() >= 0).all() && (t.array() <= 1).all());
  }
}

TEST_F(DefaultCase, ThePhotographsFacesLookOutwardsWithoutFolds) {
  const HeadModel head;
  double longest = 0;
  for (const auto& face : obj_->faces) {
    std::vector<Vector3d> p;
    Vector3d middle = Vector3d::Zero();
    for (const auto& corner : face) {
      p.push_back(truth_->lps_from_photograph(obj_->vertices[static_cast<std::size_t>(corner[0])]));
      ASSERT_NEAR(head.skin(p.back()), 0, 0.05) << p.back().transpose();
      middle += p.back() / static_cast<double>(face.size());
    }
    const Vector3d outward = head.skin_normal(middle);
    for (std::size_t c = 0; c < p.size(); ++c) {
      const Vector3d& a = p[c];
      const Vector3d& b = p[(c + 1) % p.size()];
      const Vector3d& d = p[(c + p.size() - 1) % p.size()];
      longest = std::max(longest, (b - a).norm());
      ASSERT_GT((b - a).norm(), 0.2);
      ASSERT_GT((b - a).cross(d - a).dot(outward), 0) << "folded at " << a.transpose();
    }
  }
  EXPECT_LT(longest, 8);
}

TEST_F(DefaultCase, TheTextureShowsTheMoleOnTheLeftCheek) {
  const cv::Mat image =
      cv::imread((folder_->path() / "photograph/face.png").string(), cv::IMREAD_COLOR);
  ASSERT_EQ(image.cols, PhantomOptions().texture_pixels);
  const auto brightness_at = [&](const Vector3d& p) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < obj_->vertices.size(); ++i) {
      const auto distance = [&](std::size_t n) {
        return (truth_->lps_from_photograph(obj_->vertices[n]) - p).norm();
      };
      nearest = distance(i) < distance(nearest) ? i : nearest;
    }
    const Eigen::Vector2d t = obj_->texture[nearest];
    const auto texel = image.at<cv::Vec3b>(static_cast<int>((1 - t.y()) * image.rows),
                                           static_cast<int>(t.x() * image.cols));
    return texel[0] + texel[1] + texel[2];
  };
  const Vector3d mole = landmark("mole");
  EXPECT_LT(brightness_at(mole) + 150, brightness_at({-mole.x(), mole.y(), mole.z()}));
}

TEST_F(DefaultCase, TruthIsWrittenAsReturned) {
  std::ifstream file(folder_->path() / "truth.json");
  const nlohmann::json json = nlohmann::json::parse(file);
  ASSERT_EQ(json.at("landmarks").size(), truth_->landmarks.size());
  for (const auto& [name, p] : truth_->landmarks) {
    for (int a = 0; a < 3; ++a) {
      EXPECT_EQ(json["landmarks"][name][static_cast<std::size_t>(a)].get<double>(), p[a]) << name;
    }
  }
  EXPECT_EQ(json["lps_from_photograph"]["scale"].get<double>(), truth_->lps_from_photograph.scale);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(json["lps_from_photograph"]["rotation"][r][c].get<double>(),
                truth_->lps_from_photograph.rotation(static_cast<int>(r), static_cast<int>(c)));
    }
  }
  EXPECT_NEAR(truth_->lps_from_photograph.rotation.determinant(), 1, 1e-12);
}

}  // namespace
}  // namespace gnathion

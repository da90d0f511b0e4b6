#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace gnathion {

/// One object of a JSON file, read strictly: every key must be asked for before finish(), and every
/// value must have the type asked for. Errors are Error(case_file) with the file and the key's path
/// ("case.json: motion.forward_mm") as subject.
class JsonReader {
 public:
  /// Parses the file. Throws Error(input) when it cannot be read, Error(case_file) with the line
  /// and column when it is no JSON object, or with the key that one object has twice.
  static JsonReader file(const std::string& path);

  bool has(const std::string& key) const;
  /// The object under a key; an empty one when it is absent.
  JsonReader object(const std::string& key);
  /// These throw when the key is absent, and when a text is empty.
  JsonReader required_object(const std::string& key);
  /// The objects of a list; none when it is absent.
  std::vector<JsonReader> objects(const std::string& key);

  /// A copy without some keys, each given by its path from here ("tissue.sliding_file").
  JsonReader without(const std::vector<std::string>& paths) const;
  /// A copy that is changed as `changes` say (JSON merge patch, RFC 7386: objects are merged key by
  /// key, null removes a key, every other value takes the old one's place). `place`: how messages
  /// about the copy name it ("history.steps[3]").
  JsonReader changed_by(const JsonReader& changes, const std::string& place) const;

  void read(const std::string& key, double& value);
  void read(const std::string& key, std::string& value);
  void read(const std::string& key, bool& value);
  void read(const std::string& key, Eigen::Vector3d& value);
  void read(const std::string& key, Eigen::Matrix3d& value);  ///< three rows
  void read(const std::string& key, std::vector<Eigen::Vector3d>& value);
  std::string required_string(const std::string& key);
  Eigen::Vector3d required_vector(const std::string& key);
  Eigen::Vector2d required_pixel(const std::string& key);  ///< right and down
  std::vector<std::string> keys() const;

  /// Throws naming the first key that nobody asked for.
  void finish() const;
  /// The subject of a message about a key.
  std::string subject(const std::string& key) const;
  [[noreturn]] void refuse(const std::string& key, const std::string& problem,
                           const std::string& remedy) const;

 private:
  struct Implementation;
  explicit JsonReader(std::shared_ptr<Implementation> implementation);
  std::shared_ptr<Implementation> implementation_;
};

}  // namespace gnathion

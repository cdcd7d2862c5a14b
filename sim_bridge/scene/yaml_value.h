#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace seaway::bridge {

/// A value of a YAML file that remembers where it stands, so that every fault found in it can be
/// reported as `file:line: key 'a.b.c': …`. Copyable; nothing of the YAML library shows.
struct YamlValue {
  enum class Kind { null, scalar, list, mapping };

  Kind kind = Kind::null;
  std::string scalar;             ///< text of a scalar, unquoted
  std::vector<YamlValue> values;  ///< items of a list or values of a mapping, in file order
  std::string name;               ///< last part of the key; empty for the document itself
  std::string key;                ///< whole path, such as `cameras[0].fov_deg`
  std::shared_ptr<const std::filesystem::path> file;
  int line = 0;  ///< from 1

  /// Value of `childName` in a mapping; null where there is none.
  const YamlValue* find(std::string_view childName) const;

  /// The scalar's text, or what stands there instead: for messages.
  std::string shown() const;

  /// Throws InputError: `file:line: key 'key': what`.
  [[noreturn]] void fail(const std::string& what) const;
};

/// Reads a whole YAML file. Throws InputError, with file and line, where the file cannot be read or
/// is not YAML or holds a second document, where a key comes twice in a mapping, and where it is
/// nested unreasonably deep.
YamlValue readYaml(const std::filesystem::path& file);

/// The same for a text; `file` is the name that messages give.
YamlValue parseYaml(const std::string& text, const std::filesystem::path& file);

}  // namespace seaway::bridge

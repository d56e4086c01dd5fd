#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Replaces every byte that is not well-formed UTF-8 by U+FFFD.
std::string validUtf8(std::string_view text);

/// Returns at most `maximum` bytes of a text, cut between characters.
std::string shortened(const std::string &text, std::size_t maximum);

/// Cleans a name read from a file: valid UTF-8, without control characters and surrounding blanks, at most 200 bytes.
std::string cleanName(std::string_view text);

/// Lists up to `maximum` names for a message, such as "'land', 'sea' and 3 more".
std::string listed(const std::vector<std::string> &names, std::size_t maximum);

/// Returns the name as an identifier: ASCII letters, digits and '_' only, beginning with a letter, at most `maximum`
/// bytes.
std::string asIdentifier(std::string_view name, std::size_t maximum = 80);

/// Returns the name for formats that put names in double quotes without escapes: quotes become apostrophes and control
/// characters blanks; at most `maximum` bytes, cut between characters.
std::string asQuotable(std::string_view name, std::size_t maximum = 127);

/// Returns the name in printable ASCII: '%', '"', control characters, every byte above 0x7e and the bytes in `others`
/// become %XX, as in URLs and in legacy VTK files.
std::string percentEncoded(std::string_view name, std::string_view others = {});

/// Reverses percentEncoded(). A '%' without two hexadecimal digits after it is kept.
std::string percentDecoded(std::string_view text);

/// Hands out names that differ from each other even when case is ignored.
class UniqueNames {
  public:
    /// Returns the name, shortened to `maximum` bytes, or with "_2", "_3", ... at its end if it is already taken.
    std::string claim(const std::string &name, std::size_t maximum = 80);

    /// Returns true if a name is taken, ignoring case.
    bool taken(const std::string &name) const;

  private:
    std::set<std::string> taken_;
};

/// The tags in use by kind, each with its given or default name, sorted by tag.
struct TagList {
    std::map<std::int32_t, std::string> edges, points, regions;
};
TagList tagsOf(const MeshView &mesh);

/// The names of tags in a format that cannot store the mesh's names unchanged.
struct FileNames {
    std::map<std::int32_t, std::string> edges, points, regions;
};

/// Makes an identifier of each name. No two are the same, even for tags of different kinds: as in MSH files, edges keep
/// their names, and regions and points whose names are taken get "_region" or "_point" appended.
FileNames identifiersOf(const TagList &tags, UniqueNames &unique);

/// Returns a note that lists the names that differ in the file; empty if none do.
Diagnostics noteChangedNames(const TagList &tags, const FileNames &written);

/// Adds a name read from a file, unless it only repeats the default name of its tag.
void addName(std::map<std::int32_t, std::string> &names, std::int32_t tag, const std::string &name, bool region);

/// Writes a comment line `PREFIX boundary TAG "NAME"` or `PREFIX region TAG "NAME"` for every tag in use, for formats
/// that cannot hold any name. The lines are ASCII: other characters of a name are written as %XX.
void writeNameComments(const TagList &tags, std::string_view prefix, TextWriter &out);
inline void writeNameComments(const MeshView &mesh, std::string_view prefix, TextWriter &out) {
    writeNameComments(tagsOf(mesh), prefix, out);
}
struct TagNames {
    std::map<std::int32_t, std::string> boundary, region;
};
/// Reads the lines that writeNameComments wrote.
TagNames readNameComments(std::string_view text, std::string_view prefix);

} // namespace forefront

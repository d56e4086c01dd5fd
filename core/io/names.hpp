#pragma once

#include "core/io/text/text_writer.hpp"
#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The text with every byte that is not well-formed UTF-8 replaced by U+FFFD.
std::string validUtf8(std::string_view text);

/// A name as read from a foreign file: valid UTF-8, control characters and blanks around it dropped, at most 200 bytes.
std::string cleanName(std::string_view text);

/// Letters, digits and '_' only, beginning with a letter, at most `longest` bytes; for formats whose names are
/// identifiers.
std::string asIdentifier(std::string_view name, std::size_t longest = 80);

/// For formats that put names in double quotes without escapes: quotes become apostrophes, line ends blanks; at most
/// `longest` bytes, cut between characters.
std::string asQuotable(std::string_view name, std::size_t longest = 127);

/// Hands out names that differ from each other, also when upper and lower case are taken as equal.
class UniqueNames {
  public:
    /// The name itself, or with "_2", "_3", ... appended.
    std::string claim(const std::string &name);

  private:
    std::set<std::string> taken_;
};

/// Tags in use by kind, each with its name as given or by default, sorted by tag.
struct TagList {
    std::map<std::int32_t, std::string> edges, points, regions;
};
TagList tagsOf(const Mesh &mesh);

/// Reads names back: an entry that only repeats the default name is left out.
void addName(std::map<std::int32_t, std::string> &names, std::int32_t tag, const std::string &name, bool region);

/// For formats without names of their own: a comment line `PREFIX boundary TAG "NAME"` or `PREFIX region TAG "NAME"`
/// for every tag in use, and back.
void writeNameComments(const Mesh &mesh, std::string_view prefix, TextWriter &out);
struct TagNames {
    std::map<std::int32_t, std::string> boundary, region;
};
TagNames readNameComments(std::string_view text, std::string_view prefix);

} // namespace forefront

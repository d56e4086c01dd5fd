#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/names.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The points, edges or elements of one tag, as a file with one table of groups numbers and names them.
struct PartGroup {
    int dimension = 0;       ///< 0 points, 1 edges, 2 elements
    std::int32_t tag = 1;    ///< in the mesh
    std::int32_t number = 1; ///< in the file
    std::string name;        ///< in the mesh, given or default
    std::string label;       ///< in the file
};

/// The limits of a format on the numbers and labels of its groups.
struct GroupLimits {
    std::int32_t number; ///< the maximum
    std::size_t label;   ///< the maximum length in bytes
    /// Returns a name as a label of at most `maximum` bytes; null: groups have no labels, and names are in comments.
    std::string (*labelOf)(std::string_view name, std::size_t maximum);
};

/// The groups of a mesh, numbered and labelled so that no two have the same number or, ignoring case, the same label,
/// even in different dimensions.
///
/// A group has its tag as number if that is free and within the limit; else tag + 1000 for regions, tag + 2000 for
/// points, and otherwise the lowest free number. Edges come first. Labels that are taken get "_region" or "_point"
/// appended.
class PartGroups {
  public:
    PartGroups(const TagList &tags, const GroupLimits &limits);
    PartGroups(const MeshView &mesh, const GroupLimits &limits) : PartGroups(tagsOf(mesh), limits) {}

    /// By dimension from 1 (edges) to 2 and 0 (points), then tag.
    const std::vector<PartGroup> &groups() const { return groups_; }
    /// Returns the group of `tag`, which must be in use.
    const PartGroup &of(int dimension, std::int32_t tag) const { return groups_[places_[dimension].at(tag)]; }
    /// Writes a comment line `PREFIX group NUMBER boundary|region|point TAG "NAME"` for each group of points and each
    /// whose number or label is not its tag or name.
    void writeOrigins(std::string_view prefix, TextWriter &out) const;
    /// Returns a note that lists the names that differ in the file; empty if none do.
    Diagnostics noteChanges() const;

  private:
    std::vector<PartGroup> groups_;
    std::map<std::int32_t, std::size_t> places_[3]; ///< by dimension, then tag
};

/// Reads the lines that PartGroups::writeOrigins wrote, without labels, by number. Other lines are skipped.
std::map<std::int32_t, PartGroup> readGroupOrigins(std::string_view text, std::string_view prefix);

} // namespace forefront

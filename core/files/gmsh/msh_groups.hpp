#pragma once

#include "core/engine/base/length_unit.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A physical group of an MSH file: the points, edges or elements of one tag.
struct MshGroup {
    int dimension = 0;       ///< 0 points, 1 edges, 2 elements
    std::int32_t tag = 1;    ///< in the mesh
    std::int32_t number = 1; ///< in the file
    std::string name;        ///< in the mesh, given or default
    std::string label;       ///< in the file
};

/// The physical groups of a mesh, numbered and named so that no two have the same number or name, even in different
/// dimensions: meshio keeps one table of names, GetFEM one of numbers.
///
/// Edges keep their tags. Where a region has the tag of an edge or point, all regions are numbered tag + B, and where a
/// point has the tag of an edge, all points are numbered tag + 2B; B is the smallest of 1000, 10000, ... above all tags
/// in use. If the sums exceed 32 bits, the unused numbers from 1 on are used instead.
///
/// Edges keep their names. Regions and points whose names are taken get "_region" or "_point" appended, and "_2", "_3",
/// ... follow where that is not enough.
///
/// If tags are kept, numbers and names are those of the mesh, and may be the same in different dimensions.
class MshGroups {
  public:
    explicit MshGroups(const MeshView &mesh, bool keepsTags = false);

    /// By dimension, then tag.
    const std::vector<MshGroup> &groups() const { return groups_; }
    /// Returns the number of the physical group of `tag`, which must be in use.
    std::int32_t number(int dimension, std::int32_t tag) const;

    /// Returns the first of `count` successive numbers above those of all groups; 1 if they would exceed 32 bits.
    std::int32_t unusedNumbers(std::size_t count) const;

    /// Writes the section $PhysicalNames, which is the same in MSH 2.2 and 4.1.
    void writeNames(TextWriter &out) const;
    /// Writes a section $Comments with the unit of the coordinates, and with the tags and names of the mesh that are
    /// different in the file; see writeMshComments().
    void writeOrigins(TextWriter &out, LengthUnit unit) const;

  private:
    std::vector<MshGroup> groups_;
};

/// Writes a section $Comments with lines, and with the unit of the coordinates; writes nothing if there are neither.
/// Must come last, since some readers expect only the standard sections before it.
void writeMshComments(std::string_view lines, LengthUnit unit, TextWriter &out);

/// Writes the elevations of a mesh that has some as nodal values "elevation", as text.
void writeMshElevations(const MeshView &mesh, TextWriter &out);

/// Reads the content of a $Comments section that writeOrigins wrote; other lines are skipped. Labels stay empty.
std::vector<MshGroup> readMshOrigins(std::string_view comments);

/// Gives the points, edges and elements of a mesh as read the tags and names that its groups had before.
void restoreTags(const std::vector<MshGroup> &origins, Mesh &mesh);

} // namespace forefront

#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/files/source/map_system.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace FOREFRONT_API forefront {

/// How the elements of a mesh become prisms and hexahedra.
struct Extrusion {
    double height = 1.0;      ///< along z, in domain units, > 0
    std::uint32_t layers = 1; ///< of cells, > 0

    friend bool operator==(const Extrusion &, const Extrusion &) = default;
};

/// The maximum number of layers of an extrusion.
inline constexpr std::uint32_t kMaxExtrudedLayers = 10'000;

/// What a file says of a mesh beyond the mesh itself.
struct ExportOptions {
    /// Tags of the boundary parts through which water flows; all others are land. Only formats with
    /// FileFormat::hasOpenBoundaries tell them apart.
    std::vector<std::int32_t> openBoundaries = {};
    /// Writes prisms and hexahedra, with faces named as the boundary parts and "back" (z = 0) and "front"; only formats
    /// with FileFormat::holdsSolids. Absent: a plane mesh, but OpenFOAM: usualExtrusion(), one layer.
    std::optional<Extrusion> extrusion = {};
    /// Writes the numbers and names of tags unchanged, also where a region has the number or name of a boundary part;
    /// only formats with FileFormat::tellsTagsApart change them otherwise.
    bool keepTags = false;
    /// The unit of the coordinates: $INSUNITS of DXF, the size of an SVG picture, a comment in MSH and Abaqus files;
    /// other formats have no place for it.
    LengthUnit unit = LengthUnit::None;
    /// The reference system of the coordinates, for formats that name it: UGRID.
    MapSystem system = {};
};

} // namespace forefront

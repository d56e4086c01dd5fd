#pragma once

#include "core/engine/base/api.hpp"

#include <cstdint>
#include <string>

namespace FOREFRONT_API forefront {

struct FileFormat;

/// An option of ImportOptions that only some formats have.
enum class ReaderOption : std::uint8_t {
    CurveTolerance,
    Weld,
    Layer,
    NameProperty,
    SizeProperty,
    Projection,
    Degrees,
    Overlap,
    PartNames,
    DropLines,
    BeyondPage,
    StrokeAreas,
    ShapeRegions,
    WhiteHoles,
    Parameters
};

/// Returns why the reader of a format would ignore an option, such as "only TopoJSON and DXF drawing files have layers;
/// the file is in the format Triangle domain"; empty if it takes it.
std::string reasonWithout(ReaderOption option, const FileFormat &format);

} // namespace forefront

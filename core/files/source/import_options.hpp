#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/domain/part_names.hpp"
#include "core/files/source/overlap_rule.hpp"
#include "core/files/source/picture_sizes.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// The code of the note that a drawing was cut off at its page.
inline constexpr char kPageNote[] = "svg-page";
/// The code of the note that strokes were read as lines.
inline constexpr char kStrokeNote[] = "svg-stroke";
/// The code of the note on white shapes that lie on others.
inline constexpr char kWhiteNote[] = "svg-white";

/// The code of the warning that longitudes and latitudes were read as coordinates in the plane.
inline constexpr char kDegreesWarning[] = "degrees";

/// The treatment of a map whose coordinates are longitudes and latitudes in degrees.
enum class DegreeRule : std::uint8_t {
    Warn, ///< they are coordinates in the plane, with a warning; refused if ImportOptions::strict is set
    Keep, ///< they are coordinates in the plane
    Local ///< they are projected to metres; see LocalProjection
};

/// Options for reading a file.
struct ImportOptions {
    /// Maximum distance between a curve and its polyline, in file units; 0: 1/2000 of the drawing's size.
    double curveTolerance = 0.0;
    /// Nodes and segments of drawings and maps that are closer than this are joined, in domain units; absent: 1e-6 of
    /// the diagonal, or less where that would change the areas of outlines by more than 0.1 %. Other formats are read
    /// unchanged.
    std::optional<double> weldTolerance = {};
    OverlapRule overlap = OverlapRule::Later; ///< between features of a map
    DegreeRule degrees = DegreeRule::Warn;    ///< for longitudes and latitudes of a map
    /// The layer ("object") of a TopoJSON file to read; absent: the first one with polygons, or else the first one. Of
    /// a DXF file, one or more layers with commas between them; absent: all that are shown.
    std::optional<std::string> layer = {};
    /// The property of a map's features to take names of boundaries and regions from, text or numbers; "id" also uses
    /// the own ids of the features. Absent: "name", "Name" or "NAME", or if no feature has one, "NAME_n" with the
    /// highest n that all features with such names have.
    std::optional<std::string> nameProperty = {};
    /// The property of a map's features to take element sizes from: of areas and points. Absent: there are none.
    std::optional<std::string> sizeProperty = {};
    /// The coordinate reference system that maps and rasters are converted to, such as "EPSG:3067"; empty: they stay in
    /// their own. Needs the component forefront-gdal.
    std::string projection = {};
    /// Names for parts of the boundary of a map, with places in the coordinates of the file; they are converted with
    /// it. Unused for other formats, whose domains nameParts() can name.
    std::vector<PartName> partNames = {};
    /// Where a mesh is open along a line whose tag other edges have too, or that has none: leave the sides of the line
    /// as they are, so that repair() merges them; otherwise the line is closed and read as a crack.
    bool keepSharedLines = false;
    bool strict = false;     ///< refuse a drawing or map that would have to be changed
    bool beyondPage = false; ///< keep the parts of filled shapes outside the page (view box) of an SVG drawing
    /// Leave out the lines of a drawing or map that has filled shapes or polygons: paths without a fill, and line
    /// strings.
    bool dropLines = false;
    /// The area that the strokes of an SVG drawing paint belongs to the domain; otherwise strokes are lines.
    bool strokeAreas = false;
    /// Every filled shape of an SVG drawing is a region with its name, as far as no later shape covers it; otherwise
    /// all shapes are one region.
    bool shapeRegions = false;
    /// White filled shapes of an SVG drawing that lie on others are holes in these; false: they are merged with them.
    /// Absent: they are holes, with a note, unless nothing of the drawing would remain.
    std::optional<bool> whiteHoles = {};
    std::size_t maxBytes = std::size_t{2} << 30; ///< larger files are refused
    bool regularFile = false;                    ///< refuse pipes and devices, on which reading could wait for ever
    /// Format by its id, such as "geojson"; empty: by content, then by extension.
    std::string formatId = {};
    /// Expressions that replace the ones of a project's parameters, by name; unused for other formats.
    std::map<std::string, std::string> parameters = {};
    /// The sizes that a picture means, where one is read as spacing; unused for other formats.
    std::optional<PictureSizes> picture = {};
    /// The bytes of the file if they have been read already, such as from standard input; null: read the file.
    std::shared_ptr<const std::string> content = {};
    /// Reports the progress of reading a mesh every few thousand lines or elements, and can cancel it with the fault
    /// "cancelled".
    Progress progress = {};
};

} // namespace forefront

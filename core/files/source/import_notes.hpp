#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"
#include "core/files/source/map_system.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace FOREFRONT_API forefront {

/// Something in a file that a reader did not use, or a choice that it made for the user.
struct ImportNote {
    std::string code;    ///< short stable identifier, such as "svg-text"
    std::string message; ///< "text is ignored: it has no outline"
    std::size_t count = 0;
    std::string file; ///< where it occurs first
    int line = 0;
    int column = 0;
    Severity severity = Severity::Note; ///< Warning: the result may not be what the user expects
};

/// The contents of an SVG drawing or map that import options affect.
struct DrawingContents {
    bool lines = false;                   ///< lines beside areas, which ImportOptions::dropLines leaves out
    std::size_t filledShapes = 0;         ///< number of those that ImportOptions::shapeRegions makes regions
    std::size_t whiteShapes = 0;          ///< number of those that ImportOptions::whiteHoles makes holes
    bool whiteHoles = false;              ///< the white shapes were read as holes
    std::vector<std::string> layers = {}; ///< of a TopoJSON or DXF file, as ImportOptions::layer takes them
    std::string layer = {};               ///< the one that was read; several with commas between them
    bool severalLayers = false;           ///< ImportOptions::layer may name several of them
    std::string unit = {};                ///< of the coordinates, such as "millimetres"; empty: the file names none
    /// Properties of features with text or a number as value, for ImportOptions::nameProperty; sorted.
    std::vector<std::string> properties = {};
    bool degrees = false;  ///< its coordinates are longitudes and latitudes, which ImportOptions::degrees concerns
    MapSystem system = {}; ///< of the coordinates as they were read, of a map
};

/// Collects the content of a file that readers leave out, each kind once with its count, in the order of first
/// occurrence, and their findings about the rest.
class ImportNotes {
  public:
    /// Counts `count` more of the note with this code and message; `text`, `offset` and `file` give the first place.
    /// After 200 different ones, the first with this code is counted instead.
    void add(std::string_view code, const std::string &message, const std::string &file, std::string_view text,
             std::size_t offset, std::size_t count = 1, Severity severity = Severity::Note);
    void setContents(const DrawingContents &contents) { contents_ = contents; }
    void setNumbers(MeshNumbers numbers) { numbers_ = std::move(numbers); }
    const std::vector<ImportNote> &entries() const { return entries_; }
    const DrawingContents &contents() const { return contents_; }
    /// Returns the numbers that the file of a mesh gives to its nodes and elements.
    const MeshNumbers &numbers() const { return numbers_; }
    bool empty() const { return entries_.empty(); }
    /// Returns the notes for a log: "... (3 times)" with file, line and column of the first. More than five
    /// notes that differ only in quoted names are shown as one: "... 'a' ... (9 times; also 'b', 'c')".
    Diagnostics diagnostics() const;

  private:
    std::vector<ImportNote> entries_;
    DrawingContents contents_;
    MeshNumbers numbers_;
};

} // namespace forefront

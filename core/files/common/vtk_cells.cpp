#include "core/files/common/vtk_cells.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace forefront {

std::map<std::string, std::vector<std::int32_t>> vtkNameFields(const MeshView &mesh) {
    const TagList tags = tagsOf(mesh);
    auto boundaries = tags.points;
    boundaries.insert(tags.edges.begin(), tags.edges.end());
    std::map<std::string, std::vector<std::int32_t>> fields;
    for (const auto &[tag, name] : boundaries) {
        fields["boundary:" + validUtf8(name)].push_back(tag);
    }
    for (const auto &[tag, name] : tags.regions) {
        fields["region:" + validUtf8(name)].push_back(tag);
    }
    return fields;
}

namespace {

void noteLength(const SourceText &source, std::size_t offset, const std::string &name, std::size_t values,
                std::size_t items, const char *kind) {
    source.note("array-length",
                "the array " + inQuotes(name) + " is ignored: it has " + std::to_string(values) + " values for " +
                    std::to_string(items) + ' ' + kind,
                offset);
}

bool areWhole(const std::vector<double> &values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return v == std::trunc(v); });
}

/// Names under which programs write the tags of cells; "MaterialID" is that of our legacy files.
constexpr std::array<std::string_view, 6> kTagArrays = {"region",        "boundary",  "CellEntityIds",
                                                        "gmsh:physical", "medit:ref", "MaterialID"};

using TagArray = std::pair<const std::string, std::vector<double>>;

/// Returns the first array of tags with one of the usual names, null if there is none. Notes those of another length.
const TagArray *tagArray(const VtkGrid &grid, const char *own, const SourceText &source) {
    for (const char *name : {own, "CellEntityIds", "gmsh:physical", "medit:ref", "region"}) {
        const auto found = grid.cellArrays.find(name);
        if (found == grid.cellArrays.end()) {
            continue;
        }
        if (found->second.size() == grid.types.size()) {
            return &*found;
        }
        noteLength(source, grid.offset, found->first, found->second.size(), grid.types.size(), "cells");
    }
    return nullptr;
}

void noteRealTags(const TagArray *tags, const VtkGrid &grid, const SourceText &source) {
    if (tags != nullptr && !areWhole(tags->second)) {
        source.note("real-tags",
                    "the array " + inQuotes(tags->first) +
                        " has the name of an array of tags, but its values are not whole numbers; they are read as a "
                        "field, and their whole parts as tags",
                    grid.offset);
    }
}

/// Number of cells between two checks of the stop token.
constexpr std::size_t kStopInterval = 4096;

/// The tags of the cells of one kind.
class CellTags {
  public:
    CellTags(const TagArray *given, std::map<std::int32_t, std::string> &names, TagKind kind)
        : given_(given), tags_(names, kind) {}
    std::int32_t at(std::size_t cell) { return given_ == nullptr ? 1 : of(given_->second[cell]); }
    std::int32_t of(double given) { return tags_.of(std::isnan(given) ? 0.0 : std::trunc(given)); }

  private:
    const TagArray *given_;
    AttributeTags tags_;
};

void readNames(const VtkGrid &grid, CellTags &regions, CellTags &boundaries, Mesh &mesh) {
    for (const auto &[field, tags] : grid.fields) {
        const bool region = field.starts_with("region:");
        if (!region && !field.starts_with("boundary:")) {
            continue;
        }
        for (const std::int64_t given : tags) {
            const std::int32_t tag = (region ? regions : boundaries).of(static_cast<double>(given));
            const std::string name = field.substr(field.find(':') + 1);
            auto &names = region ? mesh.regionNames : mesh.boundaryNames;
            if (tag >= 1) {
                addName(names, tag, name, region);
            } else if (!cleanName(name).empty()) {
                names.insert_or_assign(tag, cleanName(name));
            }
        }
    }
}

/// Notes values of the whole data set, such as its time, other than the names of tags.
void noteFieldData(const VtkGrid &grid, const SourceText &source) {
    for (const auto &[field, values] : grid.fields) {
        if (!field.starts_with("region:") && !field.starts_with("boundary:")) {
            source.note("field-data", "the field data " + inQuotes(field) + " is ignored", grid.offset);
        }
    }
}

/// Returns the number of a type of cells that cannot be read, with its name if it is a usual one.
std::string typeName(std::int64_t type) {
    constexpr std::array<std::pair<std::int64_t, const char *>, 17> kNames = {{{2, "a set of vertices"},
                                                                               {4, "a polyline"},
                                                                               {6, "a strip of triangles"},
                                                                               {7, "a polygon"},
                                                                               {8, "a pixel"},
                                                                               {10, "a tetrahedron"},
                                                                               {11, "a voxel"},
                                                                               {12, "a hexahedron"},
                                                                               {13, "a wedge"},
                                                                               {14, "a pyramid"},
                                                                               {24, "a tetrahedron of 10 nodes"},
                                                                               {25, "a hexahedron of 20 nodes"},
                                                                               {34, "a triangle of 7 nodes"},
                                                                               {35, "a line of 4 nodes"},
                                                                               {68, "a Lagrange curve"},
                                                                               {69, "a Lagrange triangle"},
                                                                               {70, "a Lagrange quadrilateral"}}};
    for (const auto &[number, name] : kNames) {
        if (number == type) {
            return std::to_string(type) + " (" + name + ')';
        }
    }
    return std::to_string(type);
}

} // namespace

bool meshOfVtk(VtkGrid &grid, TextScanner &scanner, Mesh &mesh) {
    const auto refuse = [&](const char *code, const std::string &message) {
        return scanner.fail(grid.offset, code, message);
    };
    if (grid.types.size() != grid.ends.size() || grid.nodes.size() >= kNoIndex) {
        return refuse("bad-count", "there are " + std::to_string(grid.ends.size()) + " cells but " +
                                       std::to_string(grid.types.size()) + " cell types");
    }
    const TagArray *const ofRegions = tagArray(grid, "region", scanner.source());
    const TagArray *const ofBoundaries = tagArray(grid, "boundary", scanner.source());
    noteRealTags(ofRegions, grid, scanner.source());
    noteRealTags(ofBoundaries != ofRegions ? ofBoundaries : nullptr, grid, scanner.source());
    CellTags regions(ofRegions, mesh.regionNames, TagKind::Region);
    CellTags boundaries(ofBoundaries, mesh.boundaryNames, TagKind::Boundary);
    PlanarMeshBuilder builder;
    std::vector<std::int64_t> &cells = grid.elementCells;
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < grid.types.size(); ++c) {
        if (c % kStopInterval == 0 && scanner.stopped()) {
            return false;
        }
        const std::int64_t end = grid.ends[c];
        const std::int64_t type = grid.types[c];
        const std::optional<CellKind> kind = cellNumbered(&CellTraits::vtk, type);
        if (!kind) {
            return refuse("unknown-element", "cell " + std::to_string(c) + " is of VTK type " + typeName(type) +
                                                 "; only " + kReadableCells + " can be read");
        }
        const auto expected = static_cast<std::int64_t>(traitsOf(*kind).nodes);
        if (end - begin != expected || begin < 0 || end > static_cast<std::int64_t>(grid.connectivity.size())) {
            return refuse("bad-count", "cell " + std::to_string(c) + " has the wrong number of nodes");
        }
        std::array<NodeId, kMaxCellNodes> all{};
        const std::span<NodeId> nodes = std::span(all).first(static_cast<std::size_t>(expected));
        for (std::int64_t k = begin; k < end; ++k) {
            const std::int64_t node = grid.connectivity[static_cast<std::size_t>(k)];
            if (node < 0 || node >= static_cast<std::int64_t>(grid.nodes.size())) {
                return refuse("bad-index", "cell " + std::to_string(c) + " refers to node " + std::to_string(node) +
                                               ", which does not exist");
            }
            nodes[static_cast<std::size_t>(k - begin)] = NodeId{static_cast<std::uint32_t>(node)};
        }
        begin = end;
        if (!requireDistinct(scanner, grid.offset, nodes, {"cell", c})) {
            return false;
        }
        const bool isElement = traitsOf(*kind).dimension == 2;
        builder.addCell(*kind, nodes, isElement ? regions.at(c) : boundaries.at(c));
        if (isElement) {
            cells.push_back(static_cast<std::int64_t>(c));
        }
    }
    if (begin != static_cast<std::int64_t>(grid.connectivity.size())) {
        return refuse("bad-count", "the cells have " + std::to_string(begin) + " nodes, but " +
                                       std::to_string(grid.connectivity.size()) + " are listed");
    }
    builder.elements.regroup(cells);
    Mesh cellsOnly = builder.finish();
    mesh.blocks = std::move(cellsOnly.blocks);
    mesh.edges = std::move(cellsOnly.edges);
    mesh.points = std::move(cellsOnly.points);
    mesh.nodes = grid.nodes;
    readNames(grid, regions, boundaries, mesh);
    noteFieldData(grid, scanner.source());
    scanner.source().numbered(PartNumbers(), PartNumbers(cells));
    raiseTags(mesh, scanner.source());
    return true;
}

MeshFields fieldsOfVtk(VtkGrid grid, Mesh mesh, const SourceText &source) {
    MeshFields read{std::move(mesh), std::move(grid.pointArrays), {}};
    const auto fits = [&](const std::string &name, std::size_t values, std::size_t items, const char *kind) {
        if (values != items) {
            noteLength(source, grid.offset, name, values, items, kind);
        }
        return values == items;
    };
    for (const auto &[name, values] : read.fields) {
        fits(name, values.size(), read.mesh.nodes.size(), "nodes");
    }
    for (const auto &[name, values] : grid.cellReals) {
        const bool named = std::find(kTagArrays.begin(), kTagArrays.end(), name) != kTagArrays.end();
        if ((named && areWhole(values)) || !fits(name, values.size(), grid.types.size(), "cells")) {
            continue;
        }
        std::vector<double> &ofElements = read.elementFields[name];
        ofElements.reserve(grid.elementCells.size());
        for (const std::int64_t c : grid.elementCells) {
            ofElements.push_back(values[static_cast<std::size_t>(c)]);
        }
    }
    return read;
}

void noteComponents(const SourceText &source, const std::string &name, std::size_t components, std::size_t offset) {
    source.note("vector-values",
                "the array " + inQuotes(name) + " is ignored: it has " + std::to_string(components) +
                    " components; only arrays with one component are read",
                offset);
}

} // namespace forefront

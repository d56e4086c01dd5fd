#include "core/files/vtk/vtk_cells.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

namespace forefront {

std::map<std::string, std::vector<std::int32_t>> vtkNameFields(const Mesh &mesh) {
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

/// Names under which programs write the tags of cells; "MaterialID" is that of our legacy files.
constexpr std::array<std::string_view, 6> kTagArrays = {"region",        "boundary",  "CellEntityIds",
                                                        "gmsh:physical", "medit:ref", "MaterialID"};

/// Returns the first array of tags with one of the usual names.
const std::vector<std::int64_t> *tagArray(const VtkGrid &grid, const char *own) {
    for (const char *name : {own, "CellEntityIds", "gmsh:physical", "medit:ref", "region"}) {
        const auto found = grid.cellArrays.find(name);
        if (found != grid.cellArrays.end() && found->second.size() == grid.types.size()) {
            return &found->second;
        }
    }
    return nullptr;
}

/// Number of cells between two checks of the stop token.
constexpr std::size_t kStopInterval = 4096;

std::int32_t tagAt(const std::vector<std::int64_t> *tags, std::size_t cell) {
    constexpr std::int64_t kGreatest = std::numeric_limits<std::int32_t>::max();
    return tags == nullptr ? 1 : static_cast<std::int32_t>(std::clamp<std::int64_t>((*tags)[cell], 1, kGreatest));
}

void readNames(const VtkGrid &grid, Mesh &mesh) {
    for (const auto &[field, tags] : grid.fields) {
        const bool region = field.starts_with("region:");
        if (!region && !field.starts_with("boundary:")) {
            continue;
        }
        for (const std::int64_t tag : tags) {
            if (tag >= 1 && tag <= std::numeric_limits<std::int32_t>::max()) {
                addName(region ? mesh.regionNames : mesh.boundaryNames, static_cast<std::int32_t>(tag),
                        field.substr(field.find(':') + 1), region);
            }
        }
    }
}

} // namespace

bool meshOfVtk(const VtkGrid &grid, TextScanner &scanner, Mesh &mesh) {
    const auto refuse = [&](const char *code, const std::string &message) {
        return scanner.fail(grid.offset, code, message);
    };
    if (grid.types.size() != grid.ends.size() || grid.nodes.size() >= kNoIndex) {
        return refuse("bad-count", "there are " + std::to_string(grid.ends.size()) + " cells but " +
                                       std::to_string(grid.types.size()) + " cell types");
    }
    const auto *regions = tagArray(grid, "region");
    const auto *boundaries = tagArray(grid, "boundary");
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < grid.types.size(); ++c) {
        if (c % kStopInterval == 0 && scanner.stopped()) {
            return false;
        }
        const std::int64_t end = grid.ends[c];
        const std::int64_t type = grid.types[c];
        const std::int64_t expected = type == kVtkTriangle ? 3 : type == kVtkLine ? 2 : type == kVtkVertex ? 1 : 0;
        if (expected == 0) {
            return refuse("unknown-element", "cell " + std::to_string(c) + " is of VTK type " + std::to_string(type) +
                                                 "; only triangles (5), lines (3) and vertices (1) can be read");
        }
        if (end - begin != expected || begin < 0 || end > static_cast<std::int64_t>(grid.connectivity.size())) {
            return refuse("bad-count", "cell " + std::to_string(c) + " has the wrong number of nodes");
        }
        NodeId nodes[3] = {};
        for (std::int64_t k = begin; k < end; ++k) {
            const std::int64_t node = grid.connectivity[static_cast<std::size_t>(k)];
            if (node < 0 || node >= static_cast<std::int64_t>(grid.nodes.size())) {
                return refuse("bad-index", "cell " + std::to_string(c) + " refers to node " + std::to_string(node) +
                                               ", which does not exist");
            }
            nodes[k - begin] = NodeId{static_cast<std::uint32_t>(node)};
        }
        begin = end;
        if (!requireDistinct(scanner, grid.offset, std::span(nodes).first(static_cast<std::size_t>(expected)),
                             {"cell", c})) {
            return false;
        }
        if (type == kVtkTriangle) {
            mesh.elements.push_back({nodes[0], nodes[1], nodes[2]});
            mesh.regions.push_back(tagAt(regions, c));
        } else if (type == kVtkLine) {
            mesh.edges.push_back({nodes[0], nodes[1], tagAt(boundaries, c)});
        } else {
            mesh.points.push_back({nodes[0], tagAt(boundaries, c)});
        }
    }
    mesh.nodes = grid.nodes;
    readNames(grid, mesh);
    return true;
}

MeshFields fieldsOfVtk(VtkGrid grid, Mesh mesh, const SourceText &source) {
    MeshFields read{std::move(mesh), std::move(grid.pointArrays), {}};
    const auto noteLength = [&](const std::string &name, std::size_t values, std::size_t items, const char *kind) {
        if (values != items) {
            source.note("array-length",
                        "the array " + inQuotes(name) + " is ignored: it has " + std::to_string(values) +
                            " values for " + std::to_string(items) + kind,
                        grid.offset);
        }
        return values == items;
    };
    for (const auto &[name, values] : read.fields) {
        noteLength(name, values.size(), read.mesh.nodes.size(), " nodes");
    }
    for (const auto &[name, values] : grid.cellReals) {
        const bool named = std::find(kTagArrays.begin(), kTagArrays.end(), name) != kTagArrays.end();
        const bool tags =
            named && std::all_of(values.begin(), values.end(), [](double v) { return v == std::trunc(v); });
        if (tags || !noteLength(name, values.size(), grid.types.size(), " cells")) {
            continue;
        }
        if (named) {
            source.note("real-tags",
                        "the array " + inQuotes(name) +
                            " has the name of an array of tags, but its values are not whole numbers; they are read as "
                            "a field, and their whole parts as tags",
                        grid.offset);
        }
        std::vector<double> &ofElements = read.elementFields[name];
        ofElements.reserve(read.mesh.elements.size());
        for (std::size_t c = 0; c < values.size(); ++c) {
            if (grid.types[c] == kVtkTriangle) {
                ofElements.push_back(values[c]);
            }
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

#include "core/engine/base/letter_case.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/vtk_cells.hpp"
#include "core/files/xdmf/xdmf.hpp"
#include "core/files/xdmf/xdmf_items.hpp"
#include "core/files/xdmf/xdmf_types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Whole numbers up to this one are exact as doubles.
constexpr double kExact = 9007199254740992.0;

std::optional<std::int64_t> wholeNumber(double value) {
    return std::fabs(value) <= kExact && value == std::trunc(value) ? std::optional(static_cast<std::int64_t>(value))
                                                                    : std::nullopt;
}

bool areTags(const std::vector<double> &values) {
    return std::all_of(values.begin(), values.end(), [](double v) {
        return v == std::trunc(v) && std::fabs(v) <= std::numeric_limits<std::int32_t>::max();
    });
}

const XdmfType *xdmfNamed(const std::string &name) {
    for (const XdmfType &type : kXdmfTypes) {
        if (name == lowerCase(type.name) || (type.other != nullptr && name == lowerCase(type.other))) {
            return &type;
        }
    }
    return nullptr;
}

const XdmfType *xdmfNumbered(std::int64_t number) {
    const auto found = std::find_if(kXdmfTypes.begin(), kXdmfTypes.end(),
                                    [number](const XdmfType &type) { return type.number == number; });
    return found != kXdmfTypes.end() ? &*found : nullptr;
}

/// The cells of one grid.
struct GridCells {
    std::vector<CellKind> kinds;
    std::vector<std::int64_t> connectivity; ///< the nodes of the cells, one after the other
};

/// Collects the uniform grids of a file, in their order, without recursion: a file may nest them deeply.
struct GridWalker final : pugi::xml_tree_walker {
    bool for_each(pugi::xml_node &node) override {
        if (std::string_view(node.name()) == "Grid" &&
            lowerCase(node.attribute("GridType").as_string("Uniform")) == "uniform") {
            grids.push_back(node);
        }
        items += std::string_view(node.name()) == "DataItem" ? 1 : 0;
        return true;
    }
    std::vector<pugi::xml_node> grids;
    std::size_t items = 0; ///< arrays of numbers
};

class XdmfReader {
  public:
    explicit XdmfReader(const SourceText &source) : scanner_(source) {}

    Result<MeshFields> read() {
        Mesh mesh;
        if (!parse() || !findMesh() || !otherGrids() || !names() || !finishTags() ||
            !meshOfVtk(grid_, scanner_, mesh)) {
            return scanner_.faults();
        }
        return fieldsOfVtk(std::move(grid_), std::move(mesh), scanner_.source());
    }

  private:
    bool parse() {
        const std::string_view text = scanner_.source().text;
        const pugi::xml_parse_result parsed = xml_.load_buffer(text.data(), text.size());
        if (!parsed) {
            return scanner_.fail(static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)), "xml-syntax",
                                 std::string("the XML is malformed: ") + parsed.description());
        }
        const pugi::xml_node domain = xml_.child("Xdmf").child("Domain");
        if (!domain) {
            return scanner_.fail(0, "bad-syntax", "the file has no <Xdmf> with a <Domain>");
        }
        GridWalker walker;
        pugi::xml_node root = domain;
        root.traverse(walker);
        grids_ = std::move(walker.grids);
        items_ = walker.items;
        return true;
    }

    /// Reads the numbers of an element. Reading is reported, and can be cancelled, array by array.
    bool readItem(const pugi::xml_node &parent, XdmfNumbers &numbers) {
        const SourceText &source = scanner_.source();
        if (scanner_.stopped()) {
            return false;
        }
        source.options.progress(
            "reading " + std::filesystem::path(source.name).filename().string(),
            std::min(1.0, static_cast<double>(itemsRead_) / static_cast<double>(std::max<std::size_t>(items_, 1))));
        ++itemsRead_;
        return readXdmfItem(scanner_, parent, numbers);
    }

    /// Reads the first grid with elements: nodes, elements, tags and values.
    bool findMesh() {
        for (const pugi::xml_node grid : grids_) {
            const pugi::xml_node topology = grid.child("Topology");
            if (!topology) {
                continue;
            }
            GridCells cells;
            if (!readCells(topology, cells)) {
                return false;
            }
            if (std::any_of(cells.kinds.begin(), cells.kinds.end(),
                            [](CellKind kind) { return traitsOf(kind).dimension == 2; })) {
                mesh_ = grid;
                grid_.offset = offsetOfXml(topology);
                return readNodes(grid.child("Geometry")) && addCells(cells) && meshArrays();
            }
        }
        return scanner_.fail(0, "no-elements", "no grid of the file has triangles or quadrilaterals");
    }

    bool readNodes(const pugi::xml_node &geometry) {
        const std::string type =
            upperCase(geometry.attribute("GeometryType").as_string(geometry.attribute("Type").as_string("XYZ")));
        const std::size_t place = offsetOfXml(geometry ? geometry : mesh_);
        XdmfNumbers numbers;
        if (!geometry || (type != "XY" && type != "XYZ")) {
            return scanner_.fail(place, "bad-syntax",
                                 geometry ? "expected a geometry of type XY or XYZ, found " + inQuotes(type)
                                          : "the grid has no nodes of its own");
        }
        if (!readItem(geometry, numbers)) {
            return false;
        }
        const std::size_t width = type == "XY" ? 2 : 3;
        if (numbers.values.size() % width != 0) {
            return scanner_.fail(place, "bad-count",
                                 "the number of coordinates is not a multiple of " + std::to_string(width));
        }
        Box2 box;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t k = 0; k < numbers.values.size(); k += width) {
            const Vec2 node{numbers.values[k], numbers.values[k + 1]};
            const double z = width == 3 ? numbers.values[k + 2] : 0.0;
            if (!isFinite(node) || !std::isfinite(z)) {
                return scanner_.fail(place, "non-finite",
                                     "the coordinates of node " + std::to_string(k / width) + " must be finite");
            }
            box.add(node);
            low = std::min(low, z);
            high = std::max(high, z);
            grid_.nodes.push_back(node);
        }
        constexpr double kFlat = 1e-9;
        return !(high - low > kFlat * box.diagonal()) ||
               scanner_.fail(place, "not-planar", "the nodes do not lie in one plane z = constant");
    }

    bool readCells(const pugi::xml_node &topology, GridCells &cells) {
        const std::string name = topology.attribute("TopologyType").as_string(topology.attribute("Type").value());
        const std::size_t place = offsetOfXml(topology);
        const XdmfType *const type = xdmfNamed(lowerCase(name));
        if (type == nullptr && lowerCase(name) != "mixed") {
            return scanner_.fail(place, "unknown-element",
                                 "the cells are of XDMF type " + inQuotes(name) + "; only " + kReadableCells +
                                     " can be read");
        }
        XdmfNumbers numbers;
        if (!readItem(topology, numbers)) {
            return false;
        }
        std::vector<std::int64_t> words;
        words.reserve(numbers.values.size());
        for (const double value : numbers.values) {
            const std::optional<std::int64_t> word = wholeNumber(value);
            if (!word) {
                return scanner_.fail(place, "bad-index", "the cells refer to a node that is not a whole number");
            }
            words.push_back(*word);
        }
        return type != nullptr ? sameCells(*type, std::move(words), numbers.columns(), place, cells)
                               : mixedCells(words, place, cells);
    }

    bool sameCells(const XdmfType &type, std::vector<std::int64_t> nodes, std::size_t columns, std::size_t place,
                   GridCells &cells) {
        const std::size_t width = traitsOf(type.kind).nodes;
        if (nodes.size() % width != 0 || (columns != width && columns != 1 && !nodes.empty())) {
            return scanner_.fail(place, "bad-count",
                                 "cells of XDMF type " + std::string(type.name) + " have " + std::to_string(width) +
                                     (width == 1 ? " node" : " nodes") + ", but the array has " +
                                     std::to_string(columns) + " in each row");
        }
        cells.kinds.assign(nodes.size() / width, type.kind);
        cells.connectivity = std::move(nodes);
        return true;
    }

    bool mixedCells(const std::vector<std::int64_t> &words, std::size_t place, GridCells &cells) {
        for (std::size_t at = 0; at < words.size();) {
            const XdmfType *const type = xdmfNumbered(words[at++]);
            if (type == nullptr) {
                return scanner_.fail(place, "unknown-element",
                                     "cell " + std::to_string(cells.kinds.size()) + " is of XDMF type " +
                                         std::to_string(words[at - 1]) + "; only " + kReadableCells + " can be read");
            }
            const std::size_t width = traitsOf(type->kind).nodes;
            const bool counted = xdmfCounted(type->kind);
            if (words.size() - at < width + (counted ? 1 : 0) ||
                (counted && words[at++] != static_cast<std::int64_t>(width))) {
                return scanner_.fail(place, "bad-count",
                                     "cell " + std::to_string(cells.kinds.size()) + " has the wrong number of nodes");
            }
            cells.kinds.push_back(type->kind);
            cells.connectivity.insert(cells.connectivity.end(), words.begin() + static_cast<std::ptrdiff_t>(at),
                                      words.begin() + static_cast<std::ptrdiff_t>(at + width));
            at += width;
        }
        return true;
    }

    bool addCells(const GridCells &cells) {
        for (const CellKind kind : cells.kinds) {
            grid_.types.push_back(traitsOf(kind).vtk);
            grid_.ends.push_back((grid_.ends.empty() ? 0 : grid_.ends.back()) + traitsOf(kind).nodes);
        }
        grid_.connectivity.insert(grid_.connectivity.end(), cells.connectivity.begin(), cells.connectivity.end());
        return true;
    }

    /// Reads the scalar arrays of a grid with one value for each of `count` cells or nodes; notes the others.
    bool scalars(const pugi::xml_node &grid, std::string_view centre, std::size_t count,
                 std::map<std::string, std::vector<double>> &target) {
        for (const pugi::xml_node attribute : grid.children("Attribute")) {
            const std::string name = attribute.attribute("Name").value();
            if (attribute.attribute("Center").as_string("Node") != centre) {
                continue;
            }
            XdmfNumbers numbers;
            if (!readItem(attribute, numbers)) {
                return false;
            }
            if (numbers.values.size() == count) {
                target.emplace(name, std::move(numbers.values));
            } else if (count != 0 && numbers.values.size() % count == 0) {
                noteComponents(scanner_.source(), name, numbers.values.size() / count, offsetOfXml(attribute));
            } else {
                scanner_.source().note("array-length",
                                       "the array " + inQuotes(name) + " is ignored: it has " +
                                           std::to_string(numbers.values.size()) + " values for " +
                                           std::to_string(count) + (centre == "Cell" ? " cells" : " nodes"),
                                       offsetOfXml(attribute));
            }
        }
        return true;
    }

    /// Takes the arrays of the mesh: "region", or else the only one of whole numbers, are tags.
    bool meshArrays() {
        elements_ = grid_.types.size();
        std::map<std::string, std::vector<double>> ofCells;
        if (!scalars(mesh_, "Node", grid_.nodes.size(), grid_.pointArrays) ||
            !scalars(mesh_, "Cell", elements_, ofCells)) {
            return false;
        }
        auto tags = ofCells.find(std::string(kXdmfRegion));
        if (tags == ofCells.end() && ofCells.size() == 1) {
            tags = ofCells.begin();
        }
        if (tags != ofCells.end() && areTags(tags->second)) {
            regions_ = std::move(tags->second);
            ofCells.erase(tags);
        }
        grid_.cellReals = std::move(ofCells);
        return true;
    }

    /// Reads the other grids: boundary parts and points, tags of the elements, and values.
    bool otherGrids() {
        boundaries_.assign(elements_, 0.0);
        for (const pugi::xml_node grid : grids_) {
            if (grid == mesh_) {
                continue;
            }
            const pugi::xml_node topology = grid.child("Topology");
            if (!topology ? !furtherValues(grid) : sharesNodes(grid) ? !tagsOfGrid(grid, topology) : !noteGrid(grid)) {
                return false;
            }
        }
        return true;
    }

    /// Returns true if a grid is known to lie on the nodes of the mesh.
    bool sharesNodes(const pugi::xml_node &grid) const {
        const pugi::xml_node own = grid.child("Geometry");
        const std::string_view array = own.child("DataItem").child_value();
        return !own || own.attribute("Reference") ||
               (!array.empty() && array == mesh_.child("Geometry").child("DataItem").child_value());
    }

    bool noteGrid(const pugi::xml_node &grid) {
        scanner_.source().note("xdmf-grid",
                               "the grid " + inQuotes(grid.attribute("Name").value()) +
                                   " is ignored: it has other nodes than the mesh",
                               offsetOfXml(grid));
        return true;
    }

    /// Reads the values of a grid that includes the cells of another, as FEniCSx writes functions.
    bool furtherValues(const pugi::xml_node &grid) {
        std::map<std::string, std::vector<double>> found;
        if (!scalars(grid, "Node", grid_.nodes.size(), found) || !scalars(grid, "Cell", elements_, grid_.cellReals)) {
            return false;
        }
        for (auto &[name, values] : found) {
            if (!grid_.pointArrays.emplace(name, std::move(values)).second) {
                scanner_.source().note("xdmf-time", "further times of " + inQuotes(name) + " are ignored",
                                       offsetOfXml(grid));
            }
        }
        return true;
    }

    bool tagsOfGrid(const pugi::xml_node &grid, const pugi::xml_node &topology) {
        GridCells cells;
        std::map<std::string, std::vector<double>> arrays;
        if (!readCells(topology, cells) || !scalars(grid, "Cell", cells.kinds.size(), arrays)) {
            return false;
        }
        const auto tags =
            std::find_if(arrays.begin(), arrays.end(), [](const auto &each) { return areTags(each.second); });
        if (tags == arrays.end()) {
            scanner_.source().note(
                "xdmf-grid", "the grid " + inQuotes(grid.attribute("Name").value()) + " is ignored: it has no tags",
                offsetOfXml(grid));
            return true;
        }
        const bool elements = std::any_of(cells.kinds.begin(), cells.kinds.end(),
                                          [](CellKind kind) { return traitsOf(kind).dimension == 2; });
        if (elements) {
            return tagElements(cells, tags->second);
        }
        boundaries_.insert(boundaries_.end(), tags->second.begin(), tags->second.end());
        return addCells(cells);
    }

    using Corners = std::array<std::int64_t, kMaxCellCorners>;

    static Corners cornersOf(CellKind kind, const std::int64_t *nodes) {
        Corners corners{-1, -1, -1, -1};
        std::copy_n(nodes, traitsOf(kind).corners, corners.begin());
        std::sort(corners.begin(), corners.end());
        return corners;
    }

    /// Gives elements the tags of the cells with the same corners, unless they have tags already.
    bool tagElements(const GridCells &cells, const std::vector<double> &tags) {
        if (!regions_.empty()) {
            return true;
        }
        std::map<Corners, double> known;
        const std::int64_t *nodes = cells.connectivity.data();
        for (std::size_t c = 0; c < cells.kinds.size(); ++c) {
            known.emplace(cornersOf(cells.kinds[c], nodes), tags[c]);
            nodes += traitsOf(cells.kinds[c]).nodes;
        }
        std::int64_t begin = 0;
        for (std::size_t c = 0; c < elements_; ++c) {
            const std::optional<CellKind> kind = cellNumbered(&CellTraits::vtk, grid_.types[c]);
            const auto found = known.find(cornersOf(*kind, grid_.connectivity.data() + begin));
            regions_.push_back(found != known.end() ? found->second : 0.0);
            begin = grid_.ends[c];
        }
        return true;
    }

    /// Reads <Information Name="region 3" Value="steel"/>.
    bool names() {
        for (const pugi::xml_node item : xml_.child("Xdmf").child("Domain").children("Information")) {
            const std::string_view key = item.attribute("Name").value();
            const std::size_t blank = key.find(' ');
            const std::string_view kind = key.substr(0, blank);
            if (blank == std::string_view::npos || (kind != kXdmfRegion && kind != kXdmfBoundary)) {
                continue;
            }
            const std::optional<double> number = parseReal(key.substr(blank + 1));
            const std::optional<std::int64_t> tag = number ? wholeNumber(*number) : std::nullopt;
            if (tag) {
                grid_.fields[std::string(kind) + ':' + item.attribute("Value").value()].push_back(*tag);
            }
        }
        return true;
    }

    bool finishTags() {
        if (!regions_.empty()) {
            regions_.resize(grid_.types.size(), 0.0);
            grid_.cellArrays[std::string(kXdmfRegion)] = std::move(regions_);
        }
        if (grid_.types.size() > elements_) {
            grid_.cellArrays[std::string(kXdmfBoundary)] = std::move(boundaries_);
        }
        for (auto &[name, values] : grid_.cellReals) {
            values.resize(grid_.types.size(), std::numeric_limits<double>::quiet_NaN());
        }
        return true;
    }

    TextScanner scanner_;
    pugi::xml_document xml_;
    std::vector<pugi::xml_node> grids_;
    std::size_t items_ = 0, itemsRead_ = 0; ///< arrays of numbers
    pugi::xml_node mesh_;                   ///< the grid of the elements
    VtkGrid grid_;
    std::size_t elements_ = 0;                 ///< cells of that grid
    std::vector<double> regions_, boundaries_; ///< tags of all cells; regions_ is empty if there are none
};

} // namespace

bool looksLikeXdmf(std::string_view head) {
    return head.find("<Xdmf") != std::string_view::npos;
}

Result<MeshFields> readXdmfFields(const SourceText &source) {
    return XdmfReader(source).read();
}

Result<Mesh> readXdmf(const SourceText &source) {
    Result<MeshFields> fields = readXdmfFields(source);
    return fields ? Result<Mesh>(std::move(fields->mesh)) : fields.faults();
}

} // namespace forefront

#include "core/engine/base/letter_case.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/common/vtk_cells.hpp"
#include "core/files/vtk/vtk.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <span>

namespace forefront {

namespace {

/// VTK reads words of at most 255 bytes.
constexpr std::size_t kMaximumNameBytes = 200;

std::string nameWord(const std::string &name) {
    std::size_t bytes = kMaximumNameBytes;
    std::string word;
    do {
        word = percentEncoded(shortened(validUtf8(name), bytes--), " ");
    } while (word.size() > kMaximumNameBytes);
    return word;
}

/// Writes the names of tags. Legacy files have no place for names that every reader skips: a FIELD block before POINTS
/// stops Gmsh, FreeFem++ and deal.II, and deal.II expects as many values in it as there are cells. All of them skip
/// look-up tables, so each name is that of a table of one colour: "boundary:3:inlet".
void writeNames(const MeshView &mesh, TextWriter &out) {
    const TagList tags = tagsOf(mesh);
    const auto table = [&](const char *kind, std::int32_t tag, const std::string &name) {
        out << "LOOKUP_TABLE " << kind << ':' << tag << ':' << nameWord(name) << " 1\n0.5 0.5 0.5 1\n";
    };
    auto boundaries = tags.points;
    boundaries.insert(tags.edges.begin(), tags.edges.end());
    for (const auto &[tag, name] : boundaries) {
        if (name != boundaryName({}, tag)) {
            table("boundary", tag, name);
        }
    }
    for (const auto &[tag, name] : tags.regions) {
        if (name != regionName({}, tag)) {
            table("region", tag, name);
        }
    }
}

} // namespace

/// Writes version 3.0, ASCII. `MaterialID` is the region of elements and the boundary tag of lines and vertices, as
/// deal.II expects it first; the arrays `region` and `boundary` hold the two apart, 0 where they do not apply.
void writeVtk(const MeshView &mesh, TextWriter &out) {
    const std::size_t cells = mesh.elementCount() + mesh.edges.size() + mesh.points.size();
    out << "# vtk DataFile Version 3.0\n" << titleOf(mesh) << "\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    out << "POINTS " << mesh.nodes.size() << " double\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << " 0\n";
    }
    out << "CELLS " << cells << ' ' << cells + nodesOfElements(mesh) + nodesOfEdges(mesh) + mesh.points.size() << '\n';
    const auto writeCell = [&](const auto &nodes) {
        out << nodes.size();
        for (const NodeId node : nodes) {
            out << ' ' << index(node);
        }
        out << '\n';
    };
    const auto forEachCell = [&](auto element, auto edge, auto point) {
        for (const MeshView::Block &block : mesh.blocks()) {
            for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
                element(block, k);
            }
        }
        std::for_each(mesh.edges.begin(), mesh.edges.end(), edge);
        std::for_each(mesh.points.begin(), mesh.points.end(), point);
    };
    using Block = MeshView::Block;
    forEachCell([&](const Block &block, std::size_t k) { writeCell(block.nodesOf(k)); },
                [&](const TaggedEdge &edge) { writeCell(EdgeNodes(edge)); },
                [&](const TaggedNode &point) { writeCell(std::span(&point.node, 1)); });
    const auto column = [&](auto element, auto edge, auto point) {
        forEachCell([&](const Block &block, std::size_t k) { out << element(block, k) << '\n'; },
                    [&](const TaggedEdge &item) { out << edge(item) << '\n'; },
                    [&](const TaggedNode &item) { out << point(item) << '\n'; });
    };
    const auto none = [](const auto &...) { return 0; };
    const auto region = [](const Block &block, std::size_t k) { return block.region(k); };
    const auto tag = [](const auto &item) { return item.tag; };
    out << "CELL_TYPES " << cells << '\n';
    column([](const Block &block, std::size_t) { return block.traits().vtk; },
           [](const TaggedEdge &edge) { return traitsOf(cellKindOf(edge)).vtk; },
           [](const TaggedNode &) { return traitsOf(CellKind::Point).vtk; });
    out << "CELL_DATA " << cells << "\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n";
    column(region, tag, tag);
    out << "FIELD FieldData 2\nregion 1 " << cells << " int\n";
    column(region, none, none);
    out << "boundary 1 " << cells << " int\n";
    column(none, tag, tag);
    writeNames(mesh, out);
}

namespace {

constexpr std::int64_t kAny = std::numeric_limits<std::int64_t>::max();

class VtkReader {
  public:
    explicit VtkReader(const SourceText &source) : scanner_(source) {}

    Result<Mesh> read() {
        Mesh mesh;
        if (header()) {
            while (scanner_.ok() && !scanner_.atEnd()) {
                const std::size_t place = scanner_.offset();
                section(scanner_.word(), place);
            }
        }
        if (scanner_.ok() && !builder_.finishNodes(scanner_)) {
            return scanner_.faults();
        }
        grid_.nodes = std::move(builder_.mesh.nodes);
        if (!scanner_.ok() || !meshOfVtk(grid_, scanner_, mesh)) {
            return scanner_.faults();
        }
        return mesh;
    }

    MeshFields takeFields(Mesh mesh) { return fieldsOfVtk(std::move(grid_), std::move(mesh), scanner_.source()); }

  private:
    bool header() {
        scanner_.skipLine();
        scanner_.skipLine();
        const std::size_t place = scanner_.offset();
        const std::string_view kind = scanner_.word();
        if (upperCase(kind) == "BINARY") {
            return scanner_.fail(place, "binary", "binary VTK legacy files cannot be read",
                                 "save it as ASCII or as VTU");
        }
        if (upperCase(kind) != "ASCII") {
            return scanner_.fail(place, "bad-syntax", "expected ASCII on the third line, found " + inQuotes(kind));
        }
        return literal("DATASET") && literal("UNSTRUCTURED_GRID");
    }

    /// VTK reads its keywords in any case.
    bool isNext(std::string_view expected) { return upperCase(scanner_.peek()) == expected; }
    bool literal(std::string_view expected) {
        if (isNext(expected)) {
            scanner_.word();
            return true;
        }
        return scanner_.literal(expected);
    }

    bool section(std::string_view given, std::size_t place) {
        const std::string word = upperCase(given);
        std::size_t count = 0;
        if (word == "POINTS" && builder_.mesh.nodes.empty()) {
            return points();
        }
        if (word == "CELLS" && grid_.ends.empty()) {
            grid_.offset = place;
            return cells();
        }
        if (word == "CELL_TYPES" && grid_.types.empty()) {
            return scanner_.count(count, 2, {"the number of cell types"}) &&
                   integers(count, grid_.types, "a cell type");
        }
        if (word == "CELL_DATA" || word == "POINT_DATA") {
            inCells_ = word == "CELL_DATA";
            return scanner_.count(items_, 1, {"the number of values"});
        }
        if (word == "FIELD") {
            return field();
        }
        if (word == "SCALARS") {
            return scalars();
        }
        if (word == "VECTORS" || word == "NORMALS") {
            return vectors();
        }
        if (word == "LOOKUP_TABLE") {
            return lookupTable();
        }
        if (word == "METADATA") {
            const std::size_t blank = scanner_.source().text.find("\n\n", scanner_.offset());
            scanner_.seek(blank == std::string_view::npos ? scanner_.source().text.size() : blank);
            return true;
        }
        return scanner_.fail(place, "unknown-section", "the section " + inQuotes(given) + " cannot be read");
    }

    bool points() {
        std::size_t count = 0;
        if (!scanner_.count(count, 6, {"the number of points"})) {
            return false;
        }
        scanner_.word();
        builder_.reserveNodes(count);
        for (std::size_t k = 0; k < count; ++k) {
            if (!builder_.readNode(scanner_, static_cast<std::int64_t>(k), 3)) {
                return false;
            }
        }
        return true;
    }

    /// Reads the cells. Up to version 4: "CELLS n size", each cell as its number of nodes, then the nodes; from version
    /// 5 on: offsets and connectivity.
    bool cells() {
        std::size_t count = 0, size = 0;
        if (!scanner_.count(count, 2, {"the number of cells"}) || !scanner_.count(size, 2, {"the size of the cells"})) {
            return false;
        }
        if (isNext("OFFSETS")) {
            scanner_.word();
            scanner_.word();
            if (!integers(count, grid_.ends, "an offset") || !literal("CONNECTIVITY")) {
                return false;
            }
            if (!grid_.ends.empty()) {
                grid_.ends.erase(grid_.ends.begin());
            }
            scanner_.word();
            return integers(size, grid_.connectivity, "a node of a cell");
        }
        grid_.ends.reserve(count);
        for (std::size_t c = 0; c < count; ++c) {
            std::size_t nodes = 0;
            if (!scanner_.count(nodes, 2, {"the number of nodes of cell", c}) ||
                !integers(nodes, grid_.connectivity, "a node of a cell")) {
                return false;
            }
            grid_.ends.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
        }
        return true;
    }

    bool integers(std::size_t count, std::vector<std::int64_t> &values, const char *what) {
        std::int64_t value = 0;
        for (std::size_t k = 0; k < count; ++k) {
            if (!scanner_.integer(value, -kAny, kAny, {what})) {
                return false;
            }
            values.push_back(value);
        }
        return true;
    }

    bool values(std::size_t count, std::vector<double> &kept) {
        double value = 0.0;
        for (std::size_t k = 0; k < count; ++k) {
            if (!scanner_.real(value, {"a value"})) {
                return false;
            }
            kept.push_back(value);
        }
        return true;
    }

    /// Returns values as tags: 0 for those too large to be one.
    static std::vector<std::int64_t> tagsOf(const std::vector<double> &reals) {
        constexpr double kWhole = 1e15;
        std::vector<std::int64_t> tags(reals.size());
        std::transform(reals.begin(), reals.end(), tags.begin(), [](double value) {
            return value > -kWhole && value < kWhole ? static_cast<std::int64_t>(value) : 0;
        });
        return tags;
    }

    /// Reads the values of an array after its header; keeps those of points and cells with one component.
    bool arrayOf(const std::string &name, std::size_t components, std::size_t tuples) {
        const std::size_t place = scanner_.offset();
        std::vector<double> reals;
        const bool fits = components == 0 || tuples <= scanner_.remaining() / components + 1;
        if (!fits || !values(components * tuples, reals)) {
            return scanner_.fail(place, "bad-count", "fewer values follow than declared");
        }
        if (items_ == 0) {
            grid_.fields[name] = tagsOf(reals);
        } else if (components != 1) {
            noteComponents(scanner_.source(), name, components, place);
        } else if (inCells_) {
            grid_.cellArrays[name] = reals;
            grid_.cellReals[name] = std::move(reals);
        } else {
            grid_.pointArrays[name] = std::move(reals);
        }
        return true;
    }

    bool vectors() {
        const std::string name = percentDecoded(scanner_.word());
        scanner_.word();
        return arrayOf(name, 3, items_);
    }

    bool scalars() {
        const std::string name = percentDecoded(scanner_.word());
        scanner_.word();
        std::size_t components = 1;
        if (!isNext("LOOKUP_TABLE") && !scanner_.count(components, 1, {"the number of components"})) {
            return false;
        }
        if (isNext("LOOKUP_TABLE")) {
            scanner_.skipLine();
        }
        return arrayOf(name, components, items_);
    }

    /// Reads a look-up table; our writer uses them for names of tags.
    bool lookupTable() {
        constexpr std::size_t kComponents = 4;
        const std::string name = percentDecoded(scanner_.word());
        std::size_t colours = 0;
        double component = 0.0;
        if (!scanner_.count(colours, 2 * kComponents, {"the number of colours"})) {
            return false;
        }
        for (std::size_t k = 0; k < kComponents * colours; ++k) {
            if (!scanner_.real(component, {"a colour"})) {
                return false;
            }
        }
        const std::size_t first = name.find(':');
        const std::size_t second = first == std::string::npos ? first : name.find(':', first + 1);
        std::int64_t tag = 0;
        if (second != std::string::npos &&
            std::from_chars(name.data() + first + 1, name.data() + second, tag).ptr == name.data() + second) {
            grid_.fields[name.substr(0, first) + name.substr(second)].push_back(tag);
        }
        return true;
    }

    bool field() {
        std::size_t arrays = 0;
        scanner_.word();
        if (!scanner_.count(arrays, 8, {"the number of arrays"})) {
            return false;
        }
        for (std::size_t k = 0; k < arrays; ++k) {
            const std::string name = percentDecoded(scanner_.word());
            std::size_t components = 0, tuples = 0;
            if (!scanner_.count(components, 1, {"the number of components"}) ||
                !scanner_.count(tuples, 1, {"the number of tuples"})) {
                return false;
            }
            const std::size_t place = scanner_.offset();
            const std::string_view type = scanner_.word();
            if (lowerCase(type) == "string") {
                return scanner_.fail(place, "unknown-section", "arrays of strings cannot be read");
            }
            if (!arrayOf(name, components, tuples)) {
                return false;
            }
            if (isNext("METADATA")) {
                const std::size_t metadata = scanner_.offset();
                section(scanner_.word(), metadata);
            }
        }
        return scanner_.ok();
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    VtkGrid grid_;
    std::size_t items_ = 0; ///< values of an array in the current CELL_DATA or POINT_DATA; 0: before them
    bool inCells_ = false;
};

} // namespace

bool looksLikeVtk(std::string_view head) {
    return head.starts_with("# vtk DataFile");
}

Result<Mesh> readVtk(const SourceText &source) {
    return VtkReader(source).read();
}

Result<MeshFields> readVtkFields(const SourceText &source) {
    VtkReader reader(source);
    Result<Mesh> mesh = reader.read();
    if (!mesh) {
        return mesh.faults();
    }
    return reader.takeFields(std::move(*mesh));
}

} // namespace forefront

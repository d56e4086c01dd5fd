#include "core/files/common/names.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/components/hdf5_component.hpp"
#include "core/files/text/xml_text.hpp"
#include "core/files/xdmf/xdmf.hpp"
#include "core/files/xdmf/xdmf_types.hpp"

#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// The cells of a grid: of one kind, or each after its number.
class XdmfCells {
  public:
    /// `kinds`: of the cells that will be added.
    explicit XdmfCells(const std::set<CellKind> &kinds) : mixed_(kinds.size() > 1) {
        if (!mixed_ && !kinds.empty()) {
            kind_ = *kinds.begin();
        }
    }

    template <class Nodes>
    void add(CellKind kind, const Nodes &nodes, std::int32_t tag) {
        if (mixed_) {
            connectivity.push_back(xdmfTypeOf(kind).number);
            if (xdmfCounted(kind)) {
                connectivity.push_back(traitsOf(kind).nodes);
            }
        }
        for (const NodeId node : nodes) {
            connectivity.push_back(index(node));
        }
        tags.push_back(tag);
    }
    std::vector<std::uint64_t> dimensions() const {
        return mixed_ ? std::vector<std::uint64_t>{connectivity.size()}
                      : std::vector<std::uint64_t>{tags.size(), traitsOf(kind_).nodes};
    }
    /// Returns the attributes of <Topology>.
    std::string type() const {
        return mixed_ ? "TopologyType=\"Mixed\" NumberOfElements=\"" + std::to_string(tags.size()) + '"'
                      : "TopologyType=\"" + std::string(xdmfTypeOf(kind_).name) + "\" NumberOfElements=\"" +
                            std::to_string(tags.size()) + "\" NodesPerElement=\"" +
                            std::to_string(traitsOf(kind_).nodes) + '"';
    }

    std::vector<std::int64_t> connectivity;
    std::vector<std::int32_t> tags; ///< per cell

  private:
    bool mixed_;
    CellKind kind_ = CellKind::Triangle3;
};

XdmfCells elementsOf(const MeshView &mesh) {
    std::set<CellKind> kinds;
    for (const MeshView::Block &block : mesh.blocks()) {
        kinds.insert(block.kind);
    }
    XdmfCells cells(kinds);
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            cells.add(block.kind, block.nodesOf(k), block.region(k));
        }
    }
    return cells;
}

XdmfCells edgesOf(const MeshView &mesh) {
    std::set<CellKind> kinds;
    for (const TaggedEdge &edge : mesh.edges) {
        kinds.insert(cellKindOf(edge));
    }
    XdmfCells cells(kinds);
    for (const TaggedEdge &edge : mesh.edges) {
        cells.add(cellKindOf(edge), EdgeNodes(edge), edge.tag);
    }
    return cells;
}

XdmfCells pointsOf(const MeshView &mesh) {
    XdmfCells cells({CellKind::Point});
    for (const TaggedNode &point : mesh.points) {
        cells.add(CellKind::Point, std::span(&point.node, 1), point.tag);
    }
    return cells;
}

/// Writes the description of a mesh and collects its arrays.
class XdmfWriter {
  public:
    /// `arrays`: the name of the file with the arrays.
    XdmfWriter(const MeshView &mesh, const std::string &arrays) : mesh_(mesh), file_(xmlEscaped(arrays)) {
        head();
        grid("mesh", kXdmfRegion, elementsOf(mesh));
        grid(kXdmfBoundary, kXdmfBoundary, edgesOf(mesh));
        grid(kXdmfPoints, kXdmfPoints, pointsOf(mesh));
        text_ += "</Domain>\n</Xdmf>\n";
    }

    const std::string &text() const { return text_; }
    const std::vector<Hdf5Array> &arrays() const { return arrays_; }

  private:
    void head() {
        text_ = "<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n"
                "<Xdmf Version=\"3.0\" xmlns:xi=\"https://www.w3.org/2001/XInclude\">\n<Domain>\n";
        const TagList tags = tagsOf(mesh_);
        auto boundaries = tags.points;
        boundaries.insert(tags.edges.begin(), tags.edges.end());
        for (const auto &[kind, names] : {std::pair(kXdmfRegion, tags.regions), std::pair(kXdmfBoundary, boundaries)}) {
            for (const auto &[tag, name] : names) {
                text_ += "<Information Name=\"" + std::string(kind) + ' ' + std::to_string(tag) + "\" Value=\"" +
                         xmlEscaped(validUtf8(name)) + "\"/>\n";
            }
        }
    }

    void grid(std::string_view name, std::string_view attribute, XdmfCells cells) {
        if (cells.tags.empty() && attribute != kXdmfRegion) {
            return;
        }
        const std::string group = "/Mesh/" + std::string(name);
        const XdmfCells &kept = cells_.emplace_back(std::move(cells));
        text_ += "<Grid Name=\"" + std::string(name) + "\" GridType=\"Uniform\">\n<Topology " + kept.type() + ">\n";
        item(group + "/topology", Hdf5Number::Int64, kept.dimensions(), kept.connectivity.data());
        text_ += "</Topology>\n<Geometry GeometryType=\"XY\">\n";
        item("/Mesh/mesh/geometry", Hdf5Number::Real64, {mesh_.nodes.size(), 2}, mesh_.nodes.data());
        text_ += "</Geometry>\n";
        values(attribute, "Cell", group, Hdf5Number::Int32, kept.tags.size(), kept.tags.data());
        if (attribute == kXdmfRegion && !mesh_.elevations.empty()) {
            values("elevation", "Node", group, Hdf5Number::Real64, mesh_.nodes.size(), mesh_.elevations.data());
        }
        text_ += "</Grid>\n";
    }

    void values(std::string_view name, const char *centre, const std::string &group, Hdf5Number type, std::size_t count,
                const void *values) {
        text_ += "<Attribute Name=\"" + std::string(name) + "\" AttributeType=\"Scalar\" Center=\"" + centre + "\">\n";
        item(group + '/' + std::string(name), type, {count, 1}, values);
        text_ += "</Attribute>\n";
    }

    void item(const std::string &path, Hdf5Number type, const std::vector<std::uint64_t> &dimensions,
              const void *values) {
        std::string sizes;
        for (const std::uint64_t dimension : dimensions) {
            sizes += (sizes.empty() ? "" : " ") + std::to_string(dimension);
        }
        text_ += "<DataItem Dimensions=\"" + sizes + "\" NumberType=\"" +
                 (type == Hdf5Number::Real64 ? "Float\"" : "Int\"") + " Precision=\"" +
                 (type == Hdf5Number::Int32 ? "4" : "8") + "\" Format=\"HDF\">" + file_ + ':' + path + "</DataItem>\n";
        if (paths_.insert(path).second) {
            arrays_.push_back({path, type, dimensions, values});
        }
    }

    const MeshView &mesh_;
    std::string file_, text_;
    std::deque<XdmfCells> cells_; ///< the arrays point into them
    std::set<std::string> paths_; ///< of the arrays
    std::vector<Hdf5Array> arrays_;
};

} // namespace

static_assert(sizeof(Vec2) == 2 * sizeof(double), "nodes are written as rows of two numbers");

Status writeXdmf(FileSet &files, const std::filesystem::path &path, const MeshView &mesh, const ExportOptions &,
                 const Progress &progress) {
    const Result<const Hdf5Functions *> hdf5 = hdf5Component();
    if (!hdf5) {
        return hdf5.faults();
    }
    std::filesystem::path description = path, arrays = path;
    description.replace_extension(kXdmfExtensions[0]);
    arrays.replace_extension(kXdmfExtensions[1]);
    const XdmfWriter writer(mesh, arrays.filename().string());
    std::string bytes, message;
    if (!(*hdf5)->write(writer.arrays(), bytes, message)) {
        return error("cannot-write", message);
    }
    files.write(
        arrays, [&](TextWriter &out) { out << bytes; }, progress, bytes.size());
    files.write(description, writer.text());
    return files.status();
}

} // namespace forefront

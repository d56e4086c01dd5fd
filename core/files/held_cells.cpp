#include "core/engine/mesh/orientation.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/files.hpp"
#include "core/files/format.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// The number of cells of each kind in a mesh.
class CellCounts {
  public:
    explicit CellCounts(const MeshView &mesh) {
        for (const MeshView::Block &block : mesh.blocks()) {
            of(block.kind) += block.size();
        }
        for (const TaggedEdge &edge : mesh.edges) {
            ++of(cellKindOf(edge));
        }
        of(CellKind::Point) = mesh.points.size();
    }

    std::size_t of(CellKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }
    /// Returns the kinds that the mesh has.
    CellSet kinds() const {
        CellSet kinds;
        for (std::size_t k = 0; k < counts_.size(); ++k) {
            if (counts_[k] > 0) {
                kinds.add(static_cast<CellKind>(k));
            }
        }
        return kinds;
    }
    /// Lists kinds with their numbers, such as "quadrilaterals of 8 nodes (3 of them)".
    std::vector<std::string> described(CellSet kinds) const {
        std::vector<std::string> list;
        for (std::size_t k = 0; k < counts_.size(); ++k) {
            const auto kind = static_cast<CellKind>(k);
            if (kinds.has(kind) && of(kind) > 0) {
                list.push_back(std::string(traitsOf(kind).plural) + " (" + std::to_string(of(kind)) + " of them)");
            }
        }
        return list;
    }

  private:
    std::size_t &of(CellKind kind) { return counts_[static_cast<std::size_t>(kind)]; }

    std::array<std::size_t, kCellTraits.size()> counts_ = {};
};

std::string joined(const std::vector<std::string> &parts, const std::string &between, const std::string &last) {
    std::string text;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == parts.size() ? last : between) + parts[k];
    }
    return text;
}

bool holdsAll(const FileFormat &format, CellSet kinds) {
    CellSet elements;
    for (const CellKind kind : kElementKinds) {
        if (kinds.has(kind)) {
            elements.add(kind);
        }
    }
    const bool several = std::none_of(kElementKinds.begin(), kElementKinds.end(),
                                      [&](CellKind kind) { return CellSet{kind}.hasAll(elements); });
    return format.holds.hasAll(kinds) && !(format.oneElementKind && several);
}

/// Says in which formats to write the mesh instead: those that can also be read, so no pictures, and that their
/// extension alone stands for.
std::string adviceFor(CellSet kinds) {
    std::vector<std::string> extensions;
    std::set<std::string> taken;
    for (const Format &format : engineFormats().formats()) {
        const FileFormat &about = format.about;
        if (about.writesMesh && about.readsMesh && taken.insert(about.extension).second && holdsAll(about, kinds)) {
            extensions.emplace_back(about.extension);
        }
    }
    return extensions.empty() ? "" : "write " + joined(extensions, ", ", " or ") + " instead";
}

} // namespace

Status checkElements(const FileFormat &format, const MeshView &mesh) {
    const CellCounts counts(mesh);
    const CellSet kinds = counts.kinds();
    if (holdsAll(format, kinds)) {
        return {};
    }
    CellSet missing, elements;
    for (std::size_t k = 0; k < kCellTraits.size(); ++k) {
        const auto kind = static_cast<CellKind>(k);
        if (!format.holds.has(kind)) {
            missing.add(kind);
        }
        if (traitsOf(kind).dimension == 2) {
            elements.add(kind);
        }
    }
    const std::vector<std::string> lacking = counts.described(missing);
    return error("unsupported-elements",
                 std::string(format.name) + (lacking.empty()
                                                 ? " files hold elements of one kind, but the mesh has " +
                                                       joined(counts.described(elements), ", ", " and ")
                                                 : " files hold no " + joined(lacking, ", no ", " and no ")),
                 adviceFor(kinds));
}

namespace {

/// Refuses clockwise elements where programs would take them for others, or extruded ones would be inside out.
Status checkTurns(const FileFormat &format, const MeshView &mesh, const ExportOptions &options) {
    if (!format.counterClockwise && !options.extrusion) {
        return {};
    }
    const ClockwiseElements found = clockwiseElements(mesh);
    if (found.count == 0) {
        return {};
    }
    const bool all = found.count == mesh.elementCount();
    Diagnostics faults =
        error("clockwise",
              (all ? std::string("all") : std::to_string(found.count) + " of " + std::to_string(mesh.elementCount())) +
                  " elements are clockwise; " +
                  (options.extrusion ? std::string("extruded ones would be inside out")
                                     : std::string(format.name) + " files need them counter-clockwise"),
              all ? "turn the elements" : "a mesh with elements of both kinds is folded or faulty; correct it");
    faults.front().at = mesh.nodes[index(mesh.cornersOf(found.first)[0])];
    return faults;
}

} // namespace

Status checkExport(const FileFormat &format, const MeshView &mesh, const ExportOptions &options) {
    if (options.extrusion && !format.holdsSolids) {
        std::vector<std::string> ids;
        for (const Format &each : engineFormats().formats()) {
            if (each.about.holdsSolids) {
                ids.push_back(std::string(each.about.id) + " (" + each.about.extension + ")");
            }
        }
        return error("unsupported-extrusion", std::string(format.name) + " files hold no prisms and hexahedra",
                     "extruded meshes are written as " + joined(ids, ", ", " or "));
    }
    if (options.extrusion && mesh.hasSecondOrder()) {
        return error("unsupported-extrusion",
                     "only elements of first order can be extruded, but the mesh has some of second order",
                     "make elements of first order");
    }
    if (options.extrusion) {
        // Programs number nodes and faces with 31 bits; a hexahedron has three faces of its own and its upper one.
        constexpr std::uint64_t kMost = 0x7fffffff;
        const std::uint64_t layers = options.extrusion->layers;
        if (mesh.nodes.size() * (layers + 1) > kMost || 5 * mesh.elementCount() * layers > kMost) {
            return error("too-many-elements",
                         std::to_string(mesh.elementCount()) + " elements in " + std::to_string(layers) +
                             " layers are more than files can number",
                         "extrude the mesh in fewer layers");
        }
    }
    if (Status unsupported = checkElements(format, mesh); !unsupported.empty()) {
        return unsupported;
    }
    return checkTurns(format, mesh, options);
}

} // namespace forefront

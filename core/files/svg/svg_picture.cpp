#include "core/files/svg/svg_picture.hpp"

#include "core/engine/domain/domain.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/tagged_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace forefront {

namespace {

constexpr double kWidth = 1000.0; ///< length of the drawing's longer side, in drawing units
/// The number of triangles and edges, at most 50 bytes each, from which on paths are divided, and the number in one
/// path then; elements with more nodes count in proportion. libxml2, and with it librsvg, refuses attributes of more
/// than 10 MB, and some larger files with paths of 450 KB.
constexpr std::size_t kManyParts = 150'000;
constexpr std::size_t kPartsPerPath = 1'000;

// Light fills for regions, strong strokes for boundaries.
constexpr std::array<const char *, 6> kFills = {"#dbe9f6", "#fdebd0", "#dcedd8", "#f3dcea", "#e6e0f2", "#f5f0c8"};
constexpr std::array<const char *, 6> kStrokes = {"#1b4f83", "#b3541e", "#2f6b2f", "#8e2f66", "#533a8b", "#7a6a00"};

std::string xmlText(std::string_view text) {
    std::string result;
    for (const char c : asQuotable(text)) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    }
    return result;
}

struct SvgPathStyle {
    const char *fill;
    const char *stroke;
    double width;
    std::string title;
};

/// Calls visit(a, b, middle) for each edge with a middle node: those of elements, and tagged ones.
template <class Visit>
void forEachCurvedEdge(const MeshView &mesh, Visit visit) {
    for (const MeshView::Block &block : mesh.blocks()) {
        const std::size_t corners = block.traits().corners;
        for (std::size_t k = 0; block.traits().order == 2 && k < block.size(); ++k) {
            const std::span<const NodeId> nodes = block.nodesOf(k);
            for (std::size_t side = 0; side < corners; ++side) {
                visit(nodes[side], nodes[(side + 1) % corners], nodes[corners + side]);
            }
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        if (edge.middle != kNoNode) {
            visit(edge.a, edge.b, edge.middle);
        }
    }
}

/// Returns the control point of the quadratic Bézier curve from a to b that is at `middle` half-way, as an edge of
/// second order is.
Vec2 controlPoint(Vec2 a, Vec2 middle, Vec2 b) {
    return 2.0 * middle - 0.5 * (a + b);
}

/// Adds the points of such a curve where a coordinate has a maximum or minimum between its ends.
void addExtremes(Box2 &box, Vec2 a, Vec2 middle, Vec2 b) {
    const Vec2 control = controlPoint(a, middle, b);
    for (const double Vec2::*coordinate : {&Vec2::x, &Vec2::y}) {
        const double fall = a.*coordinate - control.*coordinate;
        const double bend = fall + (b.*coordinate - control.*coordinate);
        const double t = fall / bend; // NaN or infinite for a straight edge
        if (t > 0.0 && t < 1.0) {
            box.add((1.0 - t) * (1.0 - t) * a + 2.0 * t * (1.0 - t) * control + t * t * b);
        }
    }
}

/// Maps the mesh to the drawing: y points down, coordinates are rounded to hundredths.
class Sheet {
  public:
    explicit Sheet(const MeshView &mesh) : box_(boxOf(mesh)) {
        const Vec2 size = box_.empty() ? Vec2{1.0, 1.0} : box_.size();
        const double longer = std::max(size.x, size.y);
        scale_ = longer > 0.0 ? kWidth / longer : 1.0;
        extent_ = scale_ * size;
    }
    Vec2 extent() const { return extent_; }
    double scale() const { return scale_; } ///< drawing units per unit of the mesh
    void put(TextWriter &out, Vec2 p) const {
        out << rounded(scale_ * (p.x - box_.min.x)) << ' ' << rounded(scale_ * (box_.max.y - p.y));
    }

  private:
    /// Curved edges can leave the bounds of the nodes.
    static Box2 boxOf(const MeshView &mesh) {
        Box2 box = mesh.bounds();
        forEachCurvedEdge(mesh, [&](NodeId a, NodeId b, NodeId middle) {
            addExtremes(box, mesh.nodes[index(a)], mesh.nodes[index(middle)], mesh.nodes[index(b)]);
        });
        return box;
    }
    static double rounded(double value) { return std::round(value * 100.0) / 100.0; }

    Box2 box_;
    double scale_ = 1.0;
    Vec2 extent_;
};

/// Writes parts of a drawing as one path, or as several if there are many.
template <class PutPart>
void writePaths(TextWriter &out, const SvgPathStyle &style, const std::vector<std::uint32_t> &parts,
                std::size_t perPath, const PutPart &putPart) {
    for (std::size_t first = 0; first < parts.size() && out.ok(); first += perPath) {
        out << "<path fill=\"" << style.fill << "\" stroke=\"" << style.stroke << "\" stroke-width=\"" << style.width
            << "\" d=\"";
        const std::size_t end = std::min(parts.size(), first + perPath);
        for (std::size_t k = first; k < end && out.ok(); ++k) {
            putPart(parts[k]);
        }
        out << "\"><title>" << xmlText(style.title) << "</title></path>\n";
    }
}

/// Writes the size of a picture of which `scale` units are one unit of the mesh, unless that has no unit. SVG knows no
/// units above centimetres and inches.
void writeSize(Vec2 size, double scale, LengthUnit unit, TextWriter &out) {
    const bool inches = unit == LengthUnit::Inch || unit == LengthUnit::Foot;
    const LengthUnit written = inches ? LengthUnit::Inch : LengthUnit::Millimetre;
    if (const std::optional<double> factor = conversion(unit, written)) {
        const auto length = [&](const char *attribute, double value) {
            out << ' ' << attribute << "=\"" << value / scale * *factor << wordOf(written) << '"';
        };
        length("width", size.x);
        length("height", size.y);
    }
}

} // namespace

void writeSvg(const MeshView &mesh, TextWriter &out) {
    writeSvgWith(mesh, {}, out);
}

void writeSvgWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    const Sheet sheet(mesh);
    constexpr double kMargin = 10.0;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    writeSize(sheet.extent() + Vec2{2.0 * kMargin, 2.0 * kMargin}, sheet.scale(), options.unit, out);
    out << " viewBox=\"" << -kMargin << ' ' << -kMargin << ' ' << sheet.extent().x + 2.0 * kMargin << ' '
        << sheet.extent().y + 2.0 * kMargin << "\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    const double pitch =
        mesh.elementCount() == 0
            ? kWidth
            : std::sqrt(sheet.extent().x * sheet.extent().y / static_cast<double>(mesh.elementCount()));
    const double thin = std::min(0.8, 0.06 * pitch);
    const auto at = [&](NodeId node) { sheet.put(out, mesh.nodes[index(node)]); };
    const auto lineTo = [&](NodeId a, NodeId b, NodeId middle) {
        if (middle == kNoNode) {
            out << 'L', at(b);
            return;
        }
        out << 'Q';
        sheet.put(out, controlPoint(mesh.nodes[index(a)], mesh.nodes[index(middle)], mesh.nodes[index(b)]));
        out << ' ', at(b);
    };
    const std::size_t count = nodesOfElements(mesh) / 3 + mesh.edges.size();
    const std::size_t perPath = count < kManyParts ? kManyParts : kPartsPerPath;
    std::size_t number = 0;
    for (const auto &[tag, elements] : elementsByRegion(mesh)) {
        const SvgPathStyle style{kFills[number++ % kFills.size()], "#445566", thin, regionName(mesh.regionNames, tag)};
        writePaths(out, style, elements, perPath, [&](std::uint32_t element) {
            const MeshView::Block &block = mesh.blockOf(element);
            const std::span<const NodeId> nodes = block.nodesOf(element - block.first);
            const std::size_t corners = block.traits().corners;
            const bool curved = block.traits().order == 2;
            out << 'M', at(nodes[0]);
            for (std::size_t k = 0; k < (curved ? corners : corners - 1); ++k) { // Z closes straight outlines
                lineTo(nodes[k], nodes[(k + 1) % corners], curved ? nodes[corners + k] : kNoNode);
            }
            out << "Z\n";
        });
    }
    number = 0;
    for (const auto &[tag, edges] : edgesByTag(mesh)) {
        const SvgPathStyle style{"none", kStrokes[number++ % kStrokes.size()], 3.0 * thin,
                                 boundaryName(mesh.boundaryNames, tag)};
        writePaths(out, style, edges, perPath, [&](std::uint32_t edge) {
            const TaggedEdge &item = mesh.edges[edge];
            out << 'M', at(item.a), lineTo(item.a, item.b, item.middle), out << '\n';
        });
    }
    for (const TaggedNode &point : mesh.points) {
        out << "<path fill=\"none\" stroke=\"#222222\" stroke-width=\"" << 6.0 * thin << "\" d=\"M", at(point.node),
            out << "h0\"><title>" << xmlText(boundaryName(mesh.boundaryNames, point.tag)) << "</title></path>\n";
    }
    out << "</svg>\n";
}

} // namespace forefront

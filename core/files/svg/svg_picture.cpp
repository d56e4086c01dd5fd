#include "core/files/svg/svg_picture.hpp"

#include "core/engine/domain/domain.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace forefront {

namespace {

constexpr double kWidth = 1000.0; ///< length of the drawing's longer side, in drawing units
/// The number of elements and edges, at most 50 bytes each, from which on paths are divided, and the number in one path
/// then. libxml2, and with it librsvg, refuses attributes of more than 10 MB, and some larger files with paths of 450
/// KB.
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

/// Maps the mesh to the drawing: y points down, coordinates are rounded to hundredths.
class Sheet {
  public:
    explicit Sheet(const TriMesh &mesh) : box_(mesh.bounds()) {
        const Vec2 size = box_.empty() ? Vec2{1.0, 1.0} : box_.size();
        const double longer = std::max(size.x, size.y);
        scale_ = longer > 0.0 ? kWidth / longer : 1.0;
        extent_ = scale_ * size;
    }
    Vec2 extent() const { return extent_; }
    void put(TextWriter &out, Vec2 p) const {
        out << rounded(scale_ * (p.x - box_.min.x)) << ' ' << rounded(scale_ * (box_.max.y - p.y));
    }

  private:
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

} // namespace

void writeSvg(const TriMesh &mesh, TextWriter &out) {
    const Sheet sheet(mesh);
    constexpr double kMargin = 10.0;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" << -kMargin << ' ' << -kMargin << ' '
        << sheet.extent().x + 2.0 * kMargin << ' ' << sheet.extent().y + 2.0 * kMargin
        << "\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    std::map<std::int32_t, std::vector<std::uint32_t>> regions, boundaries;
    for (std::uint32_t e = 0; e < mesh.elements.size(); ++e) {
        regions[mesh.region(e)].push_back(e);
    }
    for (std::uint32_t k = 0; k < mesh.edges.size(); ++k) {
        boundaries[mesh.edges[k].tag].push_back(k);
    }
    const double pitch =
        mesh.elements.empty()
            ? kWidth
            : std::sqrt(sheet.extent().x * sheet.extent().y / static_cast<double>(mesh.elements.size()));
    const double thin = std::min(0.8, 0.06 * pitch);
    const auto at = [&](NodeId node) { sheet.put(out, mesh.nodes[index(node)]); };
    const std::size_t count = mesh.elements.size() + mesh.edges.size();
    const std::size_t perPath = count < kManyParts ? kManyParts : kPartsPerPath;
    std::size_t number = 0;
    for (const auto &[tag, elements] : regions) {
        const SvgPathStyle style{kFills[number++ % kFills.size()], "#445566", thin, regionName(mesh.regionNames, tag)};
        writePaths(out, style, elements, perPath, [&](std::uint32_t element) {
            const Element &nodes = mesh.elements[element];
            out << 'M', at(nodes[0]), out << 'L', at(nodes[1]), out << 'L', at(nodes[2]), out << "Z\n";
        });
    }
    number = 0;
    for (const auto &[tag, edges] : boundaries) {
        const SvgPathStyle style{"none", kStrokes[number++ % kStrokes.size()], 3.0 * thin,
                                 boundaryName(mesh.boundaryNames, tag)};
        writePaths(out, style, edges, perPath, [&](std::uint32_t edge) {
            out << 'M', at(mesh.edges[edge].a), out << 'L', at(mesh.edges[edge].b), out << '\n';
        });
    }
    for (const TaggedNode &point : mesh.points) {
        out << "<path fill=\"none\" stroke=\"#222222\" stroke-width=\"" << 6.0 * thin << "\" d=\"M", at(point.node),
            out << "h0\"><title>" << xmlText(boundaryName(mesh.boundaryNames, point.tag)) << "</title></path>\n";
    }
    out << "</svg>\n";
}

} // namespace forefront

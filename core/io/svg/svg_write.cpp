#include "core/io/common/names.hpp"
#include "core/io/svg/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace forefront {

namespace {

constexpr double kWidth = 1000.0; ///< length of the drawing's longer side, in drawing units

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

/// Maps the mesh to the drawing: y points down, coordinates are rounded to hundredths.
class Sheet {
  public:
    explicit Sheet(const Mesh &mesh) : box_(mesh.bounds()) {
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

} // namespace

/// Draws the mesh: one path per region and one per boundary tag, each with its name as title.
void writeSvg(const Mesh &mesh, TextWriter &out) {
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
    std::size_t number = 0;
    for (const auto &[tag, elements] : regions) {
        out << "<path fill=\"" << kFills[number++ % kFills.size()] << "\" stroke=\"#445566\" stroke-width=\"" << thin
            << "\" d=\"";
        for (std::size_t k = 0; k < elements.size() && out.ok(); ++k) {
            const Element &nodes = mesh.elements[elements[k]];
            out << 'M', at(nodes[0]), out << 'L', at(nodes[1]), out << 'L', at(nodes[2]), out << "Z\n";
        }
        out << "\"><title>" << xmlText(regionName(mesh.regionNames, tag)) << "</title></path>\n";
    }
    number = 0;
    for (const auto &[tag, edges] : boundaries) {
        out << "<path fill=\"none\" stroke=\"" << kStrokes[number++ % kStrokes.size()] << "\" stroke-width=\""
            << 3.0 * thin << "\" d=\"";
        for (const std::uint32_t k : edges) {
            out << 'M', at(mesh.edges[k].a), out << 'L', at(mesh.edges[k].b), out << '\n';
        }
        out << "\"><title>" << xmlText(boundaryName(mesh.boundaryNames, tag)) << "</title></path>\n";
    }
    for (const TaggedNode &point : mesh.points) {
        out << "<path fill=\"none\" stroke=\"#222222\" stroke-width=\"" << 6.0 * thin << "\" d=\"M", at(point.node),
            out << "h0\"><title>" << xmlText(boundaryName(mesh.boundaryNames, point.tag)) << "</title></path>\n";
    }
    out << "</svg>\n";
}

} // namespace forefront

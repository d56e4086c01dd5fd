#include "core/drawing_files/svg/areas/svg_white.hpp"

#include <algorithm>
#include <span>

namespace forefront {
namespace {

constexpr double kWhiteLuminance = 0.98; ///< minimum of what looks white
constexpr double kOpaque = 0.98;         ///< minimum opacity of what hides the shapes below

bool looksWhite(const SvgPath &path) {
    const SvgPaint &paint = path.paint;
    return path.painted() && paint.fill.plain && paint.fill.luminance >= kWhiteLuminance &&
           paint.fillAlpha() >= kOpaque;
}

/// A painted element: its subpaths are those at the indices.
struct PaintedElement {
    std::size_t id = 0;
    bool white = false;
    std::vector<std::size_t> paths;
    Box2 box;
};

std::vector<PaintedElement> elementsOf(const std::vector<SvgPath> &paths) {
    std::vector<PaintedElement> elements;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        if (!paths[k].painted()) {
            continue;
        }
        if (elements.empty() || elements.back().id != paths[k].element) {
            elements.push_back({paths[k].element, looksWhite(paths[k]), {}, {}});
        }
        elements.back().paths.push_back(k);
        elements.back().box.add(paths[k].box());
    }
    return elements;
}

/// Returns the number of edges of a loop that a ray from a point to the right crosses.
int crossings(std::span<const Vec2> loop, Vec2 p) {
    int count = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 a = loop[k], b = loop[k + 1 == loop.size() ? 0 : k + 1];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            ++count;
        }
    }
    return count;
}

bool covers(const PaintedElement &element, const std::vector<SvgPath> &paths, Vec2 p) {
    int count = 0;
    for (const std::size_t k : element.paths) {
        count += crossings(paths[k].nodes, p);
    }
    return count % 2 == 1;
}

/// Returns true if a node of one element lies in the other one.
bool liesOn(const PaintedElement &above, const PaintedElement &below, const std::vector<SvgPath> &paths) {
    return above.box.overlaps(below.box) && std::any_of(above.paths.begin(), above.paths.end(), [&](std::size_t k) {
               return std::any_of(paths[k].nodes.begin(), paths[k].nodes.end(),
                                  [&](Vec2 node) { return covers(below, paths, node); });
           });
}

} // namespace

SvgWhiteShapes::SvgWhiteShapes(const std::vector<SvgPath> &paths) : on_(paths.size()) {
    const std::vector<PaintedElement> elements = elementsOf(paths);
    for (std::size_t above = 0; above < elements.size(); ++above) {
        std::vector<std::size_t> below;
        for (std::size_t k = 0; k < above && elements[above].white; ++k) {
            if (!elements[k].white && liesOn(elements[above], elements[k], paths)) {
                below.push_back(elements[k].id);
            }
        }
        count_ += below.empty() ? 0 : 1;
        for (const std::size_t path : elements[above].paths) {
            on_[path] = below;
        }
    }
}

} // namespace forefront

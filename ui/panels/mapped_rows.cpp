#include "ui/panels/mapped_rows.hpp"

#include "core/drawing/names/part_commands.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/mapped/mapped_faces.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::size_t kMaxListed = 200; ///< nodes in a list; of an outline with more, the sharpest
constexpr std::size_t kCorners = 4;     ///< maximum number of a face

/// The corners of the face around a marker, and of the other faces of its region.
class CornerChoice {
  public:
    CornerChoice(const MappedSpec &spec, const std::vector<MappedOutline> &outlines, const MappedOutline &shown)
        : spec_(spec), outlines_(outlines), shown_(shown) {}

    /// Returns the chosen nodes of the face shown, in the order of the document.
    std::vector<std::uint32_t> chosen() const {
        std::vector<std::uint32_t> nodes;
        for (const Vec2 place : spec_.corners) {
            const std::uint32_t k = nodeAt(shown_, place);
            if (k < shown_.nodes.size() && std::ranges::find(nodes, k) == nodes.end()) {
                nodes.push_back(k);
            }
        }
        return nodes;
    }
    /// Returns the corners of the region with other ones of the face shown, which come first.
    std::vector<Vec2> with(const std::vector<std::uint32_t> &nodes) const {
        std::vector<Vec2> places;
        for (const std::uint32_t k : nodes) {
            places.push_back(shown_.nodes[k]);
        }
        for (const Vec2 place : spec_.corners) {
            const bool isOurs = nodeAt(shown_, place) < shown_.nodes.size() && !isCornerElsewhere(place);
            if (!isOurs && std::ranges::find(places, place) == places.end()) {
                places.push_back(place);
            }
        }
        return places;
    }
    /// Returns corners to begin with: those that all faces have, or else their sharpest nodes.
    std::vector<Vec2> start() const {
        std::vector<Vec2> places;
        const auto add = [&](const MappedOutline &outline) {
            for (const std::uint32_t k : outline.corners.empty() ? sharpest(outline, kCorners) : outline.corners) {
                if (std::ranges::find(places, outline.nodes[k]) == places.end()) {
                    places.push_back(outline.nodes[k]);
                }
            }
        };
        add(shown_);
        std::ranges::for_each(outlines_, add);
        return places;
    }
    /// Returns the nodes with the sharpest corners of an outline, ascending.
    static std::vector<std::uint32_t> sharpest(const MappedOutline &outline, std::size_t count) {
        std::vector<std::size_t> order(outline.able.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return outline.angles[i]; });
        order.resize(std::min(order.size(), count));
        std::vector<std::uint32_t> nodes;
        for (const std::size_t i : order) {
            nodes.push_back(outline.able[i]);
        }
        std::ranges::sort(nodes);
        return nodes;
    }

  private:
    /// Returns the node of an outline at a place, as findMappedFaces() finds it; the number of nodes: there is none.
    static std::uint32_t nodeAt(const MappedOutline &outline, Vec2 place) {
        Box2 box;
        for (const Vec2 node : outline.nodes) {
            box.add(node);
        }
        const double tolerance = 1e-6 * length(box.size());
        const auto found =
            std::ranges::find_if(outline.nodes, [&](Vec2 node) { return distance(node, place) <= tolerance; });
        return static_cast<std::uint32_t>(found - outline.nodes.begin());
    }
    bool isCornerElsewhere(Vec2 place) const {
        return std::ranges::any_of(outlines_, [&](const MappedOutline &other) {
            return &other != &shown_ && std::ranges::find(other.corners, nodeAt(other, place)) != other.corners.end();
        });
    }

    const MappedSpec &spec_;
    const std::vector<MappedOutline> &outlines_;
    const MappedOutline &shown_;
};

const MappedOutline *outlineAround(const std::vector<MappedOutline> &outlines, Vec2 place) {
    const auto found = std::ranges::find_if(
        outlines, [&](const MappedOutline &outline) { return locate(outline.nodes, place) == PointPlace::Inside; });
    return found != outlines.end() ? &*found : nullptr;
}

void applyCorners(Shell &context, std::int32_t region, std::vector<Vec2> corners) {
    context.applyCommand(setMappedCorners(*context.document.current(), region, std::move(corners)), "Choose corners");
}

/// Draws a list of nodes for each chosen corner; the fourth one can be left out.
void cornerLists(Shell &context, std::int32_t region, const CornerChoice &corners, const MappedOutline &outline) {
    std::vector<std::uint32_t> nodes = CornerChoice::sharpest(outline, kMaxListed);
    const std::vector<std::uint32_t> chosen = corners.chosen();
    for (const std::uint32_t k : chosen) {
        if (std::ranges::find(nodes, k) == nodes.end()) {
            nodes.push_back(k);
        }
    }
    for (std::size_t c = 0; c < std::max(kCorners, chosen.size()); ++c) {
        const bool canMiss = c + 1 >= kCorners || c >= chosen.size();
        std::vector<std::string> names;
        if (canMiss) {
            names.emplace_back("none");
        }
        for (const std::uint32_t k : nodes) {
            names.push_back("(" + ui::number(outline.nodes[k].x) + ", " + ui::number(outline.nodes[k].y) + ")");
        }
        const std::ptrdiff_t first = canMiss ? 1 : 0;
        int choice =
            c < chosen.size() ? static_cast<int>(first + (std::ranges::find(nodes, chosen[c]) - nodes.begin())) : 0;
        form::label(context, ("Corner " + std::to_string(c + 1)).c_str());
        const bool changed = ui::combo(context, "inspector/corners/" + std::to_string(c + 1), names, choice);
        ui::rowTooltip(context, c == 0 ? "A node of the outline. Of three corners, the rows meet at the first."
                                       : "A node of the outline");
        if (!changed) {
            continue;
        }
        std::vector<std::uint32_t> next = chosen;
        if (choice < first) {
            if (c < next.size()) {
                next.erase(next.begin() + static_cast<std::ptrdiff_t>(c));
            }
        } else {
            const std::uint32_t node = nodes[static_cast<std::size_t>(choice - first)];
            const auto other = std::ranges::find(next, node);
            if (c < next.size()) {
                if (other != next.end()) {
                    *other = next[c]; // the two change places
                }
                next[c] = node;
            } else if (other == next.end()) {
                next.push_back(node);
            }
        }
        applyCorners(context, region, corners.with(next));
        return;
    }
}

void cornerRows(Shell &context, const MarkedRegion &marker, const MappedSpec &spec) {
    const auto found = context.preview->mapped.find(marker.tag);
    const MappedOutline *const outline =
        found != context.preview->mapped.end() ? outlineAround(found->second, marker.at) : nullptr;
    if (outline == nullptr) { // the drawing has faults, or the face cannot be filled by rows
        return;
    }
    const CornerChoice corners(spec, found->second, *outline);
    constexpr std::array<const char *, 2> kLabels{"Automatic", "Chosen"};
    int choice = spec.corners.empty() ? 0 : 1;
    form::label(context, "Corners");
    const bool changed =
        ui::segmented(context, "inspector/corners/choice", std::span<const char *const>(kLabels), choice);
    ui::rowTooltip(context, "Three or four corners divide the outline into the sides of the rows: its sharpest nodes, "
                            "or those that you choose.");
    if (changed) {
        applyCorners(context, marker.tag, choice == 0 ? std::vector<Vec2>() : corners.start());
        return;
    }
    if (!spec.corners.empty()) {
        cornerLists(context, marker.tag, corners, *outline);
    } else if (outline->corners.empty()) {
        ui::small(context, "The sharpest nodes are not clear; choose 3 or 4 corners", true);
        ui::mark(context, "inspector/corners/unclear");
    }
}

} // namespace

void mappedRows(Shell &context, const MarkedRegion &marker) {
    const Document &document = *context.document.current();
    bool mapped = isMapped(document, marker.tag);
    form::label(context, "Mapped");
    const bool changed = ui::checkbox(context, "inspector/mapped", "Rows of elements", mapped);
    ui::rowTooltip(context, "Fill each face of the region by rows between opposite sides, which get equal numbers of "
                            "elements. The face needs three or four corners.");
    if (changed) {
        context.applyCommand(setMapped(document, marker.tag, mapped), mapped ? "Map region" : "Do not map region");
        return;
    }
    if (const MappedSpec *const spec = mappedOf(document, marker.tag)) {
        cornerRows(context, marker, *spec);
    }
}

} // namespace forefront

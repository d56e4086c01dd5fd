#include "ui/panels/element_count_row.hpp"

#include "core/edit/element_counts.hpp"
#include "core/edit/shape_geometry.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace forefront {
namespace {

bool countable(const Document &document, SegmentRef segment) {
    const Shape *const shape = findShape(document, segment.shape);
    return shape != nullptr && countableLength(*shape, segment.segment).value_or(0.0) > 0.0;
}

std::optional<double> commonCount(const Document &document, const std::set<SegmentRef> &segments) {
    const std::optional<std::uint32_t> first = elementCount(document, *segments.begin());
    const bool same = std::all_of(segments.begin(), segments.end(),
                                  [&](SegmentRef segment) { return elementCount(document, segment) == first; });
    return same && first ? std::optional<double>(*first) : std::nullopt;
}

/// Returns the number of elements that the mesh of the present drawing has along a segment with a number of elements;
/// nullopt if there is no such mesh.
std::optional<std::size_t> meshedElements(const Shell &context, SegmentRef segment) {
    const SessionSnapshot &run = *context.run.snapshot();
    if (!run.mesh || !run.complete || context.run.outOfDate()) {
        return std::nullopt;
    }
    const Document &document = *context.document.current();
    const std::int32_t tag = segmentTag(*findShape(document, segment.shape), segment.segment);
    const std::optional<std::uint32_t> count = elementCount(document, segment);
    std::size_t sharing = 0; // segments of the tag, which have the same length
    for (const auto &shape : document.shapes) {
        for (std::uint32_t k = 0; k < taggedSegments(*shape); ++k) {
            if (segmentTag(*shape, k) == tag) {
                if (elementCount(document, {shape->id, k}) != count) {
                    return std::nullopt;
                }
                ++sharing;
            }
        }
    }
    const std::vector<TaggedEdge> &edges = run.mesh->mesh.edges;
    const auto all = static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [&](const TaggedEdge &edge) { return edge.tag == tag; }));
    return sharing > 0 && all % sharing == 0 ? std::optional(all / sharing) : std::nullopt;
}

/// Writes below the field how many elements the mesh has, if these are more or fewer.
void drawMeshed(Shell &context, SegmentRef segment, double count) {
    const std::optional<std::size_t> meshed = meshedElements(context, segment);
    if (!meshed || static_cast<double>(*meshed) == count) {
        return;
    }
    ui::small(context, "The mesh has " + std::to_string(*meshed) + " here.", true);
    ui::mark(context, "inspector/elements/meshed");
    ui::tooltip(context, static_cast<double>(*meshed) > count
                             ? "A smaller size acts here: of a part, a source, the automatic spacing or a narrow "
                               "place. Curves also get as many elements as their shape needs."
                             : "The minimum size is larger.");
}

std::string explanation(const std::set<SegmentRef> &segments) {
    const std::string along =
        segments.size() == 1 ? "Number of elements along it." : "Number of elements along each of them.";
    return along +
           " Sets the size of a boundary part, with a tag of its own where others share the tag. Leave it empty "
           "to use the general size.";
}

} // namespace

void elementCountRow(Shell &context, const std::set<SegmentRef> &segments) {
    const Document &document = *context.document.current();
    const auto counted = [&](SegmentRef segment) { return countable(document, segment); };
    if (segments.empty() || !std::all_of(segments.begin(), segments.end(), counted)) {
        return;
    }
    const std::optional<double> before = commonCount(document, segments);
    std::optional<double> count = before;
    form::label(context, "Elements");
    const bool differ = !before && std::any_of(segments.begin(), segments.end(), [&](SegmentRef segment) {
        return elementCount(document, segment).has_value();
    });
    const bool changed = form::optionalField(context, "inspector/elements", count, differ ? "several" : "auto");
    ui::rowTooltip(context, explanation(segments));
    if (!changed) {
        if (before) {
            drawMeshed(context, *segments.begin(), *before);
        }
        return;
    }
    constexpr double kMax = kMaxElementCount;
    if (count && !(*count >= 1.0 && *count <= kMax && *count == std::floor(*count))) {
        const std::string fault = "expected a whole number from 1 to " + ui::number(kMax, 7);
        ui::refuseEntry(context, "inspector/elements", error("bad-number", fault + ", got " + ui::number(*count, 6)),
                        fault);
        return;
    }
    const auto whole = count ? std::optional(static_cast<std::uint32_t>(*count)) : std::nullopt;
    EditState::apply(context, setElementCount(document, segments, whole), "Set number of elements");
}

void elementCountRow(Shell &context, const std::set<std::uint32_t> &shapes) {
    std::set<SegmentRef> segments;
    for (const std::uint32_t id : shapes) {
        const Shape *const shape = findShape(*context.document.current(), id);
        if (shape == nullptr || taggedSegments(*shape) != 1) {
            return;
        }
        segments.insert({id, 0});
    }
    elementCountRow(context, segments);
}

} // namespace forefront

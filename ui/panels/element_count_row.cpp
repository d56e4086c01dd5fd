#include "ui/panels/element_count_row.hpp"

#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// A segment with the tag and length that it has now.
struct CountedSegment {
    std::int32_t tag = 1;
    double length = 0.0;
};

/// Returns what is counted along segments; nothing if elements cannot be counted along one of them.
std::vector<CountedSegment> countedSegments(const Document &document, const std::set<SegmentRef> &segments) {
    std::vector<CountedSegment> counted;
    const Shape *shape = nullptr;
    std::vector<std::optional<double>> lengths;
    for (const SegmentRef segment : segments) { // in the order of their shapes
        if (shape == nullptr || shape->id != segment.shape) {
            shape = findShape(document, segment.shape);
            lengths = shape != nullptr ? countableLengths(*shape) : std::vector<std::optional<double>>();
        }
        if (segment.segment >= lengths.size() || !(lengths[segment.segment].value_or(0.0) > 0.0)) {
            return {};
        }
        counted.push_back({segmentTag(*shape, segment.segment), *lengths[segment.segment]});
    }
    return counted;
}

/// The number of elements that segments share.
struct SharedCount {
    std::optional<double> count; ///< not set: they have none, or they differ
    std::string hint = "auto";   ///< shown in place of the number
    PartSegments part;           ///< of the first segment
};

constexpr double kSameLength = 1e-9; ///< relative

SharedCount sharedCount(const Document &document, const std::vector<CountedSegment> &segments) {
    SharedCount shared;
    const std::map<std::int32_t, PartSegments> parts = countedParts(document);
    std::set<std::pair<std::uint32_t, double>> counts; // number of the part, share of it along the segment
    for (const CountedSegment &segment : segments) {
        const auto part = parts.find(segment.tag);
        const double share = part != parts.end() ? segment.length / part->second.longest : 1.0;
        counts.emplace(part != parts.end() ? document.elementCounts.at(segment.tag).count : 0,
                       share > 1.0 - kSameLength ? 1.0 : share);
    }
    const auto [count, share] = *counts.begin();
    if (counts.size() > 1) {
        shared.hint = "several";
    } else if (count > 0 && share == 1.0) {
        shared.count = count;
        shared.part = parts.at(segments.front().tag);
    } else if (count > 0) {
        shared.hint = "about " + std::to_string(std::max(std::lround(share * count), 1L));
    }
    return shared;
}

/// Returns the number of elements along each segment of a boundary part in the mesh of the present drawing; nullopt if
/// there is no such mesh, or the segments differ in length.
std::optional<std::size_t> meshedElements(const Shell &context, std::int32_t tag, const PartSegments &part) {
    const SessionSnapshot &run = *context.run.snapshot();
    if (!run.mesh || !run.complete || context.run.outOfDate() || part.shortest < (1.0 - kSameLength) * part.longest) {
        return std::nullopt;
    }
    const std::vector<TaggedEdge> &edges = run.mesh->mesh.edges;
    const auto all = static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [&](const TaggedEdge &edge) { return edge.tag == tag; }));
    return part.count > 0 && all % part.count == 0 ? std::optional(all / part.count) : std::nullopt;
}

/// Writes below the field how many elements the mesh has, if these are more or fewer.
void drawMeshed(Shell &context, std::int32_t tag, const PartSegments &part, double count) {
    const std::optional<std::size_t> meshed = meshedElements(context, tag, part);
    if (!meshed || static_cast<double>(*meshed) == count) {
        return;
    }
    ui::small(context, "The mesh has " + std::to_string(*meshed) + " here.", true);
    ui::mark(context, "inspector/elements/meshed");
    ui::tooltip(context,
                static_cast<double>(*meshed) > count
                    ? "With fewer elements the boundary would meet itself or other parts. A closed curve has at "
                      "least three."
                    : "With more elements the boundary would meet itself or other parts, or it is kept as it "
                      "is drawn.");
}

/// Draws that note, or leaves its line empty, so that what is below stays in place when meshes come and go.
void drawMeshedRow(Shell &context, std::int32_t tag, const PartSegments &part, double count) {
    const float top = ImGui::GetCursorPosY();
    drawMeshed(context, tag, part, count);
    const float line = context.fonts.small->FontSize + ImGui::GetStyle().ItemSpacing.y;
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), top + line));
}

std::string explanation(std::size_t segments) {
    const std::string along = segments == 1 ? "Number of elements along its whole length"
                                            : "Number of elements along the whole length of each";
    return along +
           " (for a circle, the full turn), regardless of other sizes. If others share its tag, it gets a tag of its "
           "own. Where segments with the tag differ in length, the longest has this number, and "
           "shorter ones have elements of the same size. Leave empty to use the size from the Spacing panel.";
}

NumberAddress addressOfCount(std::int32_t tag) {
    return {NumberOwner::ofPart(tag), Quantity::Elements};
}

/// Gives the segments a number of elements that was entered, with its expression if there is one.
void applyCount(Shell &context, const std::set<SegmentRef> &segments, std::optional<std::uint32_t> count) {
    const EnteredFormulas entered = std::exchange(context.entered, {}); // its tag may change
    const std::string text = entered.texts.empty() ? std::string() : entered.texts.begin()->second;
    Result<Document> next = setElementCount(*context.document.current(), segments, count);
    if (next && count) {
        for (const SegmentRef segment : segments) {
            const std::int32_t tag = segmentTag(*findShape(*next, segment.shape), segment.segment);
            next = setFormula(*std::move(next), addressOfCount(tag), text);
        }
    }
    context.applyCommand(std::move(next), "Set number of elements");
}

} // namespace

void elementCountRow(Shell &context, const std::set<SegmentRef> &segments) {
    const Document &document = *context.document.current();
    const std::vector<CountedSegment> counted = countedSegments(document, segments);
    if (counted.empty()) {
        return;
    }
    const std::int32_t tag = counted.front().tag;
    const SharedCount shared = sharedCount(document, counted);
    std::optional<double> count = shared.count;
    form::label(context, "Elements");
    // Without a number, the address is one that no number has: the field has no expression yet, but can take one.
    const bool changed = form::optionalField(context, "inspector/elements", count, shared.hint.c_str(), -1.0F,
                                             addressOfCount(shared.count ? tag : 0));
    ui::rowTooltip(context, explanation(segments.size()));
    if (shared.count) {
        drawMeshedRow(context, tag, shared.part, *shared.count);
    }
    if (!changed) {
        return;
    }
    constexpr double kMax = kMaxElementCount;
    if (count && !(*count >= 1.0 && *count <= kMax && *count == std::floor(*count))) {
        const std::string fault = "expected a whole number from 1 to " + ui::number(kMax, 7);
        ui::refuseEntry(context, "inspector/elements", error("bad-number", fault + ", got " + ui::number(*count, 6)),
                        fault);
        return;
    }
    applyCount(context, segments, count ? std::optional(static_cast<std::uint32_t>(*count)) : std::nullopt);
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

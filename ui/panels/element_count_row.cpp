#include "ui/panels/element_count_row.hpp"

#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
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

/// Returns true if elements can be counted along each of the segments.
bool areCountable(const Document &document, const std::set<SegmentRef> &segments) {
    const Shape *shape = nullptr;
    std::vector<std::optional<double>> lengths;
    for (const SegmentRef segment : segments) { // in the order of their shapes
        if (shape == nullptr || shape->id != segment.shape) {
            shape = findShape(document, segment.shape);
            lengths = shape != nullptr ? countableLengths(*shape) : std::vector<std::optional<double>>();
        }
        if (segment.segment >= lengths.size() || !(lengths[segment.segment].value_or(0.0) > 0.0)) {
            return false;
        }
    }
    return !segments.empty();
}

/// The number of elements that segments share.
struct SharedCount {
    std::optional<double> count; ///< of their own; not set: they have none, or they differ
    std::string hint = "auto";   ///< shown in place of the number
};

SharedCount sharedCount(const Document &document, const std::set<SegmentRef> &segments) {
    SharedCount shared;
    const std::map<std::int32_t, PartSegments> parts = countedParts(document);
    std::set<std::pair<bool, std::uint32_t>> counts; // of its own or of its boundary part
    std::uint32_t id = 0;
    std::vector<std::uint32_t> elements;
    for (const SegmentRef segment : segments) {
        if (segment.shape != id) {
            id = segment.shape;
            elements = elementsOfParts(document, *findShape(document, id), parts);
        }
        counts.emplace(segmentSize(document, segment) != nullptr,
                       segment.segment < elements.size() ? elements[segment.segment] : 0);
        if (counts.size() > 1) {
            shared.hint = "several";
            return shared;
        }
    }
    const auto [own, count] = *counts.begin();
    if (own && count > 0) {
        shared.count = count;
    } else if (count > 0) {
        shared.hint = std::to_string(count); // of the boundary part
    }
    return shared;
}

/// Returns true if a node lies on one of the curves of a segment.
bool isOn(const std::vector<Curve> &curves, Vec2 node, double reach) {
    return std::any_of(curves.begin(), curves.end(),
                       [&](const Curve &curve) { return distance(curve.point(curve.nearest(node)), node) <= reach; });
}

/// Returns the number of edges along a segment in the mesh of the present drawing; nullopt if there is no such mesh, or
/// it follows the chords of a curve.
std::optional<std::size_t> meshedElements(const Shell &context, SegmentRef segment) {
    const SessionSnapshot &run = *context.run.snapshot();
    const Shape *const shape = findShape(*context.document.current(), segment.shape);
    if (!run.mesh || !run.complete || context.run.outOfDate() || shape == nullptr) {
        return std::nullopt;
    }
    const Outline outline = outlineOf(*shape);
    std::vector<Curve> curves;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.part(k) == segment.segment) {
            curves.push_back(outline.curve(k));
        }
    }
    constexpr double kOnCurve = 1e-7; // of the size of the shape
    const double reach = kOnCurve * boundsOf(*shape).diagonal();
    const TriMesh &mesh = run.mesh->mesh;
    const std::int32_t tag = segmentTag(*shape, segment.segment);
    const auto count =
        static_cast<std::size_t>(std::count_if(mesh.edges.begin(), mesh.edges.end(), [&](const TaggedEdge &edge) {
            return edge.tag == tag && isOn(curves, mesh.nodes[index(edge.a)], reach) &&
                   isOn(curves, mesh.nodes[index(edge.b)], reach);
        }));
    return count > 0 ? std::optional(count) : std::nullopt;
}

/// Writes beside the field how many elements the mesh has, if these are more or fewer: a row of its own would come and
/// go with meshes and move what is below.
void drawMeshed(Shell &context, SegmentRef segment, double count) {
    const std::optional<std::size_t> meshed = meshedElements(context, segment);
    if (!meshed || static_cast<double>(*meshed) == count) {
        return;
    }
    ImGui::SameLine(0, context.px(6));
    ui::small(context, "mesh: " + ui::count(*meshed), true);
    ui::mark(context, "inspector/elements/meshed");
    ui::tooltip(context,
                static_cast<double>(*meshed) > count
                    ? "With fewer elements the boundary would meet itself or other parts. A closed curve has at "
                      "least three."
                    : "With more elements the boundary would meet itself or other parts, or it is kept as it "
                      "is drawn.");
}

/// Returns the ratio that biases share; none if they differ, or none has one.
std::optional<double> sharedRatio(const std::vector<ElementBias> &biases) {
    const double first = biases.front().ratio;
    const bool same = std::all_of(biases.begin(), biases.end(), [&](const ElementBias &b) { return b.ratio == first; });
    return same && biases.front().any() ? std::optional(first) : std::nullopt;
}

/// Changes the biases of segments one by one; each keeps what `change` leaves.
template <class Change>
void changeBiases(Shell &context, const std::set<SegmentRef> &segments, const Change &change) {
    Result<Document> next = *context.document.current();
    for (auto segment = segments.begin(); segment != segments.end() && next; ++segment) {
        ElementBias bias = segmentSize(*next, *segment)->bias;
        change(bias);
        next = setElementBias(*std::move(next), {*segment}, bias);
    }
    context.applyCommand(std::move(next), "Set bias of elements");
}

/// Draws the bias of segments with a number of elements of their own: its ratio, a button that turns it around, and
/// whether it is at both ends.
void biasRow(Shell &context, const std::set<SegmentRef> &segments) {
    const Document &document = *context.document.current();
    std::vector<ElementBias> biases;
    for (const SegmentRef &segment : segments) {
        biases.push_back(segmentSize(document, segment)->bias);
    }
    const bool any = std::any_of(biases.begin(), biases.end(), [](const ElementBias &bias) { return bias.any(); });
    std::optional<double> ratio = sharedRatio(biases);
    form::label(context, "Bias");
    const bool changed = form::optionalField(context, "inspector/bias", ratio, any ? "several" : "none",
                                             form::halfWidth(context) - 20.0F);
    ui::rowTooltip(context, "Length of the last element over that of the first, in the direction of the outline; at "
                            "both ends, of the elements in the middle over those at the ends. The lengths change by "
                            "equal factors. Leave empty to follow the element size. Single curves only; a boundary "
                            "part as a whole and the sides of rounded rectangles have no bias.");
    ImGui::SameLine(0, context.px(6));
    const bool flipped = ui::button(context, "inspector/biasflip", "Flip", ui::ButtonKind::Plain, any);
    bool atBothEnds = biases.front().bothEnds, switched = false;
    if (any) {
        form::label(context, "");
        switched = ui::checkbox(context, "inspector/biasends", "At both ends", atBothEnds);
    }
    if (flipped) {
        context.applyCommand(flipElementBias(document, segments), "Flip bias of elements");
    } else if (changed && ratio && !ElementBias{*ratio}.isValid()) {
        const std::string fault = "expected a ratio from 0.0001 to 10000";
        ui::refuseEntry(context, "inspector/bias", error("bad-number", fault + ", got " + ui::number(*ratio, 6)),
                        fault);
    } else if (changed) {
        changeBiases(context, segments, [&](ElementBias &bias) { bias.ratio = ratio.value_or(1.0); });
    } else if (switched) {
        changeBiases(context, segments, [&](ElementBias &bias) { bias.bothEnds = atBothEnds; });
    }
}

std::string explanation(std::size_t segments) {
    const std::string along = segments == 1 ? "Number of elements along its whole length"
                                            : "Number of elements along the whole length of each";
    return along + " (for a circle, the full turn), regardless of other sizes. Leave empty to use the size above.";
}

NumberAddress addressOfCount(SegmentRef segment) {
    return {NumberOwner::ofShape(segment.shape), Quantity::SegmentElements, segment.segment};
}

/// Gives the segments a number of elements that was entered, with its expression if there is one.
void applyCount(Shell &context, const std::set<SegmentRef> &segments, std::optional<std::uint32_t> count) {
    const EnteredFormulas entered = std::exchange(context.entered, {}); // for the first segment only
    const std::string text = entered.texts.empty() ? std::string() : entered.texts.begin()->second;
    Result<Document> next = setElementCount(*context.document.current(), segments, count);
    for (const SegmentRef segment : segments) {
        if (next && count) {
            next = setFormula(*std::move(next), addressOfCount(segment), text);
        }
    }
    context.applyCommand(std::move(next), "Set number of elements");
}

} // namespace

void elementCountRow(Shell &context, const std::set<SegmentRef> &segments) {
    const Document &document = *context.document.current();
    if (!areCountable(document, segments)) {
        return;
    }
    const SegmentRef first = *segments.begin();
    const SharedCount shared = sharedCount(document, segments);
    std::optional<double> count = shared.count;
    form::label(context, "Elements");
    // Without a number, the address is one that no number has: the field has no expression yet, but can take one.
    const bool changed = form::optionalField(context, "inspector/elements", count, shared.hint.c_str(),
                                             shared.count ? form::halfWidth(context) : -1.0F,
                                             addressOfCount(shared.count ? first : SegmentRef()));
    ui::rowTooltip(context, explanation(segments.size()));
    if (shared.count) {
        drawMeshed(context, first, *shared.count);
        if (!changed) {
            biasRow(context, segments);
        }
    }
    if (!changed || (!count && !shared.count && shared.hint != "several")) {
        return; // an empty field left empty keeps a size
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

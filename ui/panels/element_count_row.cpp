#include "ui/panels/element_count_row.hpp"

#include "core/edit/element_counts.hpp"
#include "core/edit/shape_geometry.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

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

/// Returns the number of elements that the spacing asks for along a segment, ∫ds/ρ.
double expectedElements(const Document &document, SegmentRef segment, const SpacingField &spacing) {
    constexpr int kSamples = 64;
    const Outline outline = outlineOf(*findShape(document, segment.shape));
    double sum = 0.0;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.part(k) != segment.segment) {
            continue;
        }
        const Curve curve = outline.curve(k);
        Vec2 from = curve.point(0.0);
        for (int i = 1; i <= kSamples; ++i) {
            const Vec2 to = curve.point(static_cast<double>(i) / kSamples);
            sum += distance(from, to) / spacing.at(midpoint(from, to));
            from = to;
        }
    }
    return sum;
}

std::string explanation(const Shell &context, const std::set<SegmentRef> &segments, std::optional<double> count) {
    std::string text = segments.size() == 1 ? "Number of elements along this segment."
                                            : "Number of elements along each of the segments.";
    text += " Sets the size of a boundary part of its own. Leave empty for no size of its own.";
    const DocumentPreview &preview = *context.preview;
    if (!count || !preview.spacing || preview.revision != context.document.revision()) {
        return text;
    }
    const double expected = expectedElements(*context.document.current(), *segments.begin(), *preview.spacing);
    constexpr double kSame = 0.02;
    if (expected > (1.0 + kSame) * *count) {
        text += " Now about " + ui::number(std::round(expected), 4) +
                ": another size, of a part, a source or the automatic spacing, is smaller here.";
    } else if (expected < (1.0 - kSame) * *count) {
        text += " Now about " + ui::number(std::round(expected), 4) + ": the minimum size is larger.";
    }
    return text;
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
    const bool changed = form::optionalField(context, "inspector/elements", count, "auto");
    ui::rowTooltip(context, explanation(context, segments, before));
    if (!changed) {
        return;
    }
    constexpr double kMax = kMaxElementCount;
    if (count && !(*count >= 1.0 && *count <= kMax && *count == std::floor(*count))) {
        const std::string fault = "expected a whole number from 1 to " + ui::number(kMax, 7);
        context.log.add(error("bad-number", fault + ", got " + ui::number(*count, 6)));
        context.fieldFault = {"inspector/elements", fault, context.document.revision(), ImGui::GetFrameCount()};
        context.animate();
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

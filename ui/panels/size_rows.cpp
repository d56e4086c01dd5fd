#include "ui/panels/size_rows.hpp"

#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/panels/form.hpp"
#include "ui/panels/shared_number.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Returns the size that follows from the number of elements of a boundary part.
std::string followingSize(const Document &document, std::int32_t tag) {
    const std::optional<PartSize> size = elementSize(document, tag);
    return size ? ui::number(size->size, 4) : "auto";
}

} // namespace

void partSizeRow(Shell &context, std::int32_t tag) {
    const Document &document = *context.document.current();
    const auto found = document.spacing.partSizes.find(tag);
    const bool given = found != document.spacing.partSizes.end();
    const auto counted = document.elementCounts.find(tag);
    const bool follows = counted != document.elementCounts.end();
    if (!given && !follows && !document.boundaryNames.contains(tag)) {
        return;
    }
    std::optional<double> size = given ? std::optional(found->second.size) : std::nullopt;
    double growth = given ? found->second.growth : follows ? counted->second.growth : PartSize{}.growth;
    const std::string hint = follows ? followingSize(document, tag) : "auto";
    const NumberOwner part = NumberOwner::ofPart(tag);
    form::label(context, "Part size");
    bool changed = form::optionalField(context, "inspector/partsize", size, hint.c_str(), form::halfWidth(context),
                                       NumberAddress{part, Quantity::Size});
    const std::string whole = "'" + boundaryName(document.boundaryNames, tag) + "'";
    ui::rowTooltip(context, follows ? "Element size wherever the boundary is " + whole +
                                          ", which follows from its number of elements, and its growth per unit of "
                                          "distance. A size replaces the number."
                                    : "Maximum element size wherever the boundary is " + whole +
                                          ", and its growth per unit of distance. Leave empty to use the size from the "
                                          "Spacing panel.");
    ImGui::SameLine(0, context.px(6));
    ImGui::BeginDisabled(!size && !follows); // growth has no meaning without a size
    changed = ui::inputNumber(context, "inspector/partgrowth", growth, -1.0F, NumberAddress{part, Quantity::Growth}) ||
              changed;
    ImGui::EndDisabled();
    if (changed && follows && !size) {
        context.applyCommand(setPartElements(document, tag, PartElements{counted->second.count, growth}),
                             "Change size of boundary part");
    } else if (changed && (size || given)) {
        context.applyCommand(setPartSize(document, tag, size ? std::optional(PartSize{*size, growth}) : std::nullopt),
                             "Change size of boundary part");
    }
}

void regionSizeRow(Shell &context, std::uint32_t marker) {
    const Document &document = *context.document.current();
    const MarkedRegion &region = document.regionMarkers[marker];
    std::optional<double> size = region.size > 0.0 ? std::optional(region.size) : std::nullopt;
    double growth = region.growth;
    const NumberOwner owner = NumberOwner::ofRegion(marker);
    form::label(context, "Size, growth");
    bool changed = form::optionalField(context, "inspector/regionsize", size, "auto", form::halfWidth(context),
                                       NumberAddress{owner, Quantity::Size});
    ui::rowTooltip(context, "Maximum element size in this region, and its growth per unit of distance outside the "
                            "region. Leave empty to use the size from the Spacing panel.");
    ImGui::SameLine(0, context.px(6));
    ImGui::BeginDisabled(!size); // growth has no meaning without a size
    changed =
        ui::inputNumber(context, "inspector/regiongrowth", growth, -1.0F, NumberAddress{owner, Quantity::Growth}) ||
        changed;
    ImGui::EndDisabled();
    if (changed) {
        context.applyCommand(
            setRegionSize(document, marker, size ? std::optional(PartSize{*size, growth}) : std::nullopt),
            "Change size of region");
    }
}

namespace {

/// Returns the size and the growth that segments share. A number of elements counts as a size that is not shown.
std::pair<SharedNumber, SharedNumber> sharedSize(const Document &document, const std::set<SegmentRef> &segments) {
    SharedNumber size, growth;
    for (const SegmentRef &segment : segments) {
        const SegmentSize *const own = segmentSize(document, segment);
        size.add(own != nullptr && own->elements == 0 ? std::optional(own->size) : std::nullopt);
        if (own != nullptr) {
            growth.add(own->growth);
        }
    }
    return {size, growth};
}

/// Returns what an empty size field of segments shows: the size that their number of elements or their boundary part
/// gives, if it is the same for all.
std::string sizeHint(const Document &document, const std::set<SegmentRef> &segments) {
    std::set<std::string> hints;
    for (const SegmentRef &segment : segments) {
        const Shape &shape = *findShape(document, segment.shape);
        const SegmentSize *const own = segmentSize(document, segment);
        const std::int32_t tag = segmentTag(shape, segment.segment);
        const auto part = document.spacing.partSizes.find(tag);
        std::string hint = "auto";
        if (own != nullptr && own->elements > 0) {
            hint = ui::number(sizesOfParts(shape)[segment.segment].size, 4);
        } else if (own != nullptr) {
            hint = ui::number(own->size, 4);
        } else if (document.elementCounts.contains(tag)) {
            hint = followingSize(document, tag);
        } else if (part != document.spacing.partSizes.end()) {
            hint = ui::number(part->second.size, 4);
        }
        hints.insert(std::move(hint));
        if (hints.size() > 1) {
            return "several";
        }
    }
    return hints.empty() ? "auto" : *hints.begin();
}

/// Returns the size and the growth that nodes share.
std::pair<SharedNumber, SharedNumber> sharedSize(const Document &document, const std::set<NodeRef> &nodes) {
    SharedNumber size, growth;
    for (const NodeRef &node : nodes) {
        const auto &sizes = findShape(document, node.shape)->nodeSizes;
        const auto found = sizes.find(node.node);
        if (found == sizes.end()) {
            size.add(std::nullopt);
        } else {
            size.add(found->second.size);
            growth.add(found->second.growth);
        }
    }
    return {size, growth};
}

} // namespace

std::set<SegmentRef> segmentsOf(const Document &document, const std::set<std::uint32_t> &shapes) {
    std::set<SegmentRef> segments;
    for (const std::uint32_t id : shapes) {
        const Shape *const shape = findShape(document, id);
        const std::size_t count = shape != nullptr ? taggedSegments(*shape) : 0;
        for (std::uint32_t k = 0; k < count; ++k) {
            segments.insert({id, k});
        }
    }
    return segments;
}

void segmentSizeRow(Shell &context, const std::set<SegmentRef> &segments) {
    const Document &document = *context.document.current();
    if (segments.empty()) {
        return;
    }
    auto [size, growth] = sharedSize(document, segments);
    const SegmentRef first = *segments.begin();
    const bool any = std::any_of(segments.begin(), segments.end(), [&](const SegmentRef &segment) {
        return segmentSize(document, segment) != nullptr; // also one with a number of elements
    });
    const auto address = [&](Quantity what) {
        return segments.size() > 1 ? ui::FieldAddress()
                                   : NumberAddress{NumberOwner::ofShape(first.shape), what, first.segment};
    };
    const std::string hint = size.differs ? "several" : sizeHint(document, segments);
    form::label(context, "Size, growth");
    const bool sized = form::optionalField(context, "inspector/segmentsize", size.value, hint.c_str(),
                                           form::halfWidth(context), address(Quantity::SegmentSize));
    ui::rowTooltip(context, segments.size() == 1
                                ? "Maximum element size along it, and its growth per unit of distance. Leave empty to "
                                  "use the size of its boundary part or of the Spacing panel."
                                : "Maximum element size along all segments, and its growth per unit of distance. Leave "
                                  "empty to use the sizes of their boundary parts or of the Spacing panel.");
    ImGui::SameLine(0, context.px(6));
    ImGui::BeginDisabled(!any); // growth has no meaning without a size
    if (!any) {
        growth.value = PartSize{}.growth;
    }
    const bool grown = form::optionalField(context, "inspector/segmentgrowth", growth.value, growth.hint(), -1.0F,
                                           address(Quantity::SegmentGrowth));
    ImGui::EndDisabled();
    constexpr const char *kLabel = "Change size of segment";
    if (sized && size.value) {
        context.applyCommand(changeSegmentSizes(document, segments, {.size = size.value, .growth = {}}), kLabel);
    } else if (sized && size.given) {
        context.applyCommand(setSegmentSize(document, segments, std::nullopt), kLabel);
    } else if (grown && any) { // an empty field restores the usual growth
        const double wanted = growth.value.value_or(PartSize{}.growth);
        context.applyCommand(changeSegmentSizes(document, segments, {.size = {}, .growth = wanted}), kLabel);
    }
}

void nodeSizeRow(Shell &context, std::set<NodeRef> nodes) {
    const Document &document = *context.document.current();
    std::erase_if(nodes,
                  [&](const NodeRef &node) { return !canHaveSize(*findShape(document, node.shape), node.node); });
    if (nodes.empty()) {
        return;
    }
    auto [size, growth] = sharedSize(document, nodes);
    const NodeRef first = *nodes.begin();
    const auto address = [&](Quantity what) {
        return nodes.size() > 1 ? ui::FieldAddress()
                                : NumberAddress{NumberOwner::ofShape(first.shape), what, first.node};
    };
    form::label(context, "Size, growth");
    const bool sized = form::optionalField(context, "inspector/nodesize", size.value, size.hint(),
                                           form::halfWidth(context), address(Quantity::Size));
    ui::rowTooltip(context,
                   "Maximum element size at the node, and its growth per unit of distance. Leave empty to set none.");
    ImGui::SameLine(0, context.px(6));
    ImGui::BeginDisabled(!size.given); // growth has no meaning without a size
    if (!size.given) {
        growth.value = PartSize{}.growth;
    }
    const bool grown = form::optionalField(context, "inspector/nodegrowth", growth.value, growth.hint(), -1.0F,
                                           address(Quantity::Growth));
    ImGui::EndDisabled();
    constexpr const char *kLabel = "Change size at node";
    if (sized && size.value) {
        context.applyCommand(changeNodeSizes(document, nodes, {.size = size.value, .growth = {}}), kLabel);
    } else if (sized && size.given) {
        context.applyCommand(setNodeSize(document, nodes, std::nullopt), kLabel);
    } else if (grown && size.given) { // an empty field restores the usual growth
        const double wanted = growth.value.value_or(PartSize{}.growth);
        context.applyCommand(changeNodeSizes(document, nodes, {.size = {}, .growth = wanted}), kLabel);
    }
}

} // namespace forefront

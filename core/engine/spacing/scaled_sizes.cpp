#include "core/engine/spacing/scaled_sizes.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/parts/automatic/automatic.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"
#include "core/engine/spacing/parts/curvature/curvature_sites.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {
namespace {

void scale(std::optional<double> &value, double factor) {
    value = value ? std::optional(factor * *value) : std::nullopt;
}

/// Scales the upper bound of an automatic spacing. Where it would exceed what the domain allows, automatic spacing
/// ends: its rules become numbers.
void scaleAutomatic(SpacingSpec &spacing, double factor, const Domain &domain) {
    const double largest = automaticMaximum(spacingBox(domain));
    const bool lowered = spacing.maximum && *spacing.maximum < largest; // the size, rather than a limit of it
    const double scaled = factor * (lowered ? *spacing.maximum : largest);
    const double size = std::max(scaled, spacing.minimum.value_or(0.0)); // a minimum is kept
    if (size <= largest) {
        spacing.maximum = size;
        return;
    }
    spacing.size = size;
    if (lowered) {
        spacing.maximum.reset();
    }
    constexpr double kAcross = 2.0; // elements across narrow places, as of automatic spacing
    spacing.segmentsPerTurn = spacing.segmentsPerTurn.value_or(kSegmentsPerTurn / factor);
    spacing.elementsAcross = spacing.elementsAcross.value_or(kAcross / factor);
}

void scalePaint(PaintedSpacing &paint, double factor) {
    for (auto &[place, tile] : paint.tiles) {
        auto scaled = std::make_shared<PaintedSpacing::Tile>(*tile);
        for (float &value : *scaled) {
            value = static_cast<float>(factor * static_cast<double>(value));
        }
        tile = std::move(scaled);
    }
}

void scaleFunctions(SpacingSpec &spacing, double factor) {
    if (spacing.function) {
        spacing.function = [function = std::move(spacing.function), factor](Vec2 p) { return factor * function(p); };
    }
    if (spacing.bulkFunction) {
        spacing.bulkFunction = [function = std::move(spacing.bulkFunction), factor](std::span<const Vec2> positions,
                                                                                    std::span<double> sizes) {
            function(positions, sizes);
            for (double &size : sizes) {
                size *= factor;
            }
        };
    }
}

void scalePlaced(PlacedSizes &placed, double factor) {
    for (NodeSize &node : placed.nodes) {
        node.size *= factor;
    }
    for (RegionSize &region : placed.regions) {
        region.size *= factor;
        region.maxArea *= factor * factor;
    }
    for (PartSize &segment : placed.segments) {
        segment.size *= factor;
    }
}

/// Returns true if the parenthesis at `open` is closed by the last character of a text.
bool closesAtEnd(const std::string &text, std::size_t open) {
    int depth = 0;
    for (std::size_t at = open; at < text.size(); ++at) {
        depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
        if (depth == 0) {
            return at + 1 == text.size();
        }
    }
    return false;
}

} // namespace

std::string scaledExpression(const std::string &expression, double factor) {
    double before = 1.0;
    const char *const end = expression.data() + expression.size();
    const auto number = std::from_chars(expression.data(), end, before);
    const auto open = static_cast<std::size_t>(number.ptr - expression.data()) + 1;
    const bool factored = number.ec == std::errc() && expression.substr(open - 1, 2) == "*(" && before > 0.0 &&
                          closesAtEnd(expression, open);
    const double product = factored ? before * factor : factor;
    if (factored && product == 1.0) {
        return expression.substr(open + 1, expression.size() - open - 2);
    }
    return exactText(product) + "*(" + (factored ? expression.substr(open + 1) : expression + ")");
}

SpacingSpec scaledSizes(SpacingSpec spacing, double factor, const Domain &domain) {
    FOREFRONT_ASSERT(factor > 0.0);
    if (factor == 1.0) {
        return spacing;
    }
    scale(spacing.segmentsPerTurn, 1.0 / factor);
    scale(spacing.elementsAcross, 1.0 / factor);
    if (spacing.usesAutomatic()) {
        scaleAutomatic(spacing, factor, domain);
    } else {
        scale(spacing.size, factor);
    }
    if (spacing.expression) {
        spacing.expression = scaledExpression(*spacing.expression, factor);
    }
    scaleFunctions(spacing, factor);
    for (SizeSource &source : spacing.sources) {
        source.size *= factor;
        scale(source.endSize, factor);
    }
    scalePaint(spacing.paint, factor);
    if (spacing.background) {
        BackgroundMesh mesh = *spacing.background;
        for (double &value : mesh.values) {
            value *= factor;
        }
        spacing.background = std::make_shared<const BackgroundMesh>(std::move(mesh));
    }
    for (auto &[tag, part] : spacing.partSizes) {
        part.size *= factor;
    }
    scalePlaced(spacing.placed, factor);
    return spacing;
}

std::string unscaledSizes(const SpacingSpec &spacing) {
    std::vector<std::string> kept;
    if (spacing.minimum) {
        kept.push_back("the minimum spacing " + numberText(*spacing.minimum, 6));
    }
    if (spacing.maximum) {
        kept.push_back("the maximum spacing " + numberText(*spacing.maximum, 6));
    }
    if (spacing.fromBoundary) {
        kept.emplace_back("the boundary lengths");
    }
    const std::vector<std::uint32_t> &counts = spacing.placed.elements;
    if (std::any_of(counts.begin(), counts.end(), [](std::uint32_t count) { return count > 0; })) {
        kept.emplace_back("the given numbers of elements along segments");
    }
    std::string text;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == kept.size() ? " and " : ", ") + kept[k];
    }
    return text;
}

} // namespace forefront

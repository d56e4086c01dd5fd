#include "core/engine/spacing/spec/spec_check.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace forefront {
namespace {

bool isSize(double value) {
    return std::isfinite(value) && value > 0.0;
}

bool isNotNegative(double value) {
    return std::isfinite(value) && value >= 0.0;
}

std::string text(double value) {
    return numberText(value, 6);
}

} // namespace

void checkSize(const std::optional<double> &value, const std::string &name, Diagnostics &faults, const char *advice) {
    if (value && !isSize(*value)) {
        faults.push_back(
            error("bad-size", "invalid " + name + ' ' + text(*value) + "; expected a number above 0", advice).front());
    }
}

std::optional<Diagnostic> partSizeFault(const PartSize &part, const std::string &owner, const char *code) {
    if (!isSize(part.size)) {
        return error(code, owner + " has the size " + text(part.size) + "; expected a number above 0",
                     "enter a length in domain units, or leave the field empty")
            .front();
    }
    if (!isNotNegative(part.growth)) {
        return error(code, owner + " has the growth " + text(part.growth) + "; expected a number of at least 0",
                     "enter a growth such as 0.2")
            .front();
    }
    return std::nullopt;
}

void checkSegmentsPerTurn(const std::optional<double> &value, Diagnostics &faults) {
    if (value && !isNotNegative(*value)) {
        faults.push_back(error("bad-size",
                               "invalid number of elements per turn " + text(*value) + "; expected 0 or more",
                               "enter a number such as 40, or 0 to ignore the curvature")
                             .front());
    }
}

void checkElementsAcross(const std::optional<double> &value, Diagnostics &faults) {
    if (value && !isNotNegative(*value)) {
        faults.push_back(
            error("bad-size",
                  "invalid number of elements across narrow places " + text(*value) + "; expected 0 or more",
                  "enter a number such as 4, or 0 to ignore narrow places")
                .front());
    }
}

void checkSource(const SizeSource &source, std::uint32_t index, Diagnostics &faults) {
    const auto fault = [&](const std::string &what, const char *expected) {
        Diagnostic diagnostic;
        diagnostic.code = "bad-source";
        diagnostic.message = "size source " + std::to_string(index);
        if (!source.name.empty()) {
            diagnostic.message += " '" + source.name + "'";
        }
        diagnostic.message += " has " + what + "; expected " + expected;
        diagnostic.ids = {index};
        if (isFinite(source.a)) {
            diagnostic.at = source.a;
        }
        faults.push_back(std::move(diagnostic));
    };
    const bool two = source.shape == SourceShape::Line || source.shape == SourceShape::Box;
    if (!isFinite(source.a) || (two && !isFinite(source.b))) {
        fault("a coordinate that is not finite", "finite numbers");
    }
    if (!std::isfinite(source.angle)) {
        fault("the angle " + text(source.angle), "a finite number of degrees");
    }
    if (!isSize(source.size)) {
        fault("the size " + text(source.size), "a number above 0");
    }
    if (source.endSize && source.shape != SourceShape::Line) {
        fault("a size at a second end", "a line, or no such size");
    } else if (source.endSize && !isSize(*source.endSize)) {
        fault("the size " + text(*source.endSize) + " at its second end", "a number above 0");
    }
    if (source.plane && source.shape != SourceShape::Line) {
        fault("a gradient over the plane", "a line, or no gradient");
    } else if (source.plane && isFinite(source.a) && isFinite(source.b) &&
               !std::isfinite(1.0 / distanceSquared(source.a, source.b))) {
        fault("a gradient whose ends coincide", "two different places");
    }
    if (!isNotNegative(source.growth)) {
        fault("the growth " + text(source.growth), "a number of at least 0");
    }
    if (!isNotNegative(source.radius)) {
        fault("the radius " + text(source.radius), "a number of at least 0");
    }
}

void checkSources(std::span<const SizeSource> sources, Diagnostics &faults) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
        checkSource(sources[i], static_cast<std::uint32_t>(i), faults);
    }
}

void checkPartSizes(const std::map<std::int32_t, PartSize> &sizes, Diagnostics &faults) {
    for (const auto &[tag, part] : sizes) {
        if (auto fault = partSizeFault(part, "the boundary part with tag " + std::to_string(tag), "bad-source")) {
            faults.push_back(*std::move(fault));
        }
    }
}

void checkSegmentSizes(std::span<const PartSize> sizes, Diagnostics &faults) {
    for (std::size_t s = 0; s < sizes.size(); ++s) {
        if (sizes[s].size == 0.0) {
            continue; // none is given
        }
        if (auto fault = partSizeFault(sizes[s], "segment " + std::to_string(s), "bad-source")) {
            faults.push_back(*std::move(fault));
            return;
        }
    }
}

void checkBiases(std::span<const ElementBias> biases, Diagnostics &faults) {
    const auto bad = std::find_if(biases.begin(), biases.end(), [](const ElementBias &b) { return !b.isValid(); });
    if (bad != biases.end()) {
        faults.push_back(biasFault(*bad, "segment " + std::to_string(bad - biases.begin()), "bad-element-counts"));
    }
}

Diagnostic biasFault(const ElementBias &bias, const std::string &owner, std::string code) {
    return error(std::move(code),
                 "invalid bias " + numberText(bias.ratio, 6) + " of the elements of " + owner +
                     "; expected a ratio from 0.0001 to 10000",
                 "enter the length of the last element over that of the first")
        .front();
}

void checkNodeSizes(std::span<const NodeSize> sizes, Diagnostics &faults) {
    for (const NodeSize &node : sizes) {
        const std::string name = node.name.empty() ? "a node" : node.name;
        if (auto fault = partSizeFault({node.size, node.growth}, name, "bad-source")) {
            if (isFinite(node.at)) {
                fault->at = node.at;
            }
            faults.push_back(*std::move(fault));
        }
    }
}

void checkRegions(std::span<const RegionSize> regions, Diagnostics &faults) {
    for (std::uint32_t k = 0; k < regions.size(); ++k) {
        const RegionSize &region = regions[k];
        const auto add = [&](Diagnostic fault) {
            fault.ids = {k};
            if (isFinite(region.at)) {
                fault.at = region.at;
            }
            faults.push_back(std::move(fault));
        };
        if (!isNotNegative(region.maxArea)) {
            add(error("bad-region-area",
                      "invalid maximum area " + text(region.maxArea) + " of a region; expected a number above 0",
                      "set it to 0 for no limit")
                    .front());
        }
        const bool none = region.size == 0.0;
        if (auto fault = partSizeFault({none ? 1.0 : region.size, region.growth}, "a region", "bad-source")) {
            add(*std::move(fault));
        }
    }
}

void checkLimits(const SpacingSpec &spec, Diagnostics &faults) {
    checkSize(spec.minimum, "minimum spacing", faults);
    checkSize(spec.maximum, "maximum spacing", faults);
    checkSize(spec.gradation, "gradation", faults, "enter a gradation such as 0.25");
    if (spec.minimum && spec.maximum && isSize(*spec.minimum) && isSize(*spec.maximum) &&
        *spec.minimum > *spec.maximum) {
        faults.push_back(error("bad-size",
                               "the minimum spacing " + text(*spec.minimum) + " is greater than the maximum spacing " +
                                   text(*spec.maximum),
                               "swap them or remove one")
                             .front());
    }
}

} // namespace forefront

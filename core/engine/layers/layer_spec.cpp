#include "core/engine/layers/layer_spec.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"

#include <cmath>
#include <iterator>
#include <set>
#include <string>

namespace forefront {

std::optional<Diagnostic> layerFault(const LayerSpec &spec, std::string_view owner) {
    const auto fault = [&](const std::string &what, const char *advice) {
        return error("bad-layer", "boundary layers on " + std::string(owner) + ": " + what, advice).front();
    };
    const auto got = [](double value) { return ", got " + numberText(value, 6); };
    if (!(spec.first > 0.0 && std::isfinite(spec.first))) {
        return fault("expected a first height above 0" + got(spec.first), "set the height of the first layer");
    }
    if (!(spec.growth >= 1.0 && spec.growth <= 4.0)) {
        return fault("expected a growth from 1 to 4" + got(spec.growth), "choose a growth such as 1.2");
    }
    if (spec.count && spec.thickness) {
        return fault("both a count and a thickness are given", "remove one of them");
    }
    if (spec.count && (*spec.count < 1 || *spec.count > kMaxLayers)) {
        return fault("expected a count from 1 to " + std::to_string(kMaxLayers) + ", got " +
                         std::to_string(*spec.count),
                     "choose a count within this range");
    }
    if (spec.thickness && !(*spec.thickness >= spec.first && std::isfinite(*spec.thickness))) {
        return fault("expected a thickness of at least the first height" + got(*spec.thickness),
                     "choose a larger thickness or a smaller first height");
    }
    if (spec.thickness) {
        double height = spec.first, top = spec.first;
        std::uint32_t layers = 1;
        while (layers <= kMaxLayers && top + 0.5 * (height *= spec.growth) <= *spec.thickness) {
            top += height;
            ++layers;
        }
        if (layers > kMaxLayers) {
            return fault("a thickness of " + numberText(*spec.thickness, 6) + " takes more than " +
                             std::to_string(kMaxLayers) + " layers",
                         "choose a larger first height or growth, or a smaller thickness");
        }
    }
    if (spec.count && !std::isfinite(spec.first * std::pow(spec.growth, *spec.count))) {
        return fault(std::to_string(*spec.count) + " layers that grow by " + numberText(spec.growth, 6) +
                         " are higher than numbers reach",
                     "choose a smaller count or growth");
    }
    if (!spec.count && !spec.thickness && spec.growth < kMinGrowthToIsotropic) {
        return fault("layers that grow by " + numberText(spec.growth, 6) + " do not become isotropic",
                     "add a count or a thickness, or choose a growth of at least 1.01");
    }
    return std::nullopt;
}

Diagnostics checkLayers(std::span<const LayerSpec> specs, const Domain &domain) {
    Diagnostics faults;
    if (specs.empty()) {
        return faults;
    }
    std::set<std::int32_t> present, seen;
    for (const DomainSegment &segment : domain.segments) {
        present.insert(segment.tag);
    }
    for (const LayerSpec &spec : specs) {
        const std::string name = boundaryName(domain.boundaryNames, spec.tag);
        if (!present.contains(spec.tag)) {
            std::string parts;
            for (const std::int32_t tag : present) {
                parts += (parts.empty() ? "" : ", ") + boundaryName(domain.boundaryNames, tag);
            }
            faults.push_back(error("unknown-boundary",
                                   "boundary layers on " + name + ": boundary part not found; expected one of " + parts,
                                   "choose one of these parts")
                                 .front());
        } else if (!seen.insert(spec.tag).second) {
            faults.push_back(
                error("repeated-layer", "boundary layers on " + name + " are given twice", "keep one of them").front());
        } else if (std::optional<Diagnostic> fault = layerFault(spec, name)) {
            faults.push_back(std::move(*fault));
        }
    }
    return faults;
}

} // namespace forefront

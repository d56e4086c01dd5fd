#include "core/spacing/spec/spec_check.hpp"

#include <cmath>

namespace forefront {
namespace {

bool isSize(double value) {
    return std::isfinite(value) && value > 0.0;
}

void checkSize(const std::optional<double> &value, const char *name, Diagnostics &faults) {
    if (value && !isSize(*value)) {
        faults.push_back(error("bad-size", std::string("The ") + name + " is not a finite number greater than zero",
                               "give a length in domain units")
                             .front());
    }
}

void checkSource(const SizeSource &source, std::uint32_t index, Diagnostics &faults) {
    const auto fault = [&](const char *what) {
        Diagnostic diagnostic;
        diagnostic.code = "bad-source";
        diagnostic.message = "Size source " + std::to_string(index);
        if (!source.name.empty()) {
            diagnostic.message += " '" + source.name + "'";
        }
        diagnostic.message += what;
        diagnostic.ids = {index};
        if (isFinite(source.a)) {
            diagnostic.at = source.a;
        }
        faults.push_back(std::move(diagnostic));
    };
    if (!isFinite(source.a) || (source.shape == SourceShape::Line && !isFinite(source.b))) {
        fault(" has a place that is not finite");
    }
    if (!isSize(source.size)) {
        fault(" has a size that is not a finite number greater than zero");
    }
    if (!std::isfinite(source.growth) || source.growth < 0.0) {
        fault(" has a growth that is not a finite number of at least zero");
    }
    if (!std::isfinite(source.radius) || source.radius < 0.0) {
        fault(" has a radius that is not a finite number of at least zero");
    }
}

} // namespace

Diagnostics checkSpec(const SpacingSpec &spec) {
    Diagnostics faults;
    checkSize(spec.size, "spacing", faults);
    checkSize(spec.minimum, "least spacing", faults);
    checkSize(spec.maximum, "greatest spacing", faults);
    checkSize(spec.gradation, "gradation", faults);
    if (faults.empty() && spec.minimum && spec.maximum && *spec.minimum > *spec.maximum) {
        faults = error("bad-size", "The least spacing is greater than the greatest");
    }
    for (std::size_t i = 0; i < spec.sources.size(); ++i) {
        checkSource(spec.sources[i], static_cast<std::uint32_t>(i), faults);
    }
    return faults;
}

} // namespace forefront

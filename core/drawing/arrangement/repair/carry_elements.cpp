#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/element_shares.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// A part of a straight segment of a domain before its repair.
struct CarriedPart {
    std::uint32_t source = 0, segment = 0;
    double from = 0.0, to = 1.0; ///< fractions of the length of the source; `to` < `from`: in the other direction

    double low() const { return std::min(from, to); }
    double high() const { return std::max(from, to); }
    friend bool operator<(const CarriedPart &a, const CarriedPart &b) {
        return std::tuple(a.source, a.low(), a.segment) < std::tuple(b.source, b.low(), b.segment);
    }
};

class ElementCarrier {
  public:
    ElementCarrier(const Domain &before, const Repaired &repaired, PlacedSizes &placed)
        : before_(before), repaired_(repaired), placed_(placed), given_(std::exchange(placed.elements, {})),
          biases_(std::exchange(placed.biases, {})) {}

    Diagnostics run() {
        const std::vector<DomainSegment> &segments = repaired_.domain.segments;
        std::vector<CarriedPart> parts;
        for (std::uint32_t s = 0; s < segments.size(); ++s) {
            const std::uint32_t source = repaired_.segmentSource[s];
            placed_.elements.push_back(source < given_.size() ? given_[source] : 0);
            if (!biases_.empty()) {
                placed_.biases.push_back(source < biases_.size() ? biases_[source] : ElementBias{});
            }
            if (placed_.elements[s] > 0 && !segments[s].stretch.follows() && isValid(before_, source) &&
                isValid(repaired_.domain, s)) {
                parts.push_back(partOf(source, s));
            }
        }
        std::sort(parts.begin(), parts.end());
        for (auto first = parts.cbegin(); first != parts.cend();) {
            const auto end = std::find_if(first, parts.cend(), [source = first->source](const CarriedPart &part) {
                return part.source != source;
            });
            share({first, end});
            first = end;
        }
        return std::move(losses_);
    }

  private:
    static bool isValid(const Domain &domain, std::uint32_t segment) {
        const DomainSegment &of = domain.segments[segment];
        return of.a < domain.nodes.size() && of.b < domain.nodes.size() && domain.nodes[of.a] != domain.nodes[of.b];
    }

    CarriedPart partOf(std::uint32_t source, std::uint32_t segment) const {
        const DomainSegment &whole = before_.segments[source], &part = repaired_.domain.segments[segment];
        const Vec2 start = before_.nodes[whole.a], way = before_.nodes[whole.b] - start;
        const auto along = [&](std::uint32_t node) {
            return std::clamp(dot(repaired_.domain.nodes[node] - start, way) / lengthSquared(way), 0.0, 1.0);
        };
        return {source, segment, along(part.a), along(part.b)};
    }

    /// Divides the elements of a segment among its parts, and among the stretches that others have taken.
    void share(std::span<const CarriedPart> parts) {
        constexpr double kRounding = 1e-3; // of its length: a repair moves nodes a little
        const std::uint32_t source = parts.front().source, count = given_[source];
        std::vector<double> ends;
        std::vector<const CarriedPart *> owners; // null: another segment has this stretch
        for (const CarriedPart &part : parts) {
            const double reached = ends.empty() ? 0.0 : ends.back();
            if (part.low() > reached + kRounding) {
                ends.push_back(part.low());
                owners.push_back(nullptr);
            }
            ends.push_back(std::max(part.high(), reached));
            owners.push_back(&part);
        }
        if (ends.back() < 1.0 - kRounding) {
            ends.push_back(1.0);
            owners.push_back(nullptr);
        }
        ends.back() = 1.0;
        const ElementBias bias = source < biases_.size() ? biases_[source] : ElementBias{};
        const std::vector<ElementShare> shares = shareElements(count, bias, ends);
        std::uint32_t total = 0, taken = 0, unbiased = 0;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            total += shares[k].elements;
            taken += owners[k] == nullptr ? shares[k].elements : 0;
            if (owners[k] != nullptr) {
                unbiased += shares[k].keepsBias ? 0 : shares[k].elements;
                give(*owners[k], shares[k]);
            }
        }
        report(source, {taken, total, unbiased});
    }

    void give(const CarriedPart &part, const ElementShare &share) {
        placed_.elements[part.segment] = share.elements;
        if (!biases_.empty()) {
            placed_.biases[part.segment] = part.from <= part.to ? share.bias : share.bias.reversed();
        }
    }

    /// Numbers of elements of a segment that its parts do not keep.
    struct Loss {
        std::uint32_t taken = 0;    ///< along stretches that other segments have
        std::uint32_t total = 0;    ///< of all parts together
        std::uint32_t unbiased = 0; ///< of parts without the bias
    };

    void report(std::uint32_t source, const Loss &loss) {
        const std::uint32_t count = given_[source];
        const std::string segment = "a segment with " + countText(count, "element");
        if (loss.taken > 0) {
            warn(source, segment + " keeps " + std::to_string(loss.total - loss.taken) +
                             " of them: along the rest of it, another segment takes its place");
        }
        if (loss.total > count) {
            warn(source, segment + " was divided into more parts, which have " + std::to_string(loss.total));
        }
        if (loss.unbiased > 0) {
            warn(source, segment + " and a bias was divided, and " + std::to_string(loss.unbiased) +
                             " of them are equally long now: their lengths rise and fall, which no bias describes");
        }
    }

    void warn(std::uint32_t source, std::string message) {
        const DomainSegment &segment = before_.segments[source];
        Diagnostic lost;
        lost.severity = Severity::Warning;
        lost.code = "lost-elements";
        lost.message = std::move(message);
        lost.at = 0.5 * (before_.nodes[segment.a] + before_.nodes[segment.b]);
        lost.parts = {aSegment(source)};
        losses_.push_back(std::move(lost));
    }

    const Domain &before_;
    const Repaired &repaired_;
    PlacedSizes &placed_;
    std::vector<std::uint32_t> given_;
    std::vector<ElementBias> biases_;
    Diagnostics losses_;
};

} // namespace

Diagnostics carryElements(const Domain &before, const Repaired &repaired, SpacingSpec &spacing) {
    if (!spacing.placed.segments.empty()) {
        const std::vector<PartSize> given = std::exchange(spacing.placed.segments, {});
        for (const std::uint32_t source : repaired.segmentSource) {
            spacing.placed.segments.push_back(source < given.size() ? given[source] : PartSize{0.0, 0.0});
        }
    }
    return spacing.placed.elements.empty() ? Diagnostics() : ElementCarrier(before, repaired, spacing.placed).run();
}

} // namespace forefront

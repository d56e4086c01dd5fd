#include "core/engine/spacing/spacing_field.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/spacing/combined_field.hpp"
#include "core/engine/spacing/field_of_rules.hpp"
#include "core/engine/spacing/kept_field.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/engine/spacing/parts/automatic/automatic.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"
#include "core/engine/spacing/parts/curvature/curvature_sites.hpp"
#include "core/engine/spacing/replaced_field.hpp"
#include "core/engine/spacing/tolerance_field.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace forefront {
namespace {

constexpr double kFarBeyond = 1e3;         ///< diagonals of the domain's box
constexpr std::size_t kMaxLinearSites = 6; ///< up to this number, sites are evaluated one by one
/// Above these numbers, speed counts more than accuracy.
constexpr std::size_t kManyOwnSites = 2048, kManyPaintSites = 256;
constexpr double kPaintCellsPerSize = 4.0; ///< keeps the gradation within 2 %

/// Gathers the parts of one specification.
class FieldBuilder {
  public:
    FieldBuilder(const SpacingSpec &spec, const Domain &domain, const Progress &progress)
        : spec_(spec),
          faces_(domain, progress.stop, placesOf(spec.placed.regions)), input_{
                                                                            spec,
                                                                            domain,
                                                                            faces_,
                                                                            spacingBox(domain),
                                                                            spec.minimum.value_or(0.0),
                                                                            spec.gradation.value_or(kDefaultGradation),
                                                                            progress} {
        parts_.cap = std::numeric_limits<double>::infinity();
        parts_.minimum = input_.minimum;
        parts_.words.boundaryNames = domain.boundaryNames;
        parts_.words.segmentTags.reserve(domain.segments.size());
        for (const DomainSegment &segment : domain.segments) {
            parts_.words.segmentTags.push_back(segment.tag);
        }
    }

    Result<std::shared_ptr<const SpacingField>> run() {
        if (Diagnostics faults = checkSpacing(spec_, input_.domain); !faults.empty()) {
            return faults;
        }
        for (const SpacingPartKind &kind : spacingPartKinds()) {
            if (kind.given(spec_)) {
                if (Diagnostics faults = kind.add(input_, parts_); !faults.empty()) {
                    return faults;
                }
            }
        }
        limitCap();
        // Paint and region areas reach everywhere by gradation, but their values far away are not intended; a
        // background mesh may end inside the domain.
        if (spec_.usesAutomatic()) {
            addAutomatic();
        }
        return finish();
    }

  private:
    void limitCap() {
        if (spec_.maximum) {
            parts_.lowerCap(*spec_.maximum, SpacingOrigin::Maximum);
        }
        if (parts_.cap == std::numeric_limits<double>::infinity()) { // the spacing must be finite everywhere
            parts_.lowerCap(kFarBeyond * input_.box.diagonal(), SpacingOrigin::Automatic);
            parts_.capIsRule = false;
        }
        if (parts_.cap < parts_.minimum) {
            parts_.cap = parts_.minimum;
            parts_.capOrigin = SpacingOrigin::Minimum;
            parts_.capIsRule = true;
        }
    }
    void addAutomatic() {
        auto &background = parts_.point<FilledBackground>();
        auto &regions = parts_.point<RegionPart>();
        const double largest = regions && !background ? regions->largest() : 0.0;
        AutomaticSpacing automatic = automaticSpacing(
            input_.domain, faces_, spec_.placed.counts(), input_.box, input_.minimum, input_.gradation, largest,
            spec_.segmentsPerTurn ? 0.0 : kSegmentsPerTurn, !spec_.elementsAcross, input_.progress);
        gradation_ = automatic.gradation;
        if (!background) {
            if (largest > automatic.maximum) { // a region that may be coarser is
                regions->limitOthers(automatic.maximum, input_.gradation, parts_.few);
            } else {
                parts_.lowerCap(automatic.maximum, SpacingOrigin::Automatic);
            }
            for (std::size_t i = 0; i < automatic.sites.sites.size(); ++i) {
                parts_.few.add(automatic.sites.sites[i], automatic.sites.labels[i]);
            }
            return;
        }
        // Beyond its border the mesh's spacing grows by the gradation, so that there is no step.
        BackgroundPart::addBorderSites(*spec_.background, input_.minimum, input_.gradation, automatic.sites,
                                       input_.progress);
        if (input_.progress.cancelled()) {
            return; // there may be no site yet; finish() reports the cancellation
        }
        if (auto tree = SiteTree::build(std::move(automatic.sites.sites), input_.box, input_.progress)) {
            background->fill(std::max(automatic.maximum, input_.minimum), std::move(*tree),
                             std::move(automatic.sites.labels));
        }
    }
    /// Returns how accurately to meet the sites. Those that follow from the domain alone need not be met as exactly as
    /// those that a user sets; nor need those at the edges of paint: there are many, and meshes follow the brush.
    SpreadOptions spreadOptions() const {
        const std::vector<SiteLabel> &labels = parts_.few.labels;
        const auto count = [&](SpacingOrigin origin) {
            return static_cast<std::size_t>(std::count_if(
                labels.begin(), labels.end(), [origin](const SiteLabel &label) { return label.origin == origin; }));
        };
        const std::size_t paint = count(SpacingOrigin::Paint);
        const std::size_t own = count(SpacingOrigin::Automatic) + count(SpacingOrigin::Boundary);
        if (paint + own < labels.size()) {
            return {};
        }
        if (paint == 0) {
            return {.many = kManyOwnSites};
        }
        return paint > kManyPaintSites ? SpreadOptions{kManyPaintSites, kPaintCellsPerSize} : SpreadOptions{};
    }
    /// Removes the sites of sources and returns them, if there are few of them among many at the edges of paint or of
    /// automatic spacing. Away from the sources, the spacing is then as without them.
    SiteSet takeSources() {
        SiteSet sources, others;
        std::size_t paint = 0;
        for (std::size_t i = 0; i < parts_.few.sites.size(); ++i) {
            const SiteLabel &label = parts_.few.labels[i];
            (label.origin == SpacingOrigin::Source ? sources : others).add(parts_.few.sites[i], label);
            paint += label.origin == SpacingOrigin::Paint ? 1 : 0;
        }
        const bool apart = paint > kManyPaintSites || (spec_.keepAutomatic.value_or(false) && spec_.usesAutomatic());
        if (!apart || sources.sites.size() > kMaxLinearSites) {
            return {};
        }
        parts_.few = std::move(others);
        return sources;
    }
    Result<std::shared_ptr<const SpacingField>> finish() {
        if (input_.progress.cancelled()) {
            return cancelled("preparing the spacing");
        }
        const Diagnostics notes = std::exchange(parts_.notes, {});
        if (parts_.few.sites.size() > kMaxLinearSites) {
            SiteSet sources = takeSources();
            parts_.tree = SiteTree::build(std::move(parts_.few.sites), input_.box, input_.progress, spreadOptions());
            parts_.treeLabels = std::move(parts_.few.labels);
            parts_.few = std::move(sources);
            if (!parts_.tree) {
                return cancelled("preparing the spacing");
            }
        }
        std::shared_ptr<SpacingField> field = assembled();
        field->addNotes(notes);
        const bool steep = spec_.expression || spec_.hasFunction() || spec_.background;
        field->setGradation(steep ? input_.steepest() : gradation_);
        return std::shared_ptr<const SpacingField>(std::move(field));
    }
    std::shared_ptr<SpacingField> assembled() {
        if (parts_.tree || !parts_.few.sites.empty()) {
            return std::make_shared<CombinedField>(std::move(parts_), input_.box);
        }
        if (!parts_.anyPoint()) {
            return std::make_shared<ConstantField>(std::max(parts_.cap, parts_.minimum), parts_.capOrigin);
        }
        auto &expression = parts_.point<ExpressionSpacing>();
        const auto given = [&](const SpacingPartKind &kind) { return kind.given(spec_); };
        const std::span<const SpacingPartKind> kinds = spacingPartKinds();
        if (expression && std::count_if(kinds.begin(), kinds.end(), given) == 1) { // its limits are its own
            return std::make_shared<ExpressionField>(std::move(*expression));
        }
        return std::make_shared<CombinedField>(std::move(parts_), input_.box);
    }

    const SpacingSpec &spec_;
    LazyFaces faces_;
    PartInput input_;
    FieldParts parts_;
    double gradation_ = input_.gradation;
};

} // namespace

Result<std::shared_ptr<const SpacingField>> fieldOfRules(const SpacingSpec &spec, const Domain &domain,
                                                         const Progress &progress) {
    return FieldBuilder(spec, domain, progress).run();
}

Result<std::shared_ptr<const SpacingField>> SpacingField::build(const SpacingSpec &spec, const Domain &domain,
                                                                const Progress &progress, GivenSegments segments) {
    const bool replaces = spec.paint.replaces && !spec.paint.tiles.empty();
    Result<std::shared_ptr<const SpacingField>> field =
        replaces ? ReplacedField::build(spec, domain, progress) : fieldOfRules(spec, domain, progress);
    if (!field) {
        return field;
    }
    if (segments == GivenSegments::Divided) {
        return ToleranceField::limit(*std::move(field), spec, domain, progress);
    }
    // The chords of curves stay as they are. Where their lengths set the size, none is too long for it.
    return spec.fromBoundary ? field : KeptField::raise(*std::move(field), domain, progress);
}

} // namespace forefront

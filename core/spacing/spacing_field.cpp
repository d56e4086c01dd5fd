#include "core/spacing/spacing_field.hpp"

#include "core/spacing/combined_field.hpp"
#include "core/spacing/parts/automatic/automatic.hpp"
#include "core/spacing/parts/automatic/boundary_spacing.hpp"
#include "core/spacing/parts/sources/source_sites.hpp"
#include "core/spacing/spec/spec_check.hpp"

#include <limits>

namespace forefront {
namespace {

constexpr double kUsualGradation = 0.25; ///< of painted, boundary and automatic parts where none is given
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kFarBeyond = 1e3; ///< diagonals of the domain's box
constexpr std::size_t kFew = 6;    ///< sites up to this number are looked at one by one

/// Gathers the parts of one specification.
class FieldBuilder {
  public:
    FieldBuilder(const SpacingSpec &spec, const Domain &domain, const Progress &progress)
        : spec_(spec), domain_(domain), progress_(progress), box_(spacingBox(domain)) {
        parts_.minimum = spec.minimum.value_or(0.0);
        parts_.gradation = spec.gradation.value_or(kUsualGradation);
    }

    Result<std::shared_ptr<const SpacingField>> run() {
        if (Diagnostics faults = checkSpec(spec_); !faults.empty()) {
            return faults;
        }
        setCap();
        Diagnostics faults = addExpression();
        if (faults.empty()) {
            faults = addPaint();
        }
        if (faults.empty()) {
            faults = addBackground();
        }
        if (!faults.empty()) {
            return faults;
        }
        addSources();
        if (spec_.fromBoundary) {
            addBoundarySites(domain_, parts_.minimum, parts_.gradation, sites_);
        }
        if (saysNothingSomewhere()) {
            addAutomatic();
        }
        return finish();
    }

  private:
    /// True where no part covers the whole domain in its own right: automatic spacing does, then. Paint reaches
    /// everywhere by gradation, but what it says far away is no one's wish; a background mesh may end inside the
    /// domain.
    bool saysNothingSomewhere() const {
        return !spec_.size && !spec_.expression && spec_.sources.empty() && !spec_.fromBoundary;
    }
    void lowerCap(double size, SpacingOrigin origin) {
        if (size < parts_.cap) {
            parts_.cap = size;
            parts_.capOrigin = origin;
        }
    }
    void setCap() {
        parts_.cap = kNoLimit;
        if (spec_.size) {
            lowerCap(*spec_.size, SpacingOrigin::Constant);
        }
        if (spec_.maximum) {
            lowerCap(*spec_.maximum, SpacingOrigin::Maximum);
        }
        if (parts_.cap == kNoLimit) { // so that the spacing is finite whatever the parts say
            parts_.cap = kFarBeyond * box_.diagonal();
            parts_.capOrigin = SpacingOrigin::Automatic;
        }
        if (parts_.cap < parts_.minimum) {
            parts_.cap = parts_.minimum;
            parts_.capOrigin = SpacingOrigin::Minimum;
        }
    }
    Diagnostics addExpression() {
        if (!spec_.expression) {
            return {};
        }
        auto expression = ExpressionSpacing::build(spec_, domain_, box_);
        if (!expression) {
            return expression.faults();
        }
        parts_.expression = std::move(*expression);
        if (spec_.gradation) {
            parts_.expression->addSteepSites(box_, *spec_.gradation, sites_, progress_);
        }
        return {};
    }
    Diagnostics addPaint() {
        if (spec_.paint.tiles.empty()) {
            return {};
        }
        auto painted = PaintedPart::build(spec_.paint, box_, parts_.minimum);
        if (!painted) {
            return painted.faults();
        }
        parts_.paint = std::move(*painted);
        PaintedPart::addSites(spec_.paint, parts_.minimum, parts_.gradation, sites_);
        return {};
    }
    Diagnostics addBackground() {
        if (!spec_.background) {
            return {};
        }
        auto background = BackgroundPart::build(*spec_.background, parts_.minimum, progress_);
        if (!background) {
            return background.faults();
        }
        parts_.background = std::move(*background);
        if (spec_.gradation) {
            BackgroundPart::addBorderSites(*spec_.background, parts_.minimum, *spec_.gradation, sites_, progress_);
            BackgroundPart::addSteepSites(*spec_.background, parts_.minimum, *spec_.gradation, sites_);
        }
        return {};
    }
    void addSources() {
        addSourceSites(spec_.sources, parts_.minimum, spec_.gradation.value_or(kNoLimit), sites_);
        for (const SizeSource &source : spec_.sources) {
            parts_.sourceNames.push_back(source.name);
        }
    }
    void addAutomatic() {
        AutomaticSpacing automatic = automaticSpacing(domain_, box_, parts_.minimum, parts_.gradation, progress_);
        if (!parts_.background) {
            lowerCap(automatic.greatest, SpacingOrigin::Automatic);
            for (std::size_t i = 0; i < automatic.sites.sites.size(); ++i) {
                sites_.add(automatic.sites.sites[i], automatic.sites.labels[i]);
            }
            return;
        }
        // Where the mesh ends its spacing reaches on, so that there is no step.
        BackgroundPart::addBorderSites(*spec_.background, parts_.minimum, parts_.gradation, automatic.sites, progress_);
        if (progress_.cancelled()) {
            return; // there may be no site yet; finish() says so
        }
        parts_.fillerCap = std::max(automatic.greatest, parts_.minimum);
        parts_.fillerLabels = std::move(automatic.sites.labels);
        parts_.filler = SiteTree::build(std::move(automatic.sites.sites), box_, progress_);
    }
    static Diagnostics cancelled() { return error("cancelled", "Preparing the spacing was cancelled"); }
    Result<std::shared_ptr<const SpacingField>> finish() {
        if (progress_.cancelled()) {
            return cancelled();
        }
        if (sites_.sites.size() <= kFew) {
            parts_.few = std::move(sites_);
        } else {
            parts_.tree = SiteTree::build(std::move(sites_.sites), box_, progress_);
            parts_.treeLabels = std::move(sites_.labels);
            if (!parts_.tree) {
                return cancelled();
            }
        }
        const bool sited = parts_.tree || !parts_.few.sites.empty();
        if (!sited && !parts_.expression && !parts_.paint && !parts_.background) {
            return std::shared_ptr<const SpacingField>(
                std::make_shared<ConstantField>(std::max(parts_.cap, parts_.minimum), parts_.capOrigin));
        }
        if (!sited && !parts_.paint && !parts_.background && !spec_.size) {
            return std::shared_ptr<const SpacingField>(
                std::make_shared<ExpressionField>(std::move(*parts_.expression)));
        }
        return std::shared_ptr<const SpacingField>(std::make_shared<CombinedField>(std::move(parts_), box_));
    }

    const SpacingSpec &spec_;
    const Domain &domain_;
    const Progress &progress_;
    Box2 box_;
    SpacingParts parts_;
    SiteSet sites_;
};

} // namespace

Result<std::shared_ptr<const SpacingField>> SpacingField::build(const SpacingSpec &spec, const Domain &domain,
                                                                const Progress &progress) {
    return FieldBuilder(spec, domain, progress).run();
}

} // namespace forefront

#pragma once

#include "core/spacing/parts/background/background_part.hpp"
#include "core/spacing/parts/expression/expression_spacing.hpp"
#include "core/spacing/parts/paint/painted_part.hpp"
#include "core/spacing/sites/site_set.hpp"
#include "core/spacing/sites/site_tree.hpp"
#include "core/spacing/spacing_field.hpp"

#include <optional>

namespace forefront {

/// The same spacing everywhere.
class ConstantField final : public SpacingField {
  public:
    ConstantField(double rho, SpacingOrigin origin) : rho_(rho), origin_(origin) {}
    double at(Vec2) const override { return rho_; }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override;
    SpacingSample sample(Vec2 p) const override;
    double minimum() const override { return rho_; }
    double maximum() const override { return rho_; }

  private:
    double rho_;
    SpacingOrigin origin_;
};

/// An expression alone, limits included.
class ExpressionField final : public SpacingField {
  public:
    explicit ExpressionField(ExpressionSpacing expression) : expression_(std::move(expression)) {}
    double at(Vec2 p) const override { return expression_.at(p); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override { expression_.atMany(points, rho); }
    SpacingSample sample(Vec2 p) const override;
    double minimum() const override { return expression_.minimum(); }
    double maximum() const override { return expression_.maximum(); }

  private:
    ExpressionSpacing expression_;
};

/// What a combined field is made of. Every part is already clamped and limited, so that the minimum of them is, too.
struct SpacingParts {
    double cap = 0.0; ///< constant, maximum or greatest automatic spacing: finite wherever nothing else is
    SpacingOrigin capOrigin = SpacingOrigin::Constant;
    double minimum = 0.0;
    double gradation = 0.0; ///< in force for painted, boundary and automatic parts
    std::optional<ExpressionSpacing> expression;
    std::optional<PaintedPart> paint;
    std::optional<BackgroundPart> background;
    /// Consulted only where the background mesh says nothing and no other part covers the domain.
    double fillerCap = std::numeric_limits<double>::infinity();
    std::optional<SiteTree> filler;
    std::vector<SiteLabel> fillerLabels;
    SiteSet few;                  ///< looked at one by one
    std::optional<SiteTree> tree; ///< many
    std::vector<SiteLabel> treeLabels;
    std::vector<std::string> sourceNames; ///< of SpacingSpec::sources
};

/// Minimum of all parts.
class CombinedField final : public SpacingField {
  public:
    /// The bounds are those over `box`.
    CombinedField(SpacingParts parts, const Box2 &box);
    double at(Vec2 p) const override { return inlineAt(p); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override;
    SpacingSample sample(Vec2 p) const override;
    double minimum() const override { return minimum_; }
    double maximum() const override { return maximum_; }

  private:
    double backgroundAt(Vec2 p) const {
        const double rho = parts_.background->at(p);
        return rho < std::numeric_limits<double>::infinity() || !parts_.filler
                   ? rho
                   : std::min(parts_.fillerCap, parts_.filler->at(p));
    }
    double inlineAt(Vec2 p) const {
        double rho = parts_.cap;
        for (const SizeSite &site : parts_.few.sites) {
            rho = std::min(rho, site.at(p));
        }
        if (parts_.expression) {
            rho = std::min(rho, parts_.expression->at(p));
        }
        if (parts_.background) {
            rho = std::min(rho, backgroundAt(p));
        }
        if (parts_.paint) {
            rho = std::min(rho, parts_.paint->at(p));
        }
        if (parts_.tree) {
            rho = std::min(rho, parts_.tree->at(p));
        }
        return std::max(rho, parts_.minimum);
    }
    void describeBackground(Vec2 p, SpacingSample &sample) const;
    void describeSite(const SizeSite &site, const SiteLabel &label, Vec2 p, SpacingSample &sample) const;

    SpacingParts parts_;
    double minimum_ = 0.0;
    double maximum_ = 0.0;
};

} // namespace forefront

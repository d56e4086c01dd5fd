#pragma once

#include "core/engine/spacing/parts/background/background_part.hpp"
#include "core/engine/spacing/parts/expression/expression_spacing.hpp"
#include "core/engine/spacing/parts/function/function_spacing.hpp"
#include "core/engine/spacing/parts/paint/painted_part.hpp"
#include "core/engine/spacing/parts/regions/region_part.hpp"
#include "core/engine/spacing/parts/sources/box_sources.hpp"
#include "core/engine/spacing/parts/sources/graded_sources.hpp"
#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/sites/site_tree.hpp"
#include "core/engine/spacing/sites/site_words.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <optional>
#include <tuple>
#include <type_traits>

namespace forefront {

/// A field with the same spacing everywhere.
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

/// A field given by an expression alone, limits included. Faster than a combined field, above all for many points at
/// once.
class ExpressionField final : public SpacingField {
  public:
    explicit ExpressionField(ExpressionSpacing expression) : expression_(std::move(expression)) {}
    double at(Vec2 p) const override { return expression_.at(p); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override { expression_.atMany(points, rho); }
    SpacingSample sample(Vec2 p) const override { return expression_.sample(p, {}); }
    double minimum() const override { return expression_.minimum(); }
    double maximum() const override { return expression_.maximum(); }

  private:
    ExpressionSpacing expression_;
};

/// A background mesh together with automatic spacing for the places that it does not cover.
class FilledBackground {
  public:
    explicit FilledBackground(BackgroundPart mesh) : mesh_(std::move(mesh)) {}

    /// Sets the spacing outside the mesh: the minimum of `cap` and the sites.
    void fill(double cap, SiteTree sites, std::vector<SiteLabel> labels);

    double at(Vec2 p) const {
        const double rho = mesh_.at(p);
        return rho < std::numeric_limits<double>::infinity() || !sites_ ? rho : std::min(cap_, sites_->at(p));
    }
    double minimum() const { return sites_ ? std::min(mesh_.minimum(), sites_->minimum()) : mesh_.minimum(); }
    double maximum() const {
        return sites_ ? std::max(mesh_.maximum(), cap_) : std::numeric_limits<double>::infinity();
    }
    SpacingSample sample(Vec2 p, const SiteWords &words) const;

  private:
    BackgroundPart mesh_;
    double cap_ = std::numeric_limits<double>::infinity();
    std::optional<SiteTree> sites_;
    std::vector<SiteLabel> labels_;
};

/// The parts that are evaluated point by point, as opposed to by sites. Each has at(p), infinite where the part does
/// not apply, minimum() and maximum() over the domain's box, and sample(p, words). A tuple, so that the compiler
/// inlines all of them into the hot path.
using PointParts = std::tuple<std::optional<ExpressionSpacing>, std::optional<FunctionSpacing>,
                              std::optional<FilledBackground>, std::optional<PaintedPart>, std::optional<RegionPart>,
                              std::optional<GradedSources>, std::optional<BoxSources>>;

/// The ingredients of a combined field. Every part is already clamped and limited, so their minimum is, too.
struct FieldParts {
    double cap = 0.0; ///< constant, maximum or automatic spacing, which makes the result finite everywhere
    SpacingOrigin capOrigin = SpacingOrigin::Constant;
    bool capIsRule = true; ///< false: it only makes the result finite, far above every size
    double minimum = 0.0;
    PointParts points;
    SiteSet few;                  ///< evaluated one by one
    std::optional<SiteTree> tree; ///< of the other sites where there are many
    std::vector<SiteLabel> treeLabels;
    SiteWords words;
    Diagnostics notes; ///< see SpacingField::notes()

    /// Lowers the cap to `size` if that is less.
    void lowerCap(double size, SpacingOrigin origin);
    /// Returns the point part of type `Part`, empty if it is not given.
    template <class Part>
    std::optional<Part> &point() {
        return std::get<std::optional<Part>>(points);
    }
    /// Returns true if any part is evaluated point by point.
    bool anyPoint() const {
        return std::apply([](const auto &...part) { return (part.has_value() || ...); }, points);
    }
};

/// A field that is the minimum of all parts.
class CombinedField final : public SpacingField {
  public:
    /// The bounds are those over `box`.
    CombinedField(FieldParts parts, const Box2 &box);
    double at(Vec2 p) const override { return inlineAt(p); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override;
    SpacingSample sample(Vec2 p) const override;
    double minimum() const override { return minimum_; }
    double maximum() const override { return maximum_; }

  private:
    /// Calls visit(part) for every part evaluated point by point.
    template <class Visit>
    void forPoints(const Visit &visit) const {
        std::apply([&](const auto &...part) { ((part ? visit(*part) : void()), ...); }, parts_.points);
    }
    /// Returns the smallest size at p of all rules but one.
    std::optional<SpacingRunnerUp> runnerUp(Vec2 p, const SiteLabel &winner) const;
    double inlineAt(Vec2 p) const {
        double rho = withoutTree(p);
        if (parts_.tree) {
            rho = std::min(rho, parts_.tree->at(p));
        }
        return std::max(rho, parts_.minimum);
    }
    double withoutTree(Vec2 p) const {
        double rho = withoutTreeAndFunction(p);
        if (const auto &function = std::get<std::optional<FunctionSpacing>>(parts_.points)) {
            rho = std::min(rho, function->at(p));
        }
        return rho;
    }
    double withoutTreeAndFunction(Vec2 p) const {
        double rho = parts_.cap;
        for (const SizeSite &site : parts_.few.sites) {
            rho = std::min(rho, site.at(p));
        }
        forPoints([&]<class Part>(const Part &part) {
            if constexpr (!std::is_same_v<Part, FunctionSpacing>) {
                rho = std::min(rho, part.at(p));
            }
        });
        return rho;
    }

    FieldParts parts_;
    double minimum_ = 0.0;
    double maximum_ = 0.0;
};

} // namespace forefront

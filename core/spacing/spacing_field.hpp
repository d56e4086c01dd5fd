#pragma once

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/spacing/spacing_spec.hpp"

#include <memory>
#include <span>
#include <string>

namespace forefront {

struct Domain;

/// Which part of the specification set the spacing at a point.
enum class SpacingOrigin : std::uint8_t {
    Constant,
    Expression,
    Source,
    Paint,
    Background,
    Boundary,
    Automatic,
    Minimum,
    Maximum,
    Gradation
};

struct SpacingSample {
    double rho = 0.0;
    SpacingOrigin origin = SpacingOrigin::Constant;
    std::uint32_t source = 0; ///< index into SpacingSpec::sources, or of the domain segment, where origin says so
    std::string describe;     ///< in words, such as "source 'pier head'", for the inspector; filled by sample() only
};

/// The node spacing function ρ, ready to be evaluated. Immutable; every const member may be called from many threads at
/// once. Deterministic: the same field gives the same doubles on every call and thread.
class SpacingField {
  public:
    /// Faults: expression-syntax (with column), expression-value (not finite or <= 0 somewhere on a probe lattice, with
    /// a place), bad-size, bad-source, bad-paint, bad-background, cancelled. The domain gives the extent and, for
    /// boundary and automatic spacing, the lengths.
    static Result<std::shared_ptr<const SpacingField>> build(const SpacingSpec &spec, const Domain &domain,
                                                             const Progress &progress = {});
    virtual ~SpacingField() = default;

    /// Node spacing at p: finite and > 0 everywhere, meaningful in the domain's box. Hot path.
    virtual double at(Vec2 p) const = 0;
    virtual void atMany(std::span<const Vec2> points, std::span<double> rho) const = 0;
    /// As at(), and says which part won. Slow; for the inspector.
    virtual SpacingSample sample(Vec2 p) const = 0;
    /// Bounds of ρ over the domain's box as far as known: for legends and estimates.
    virtual double least() const = 0;
    virtual double greatest() const = 0;
};

} // namespace forefront

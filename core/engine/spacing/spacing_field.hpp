#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/spacing_sample.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace FOREFRONT_API forefront {

struct Domain;

/// The treatment of the segments of a domain in its mesh.
enum class GivenSegments : std::uint8_t {
    Divided, ///< as the spacing asks
    Kept     ///< each is one edge, see MeshingOptions::keepBoundary
};

/// The node spacing function ρ, ready to evaluate. Immutable; const members may be called from several threads at once.
/// Deterministic: the same field returns the same doubles on every call and thread.
class SpacingField {
  public:
    /// Builds the field of a specification. The domain supplies the extent, the lengths for boundary and automatic
    /// spacing, and the faces of region sizes (ignored while segments cross). Where segments are divided,
    /// Domain::curveTolerance limits the spacing beside curves. Errors: expression-syntax (with column),
    /// expression-value (with a place), bad-size, bad-source, bad-paint, bad-background, bad-region-area,
    /// bad-element-counts, cancelled.
    static Result<std::shared_ptr<const SpacingField>> build(const SpacingSpec &spec, const Domain &domain,
                                                             const Progress &progress = {},
                                                             GivenSegments segments = GivenSegments::Divided);
    virtual ~SpacingField() = default;

    /// Returns the spacing at p: finite and > 0 everywhere, meaningful in the domain's box. Hot path.
    virtual double at(Vec2 p) const = 0;
    virtual void atMany(std::span<const Vec2> points, std::span<double> rho) const = 0;
    /// Returns at(p) and the part that determined it. Slow; for the inspector.
    virtual SpacingSample sample(Vec2 p) const = 0;
    /// Returns a lower bound of ρ over the domain's box, as tight as is known; for legends and estimates.
    virtual double minimum() const = 0;
    /// Returns an upper bound of ρ over the domain's box.
    virtual double maximum() const = 0;

    /// Returns notes on parts of the specification that are not followed everywhere in the domain, such as a background
    /// mesh that covers only a part of it.
    const Diagnostics &notes() const { return notes_; }
    void addNotes(const Diagnostics &notes) { notes_.insert(notes_.end(), notes.begin(), notes.end()); }
    /// Returns the maximum |∇ρ| of the parts without a growth of their own, > 0: the given one or, if it is absent, the
    /// one chosen for these parts. See SpacingSpec::gradation.
    double gradation() const { return gradation_; }
    void setGradation(double gradation) { gradation_ = gradation; }

  protected:
    /// Takes the notes and the gradation of a field that this one changes in some places.
    void describeAs(const SpacingField &other) {
        addNotes(other.notes());
        setGradation(other.gradation());
    }

  private:
    Diagnostics notes_;
    double gradation_ = kDefaultGradation;
};

} // namespace forefront

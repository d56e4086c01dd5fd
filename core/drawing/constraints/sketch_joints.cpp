#include "core/drawing/constraints/sketch_joints.hpp"

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/drawing/constraints/joint_search.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/equal_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

/// Writes the equations of joints.
class JointWriter {
  public:
    JointWriter(DocumentSketch &sketch, const Document &places, double tolerance)
        : sketch_(sketch), places_(places), tolerance_(tolerance), given_(sketch.system.held) {
        for (const SketchEquation &equation : sketch.system.equations) {
            if (equation.kind == EquationKind::Value) {
                given_[equation.unknowns[0]] = true;
            }
        }
    }

    void write(const SketchPart &node, const SketchPart &other) {
        // A formula does not move what is locked, but formulas of both sides may part them.
        mayPart_ = findShape(places_, node.shape)->locked == findShape(places_, other.shape)->locked;
        const std::vector<SketchEquation> equations = equationsOf(node, other);
        if (equations.empty()) {
            return;
        }
        for (const SketchEquation &equation : equations) {
            sketch_.system.addEquation(equation, sketch_.jointId(sketch_.joints.size()));
        }
        const Shape &shape = *findShape(places_, node.shape);
        sketch_.joints.push_back({node, other,
                                  node.kind == SketchPartKind::Segment ? shape.path().curves[node.index].point(0.5)
                                                                       : handlesOf(shape)[node.index]});
    }

  private:
    std::vector<SketchEquation> equationsOf(const SketchPart &node, const SketchPart &other) {
        if (node.kind == SketchPartKind::Segment) {
            return curveEquations(node, other);
        }
        const SketchPoint p = sketch_.point(node);
        if (other.kind == SketchPartKind::Node) {
            return sameEquations(p, sketch_.point(other));
        }
        const DocumentSketch::Ends line = sketch_.line(other);
        const std::array<std::uint32_t, 6> used = {p.x, p.y, line.a.x, line.a.y, line.b.x, line.b.y};
        const bool given = std::all_of(used.begin(), used.end(), [&](std::uint32_t k) { return given_[k]; });
        return given ? std::vector<SketchEquation>() : std::vector{makePointLine(p, line.a, line.b, 0.0, 1.0)};
    }

    /// Returns the equations of two curves that lie on one another.
    std::vector<SketchEquation> curveEquations(const SketchPart &part, const SketchPart &other) {
        if (formOfPart(sketch_.document(), part) == PartForm::Circle) {
            const DocumentSketch::Round a = sketch_.round(part), b = sketch_.round(other);
            std::vector<SketchEquation> equations = sameEquations(a.centre, b.centre);
            if (!given_[a.radius] || !given_[b.radius]) {
                equations.push_back(makeEqual(a.radius, b.radius));
            }
            return equations;
        }
        const DocumentSketch::Cubic a = sketch_.cubic(part), b = sketch_.cubic(other);
        const Vec2 start = findShape(places_, part.shape)->nodes[part.index];
        const bool along = distance(findShape(places_, other.shape)->nodes[other.index], start) <= tolerance_;
        std::vector<SketchEquation> equations = sameEquations(a.startOffset, along ? b.startOffset : b.endOffset);
        for (const SketchEquation &equation : sameEquations(a.endOffset, along ? b.endOffset : b.startOffset)) {
            equations.push_back(equation);
        }
        return equations;
    }

    std::vector<SketchEquation> sameEquations(SketchPoint p, SketchPoint q) const {
        std::vector<SketchEquation> equations;
        for (const auto &[a, b] : {std::pair(p.x, q.x), std::pair(p.y, q.y)}) {
            if (a == b) {
                continue;
            }
            const bool apart = std::fabs(sketch_.system.values[a] - sketch_.system.values[b]) > tolerance_;
            const bool given = given_[a] && given_[b];
            if (given && apart && mayPart_) {
                return {};
            }
            if (!given || apart) {
                equations.push_back(makeEqual(a, b));
            }
        }
        return equations;
    }

    DocumentSketch &sketch_;
    const Document &places_;
    double tolerance_;
    bool mayPart_ = true;
    std::vector<bool> given_; ///< unknowns whose values formulas, locks or constraints give
};

} // namespace

void alignJoints(const DocumentSketch &sketch, std::span<const std::uint32_t> equations, std::vector<double> &values,
                 const std::function<int(std::uint32_t)> &rank) {
    const SketchSystem &system = sketch.system;
    equaliseValues(system, equations, values, rank);
    std::set<std::uint32_t> aligned;
    for (const std::uint32_t k : equations) {
        const SketchEquation &equation = system.equations[k];
        if (equation.kind != EquationKind::PointLine || equation.constraint < sketch.jointId(0)) {
            continue;
        }
        const auto &u = equation.unknowns; // x and y of the node and of the ends of the side
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (values[u[2 + axis]] == values[u[4 + axis]] && !system.held[u[axis]]) {
                values[u[axis]] = values[u[2 + axis]];
                aligned.insert(u[axis]);
            }
        }
    }
    equaliseValues(system, equations, values,
                   [&](std::uint32_t unknown) { return aligned.contains(unknown) ? 0 : rank(unknown); });
}

JointFinder::JointFinder(DocumentSketch &sketch, const JointSource &source) : sketch_(sketch), source_(source) {}

void JointFinder::find() {
    if (source_.places == nullptr || sketch_.unknowns().size() == known_) {
        return;
    }
    JointSearch search(sketch_.document(), source_);
    for (const auto &[unknown, index] : sketch_.unknowns()) {
        if (unknown.role <= Role::Y) {
            search.addNode({unknown.shape, unknown.index});
        } else if (unknown.role == Role::CentreX || unknown.role == Role::StartX) {
            search.addCurve({unknown.shape, SketchPartKind::Segment, unknown.index});
        }
    }
    search.run();
    for (const JointSearch::Found &part : search.parts()) {
        const std::size_t before = sketch_.system.values.size();
        sketch_.unknownsOf(part.part);
        for (std::size_t k = before; part.standing && k < sketch_.system.values.size(); ++k) {
            sketch_.standing.push_back(static_cast<std::uint32_t>(k));
        }
    }
    joints_ = search.joints();
    known_ = sketch_.unknowns().size();
}

void JointFinder::write() {
    if (source_.places == nullptr) {
        return;
    }
    sketch_.system.firstJoint = sketch_.jointId(0);
    JointWriter writer(sketch_, *source_.places, samePlaceDistance(*source_.places));
    for (const auto &[node, other] : joints_) {
        writer.write(node, other);
    }
}

} // namespace forefront
